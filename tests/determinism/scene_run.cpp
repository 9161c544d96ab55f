#include "tests/determinism/scene_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "render/gl/offscreen.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/town.h"
#include "samples/support/gl_context.h"

namespace rubble {
namespace {

Level levelOf(const SceneRun& options) {
    const Scene* scene = findScene(options.scene);
    return scene ? scene->level(1) : makeTown(1);
}

Edits scriptOf(const SceneRun& options, int step) {
    const Scene* scene = findScene(options.scene);
    return scene ? scene->script(step, 1) : demolition(step, 1);
}

std::unique_ptr<FrameLoop> makeLoop(const SceneRun& options) {
    FrameLoopSettings settings;
    settings.physicsThreads = options.threads;
    settings.shadow = options.threads > 1 ? ShadowWorker::Mode::Thread : ShadowWorker::Mode::Inline;
    settings.shadowVolume = settings.publish = options.renderer || options.threads > 1;
    auto loop = std::make_unique<FrameLoop>(settings);
    if (const Scene* scene = findScene(options.scene)) loop->world().setSettings(scene->settings);
    return loop;
}

/// Draws every step at 64x36.
class OffscreenRenderer {
public:
    static Result<std::unique_ptr<OffscreenRenderer>> create(const SceneRun& options) {
        auto offscreen = std::make_unique<OffscreenRenderer>();
        auto context = GlContext::create();
        if (!context) return Error{context.error()};
        offscreen->m_context = std::move(*context);
        auto renderer =
            Renderer::create(offscreen->m_context->loader(), options.shaders, RenderSettings::preset("fast"));
        if (!renderer) return Error{renderer.error()};
        offscreen->m_renderer = std::move(*renderer);
        offscreen->m_target = std::make_unique<Offscreen>(glm::ivec2(64, 36));
        return offscreen;
    }
    void draw(FrameLoop& loop, const SceneRun& options, int step) {
        View view;
        const Scene* scene = findScene(options.scene);
        const Pose camera = scene ? scene->camera(step / 60.0) : demolitionCamera(step / 60.0);
        view.position = camera.position;
        view.rotation = camera.rotation;
        view.size = {64, 36};
        view.framebuffer = m_target->framebuffer();
        loop.draw(*m_renderer, view, 1.0f);
    }

private:
    std::unique_ptr<GlContext> m_context;  // declared first: what draws with it is destroyed before it
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_target;
};

/// A path in the folder of temporary files; the destructor removes the file.
class TemporaryFile {
public:
    explicit TemporaryFile(const char* ending) {
        static std::atomic<int> count = 0;
        m_path =
            (std::filesystem::temp_directory_path() / fmt::format("rubble_hash_{}_{}.{}", getpid(), ++count, ending))
                .string();
    }
    ~TemporaryFile() { std::remove(m_path.c_str()); }
    const std::string& path() const { return m_path; }

private:
    std::string m_path;
};

/// All modes save half-way, because saving has side effects on the world; "load" continues in a new world from the
/// file.
Result<Hashes> play(const SceneRun& options, OffscreenRenderer* offscreen, const std::string& recordTo) {
    auto loop = makeLoop(options);
    loop->load(levelOf(options));
    if (!recordTo.empty())
        if (Result<Done> started = loop->startRecording(recordTo); !started) return Error{started.error()};
    Hashes hashes;
    for (int step = 0; step < options.steps; ++step) {
        if (step == options.steps / 2) {
            const SavedGame saved = loop->save();
            if (options.mode == "load") {
                const TemporaryFile file("rubble");
                if (Result<Done> written = writeSave(file.path(), saved); !written) return Error{written.error()};
                auto next = makeLoop(options);
                Result<SavedGame> game = readSave(file.path(), next->world().id());
                if (!game) return Error{game.error()};
                next->load(std::move(*game));
                loop = std::move(next);
                offscreen = nullptr;  // a renderer belongs to one world
            }
        }
        loop->edits().push(scriptOf(options, step));
        loop->step();
        if (offscreen) offscreen->draw(*loop, options, step);
        if ((step + 1) % options.every == 0) hashes.push_back(loop->world().hash());
    }
    if (Result<Done> stopped = loop->stopRecording(); !stopped) return Error{stopped.error()};
    return hashes;
}

/// Replays a recording twice at once: from the edits with physics, and from the resolved edits and poses alone. Each
/// step must give the recorded hashes.
Result<Hashes> replay(const SceneRun& options, const std::string& path) {
    auto loop = makeLoop(options);
    Result<Recording> recording = readRecording(path, loop->world().id());
    if (!recording) return Error{recording.error()};
    World follower(loop->world().id());
    follower.setState(recording->start.world);
    loop->load(recording->start);
    std::vector<PaletteRef> palettes;
    Hashes hashes;
    for (const RecordedStep& step : recording->steps) {
        loop->replay(step);
        const Result<FrameChanges> applied = applyStepDelta(step.delta, path, follower, palettes);
        if (!applied) return Error{applied.error()};
        if (voxelHash(follower) != step.voxelHash)
            return Error{fmt::format("step {}: the resolved edits give other voxels than were recorded", step.step)};
        follower.setPoses(step.poses);
        if (resolvedHash(follower) != step.resolvedHash)
            return Error{
                fmt::format("step {}: the resolved edits and poses give another world than was recorded", step.step)};
        if (loop->world().hash() != step.hash)
            return Error{fmt::format("step {}: the replay gives another state hash than was recorded", step.step)};
        if (step.step % uint64_t(options.every) == 0) hashes.push_back(step.hash);
    }
    return hashes;
}

Result<Hashes> run(const SceneRun& options) {
    std::unique_ptr<OffscreenRenderer> offscreen;
    if (options.renderer) {
        Result<std::unique_ptr<OffscreenRenderer>> made = OffscreenRenderer::create(options);
        if (!made) return Error{made.error()};
        offscreen = std::move(*made);
    }
    if (options.mode != "replay") return play(options, offscreen.get(), "");
    const TemporaryFile file("rubblelog");
    Result<Hashes> played = play(options, offscreen.get(), file.path());
    if (!played) return played;
    Result<Hashes> replayed = replay(options, file.path());
    if (replayed && *replayed != *played) return Error{"the replay gives other hashes than the run that it recorded"};
    return replayed;
}

}  // namespace

bool sceneExists(const std::string& name) {
    return name == "town" || findScene(name);
}

Result<Hashes> runScene(const SceneRun& options) {
    std::vector<Result<Hashes>> others(size_t(std::max(0, options.threads - 2)), Error{"not run"});
    std::vector<std::thread> threads;
    SceneRun plain = options;
    plain.renderer = false;
    for (Result<Hashes>& other : others) threads.emplace_back([&other, &plain] { other = run(plain); });
    Result<Hashes> hashes = run(options);
    for (std::thread& thread : threads) thread.join();
    for (Result<Hashes>& other : others)
        if (hashes && (!other || *other != *hashes)) return Error{"a world on another thread gives other hashes"};
    return hashes;
}

}  // namespace rubble
