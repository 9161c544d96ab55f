#include "samples/stress/run.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/script_host.h"
#include "samples/stress/checks/check.h"
#include "samples/stress/processor_time.h"
#include "samples/stress/results.h"
#include "samples/stress/scene_functions.h"

namespace stress {
namespace {

using rubble::script::sized;

/// Scenarios count what they do by themselves: what stops a script that hangs need not be small.
constexpr int64_t kScriptWork = 50'000'000;

constexpr uint32_t kWorldFlags =
    RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_DATA | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_WAIT_FOR_SHADOW;

/// With threads: the shadow worker works while the next steps are made.
constexpr uint32_t kThreadedFlags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_DATA;

/// Steps of a world beside a copy of it. With threads the shadow volume is some steps behind, and more are compared.
constexpr int kStepsBesideCopy = 1, kStepsBesideThreaded = 3;

/// Steps between looks at the heap: malloc counts all free blocks for that.
constexpr uint64_t kHeapInterval = 15;

class Run {
public:
    Run(const rubble_api& api, const RunSettings& settings)
        : m_api(api), m_settings(settings), m_view{api, 0, {}, {}, {}, m_requests, 0, {}} {}
    ~Run() {
        m_scripts.reset();
        if (m_world) m_api.destroy_world(m_world);
        std::error_code ignored;
        std::filesystem::remove(recordingPath(), ignored);
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    RunResult play() {
        if (begin())
            for (int step = 0; step < m_settings.steps && !m_result.failure && !isInterrupted(); ++step) oneStep(step);
        if (!m_result.failure && m_isLoaded) stepAlone();
        if (!m_result.failure) endRecording();
        if (!m_result.failure) checkAll();
        if (!m_result.failure) endScripts();
        if (m_world && m_result.failure) keepLastGame();
        if (m_world) m_api.get_state_hash(m_world, &m_result.hash);
        m_result.seconds = m_time.seconds();
        return std::move(m_result);
    }

private:
    /// With the seed: runs of several seeds may share a folder at the same time.
    std::string recordingPath() const { return resultPath(m_settings, ".rubblelog"); }

    bool isInterrupted() { return m_result.isInterrupted = m_settings.isInterrupted && m_settings.isInterrupted(); }

    void fail(const std::string& check, const std::string& message) {
        if (m_result.failure) return;
        m_result.failure = Failure{check, message, int(m_view.step)};
        if (m_settings.onFailure) m_settings.onFailure(message);
    }
    /// Whether a call of the interface has done what it should; if not, the run fails.
    bool done(rubble_result result) {
        if (result != RUBBLE_OK) fail("interface", m_api.get_last_error());
        return result == RUBBLE_OK;
    }

    bool begin() {
        auto world = sized<rubble_world_settings>();
        world.flags = m_settings.hasThreads ? kThreadedFlags : kWorldFlags;
        world.physics_threads = m_settings.hasThreads ? 2 : 1;
        if (m_settings.isQuiet) world.log = saysNothing;
        if (!done(m_api.create_world(&world, &m_world)) || !done(m_api.step(m_world))) return false;
        m_view.world = m_world;
        rubble::script::ScriptHostSettings host;
        host.limits.work = kScriptWork;
        host.limits.memory = 64 << 20;
        host.limits.processorSeconds = 10.0;
        host.limits.seed = m_settings.seed;
        host.functions = sceneFunctions();
        host.host = &m_requests;
        host.observer = m_settings.observer;
        host.log = [this](int level, const std::string& line) {
            if (!m_settings.isQuiet) fmt::print(stderr, "{}\n", line);
            if (level >= RUBBLE_LOG_ERROR) fail("script", line);
        };
        m_scripts = std::make_unique<rubble::script::ScriptHost>(m_api, m_world, host);
        m_scripts->add(m_settings.name + ".lua", m_settings.script,
                       {{"seed", std::to_string(m_settings.seed)}, {"steps", std::to_string(m_settings.steps)}});
        return record();
    }

    /// Calls destroy(), in which an error and what does not hold fail the run, as anywhere else.
    void endScripts() {
        m_scripts.reset();
        if (!m_requests.unmet.empty()) fail("expect", m_requests.unmet);
    }

    void oneStep(int step) {
        m_time.enter("steps");
        m_scripts->tick(1.0 / 60.0);
        if (!done(m_scripts->step())) return;
        if (m_view.step++ % kHeapInterval == 0) measureHeap();
        readStep();
        look(&Check::afterStep);
        if (m_result.failure) return;
        if (!m_requests.unmet.empty()) return fail("expect", m_requests.unmet);
        if (!m_requests.waiting.empty())
            carryOut();
        else if (m_view.step >= m_nextCheck)
            checkBetween();
        if (m_settings.onStep) m_settings.onStep(step + 1);
    }

    /// Every second check leaves the recording that runs as it is, so that an undo reaches over it: one that begins
    /// drops the marks.
    void checkBetween() {
        const bool endsRecording = std::exchange(m_isSecondCheck, true);
        m_scripts->beforeEdits();
        endsRecording ? endRecording() : finishUndo();
        if (!m_result.failure) checkAll();
        if (m_result.failure || (endsRecording && !record())) return;
        m_scripts->afterEdits();  // of the step that the check has made, for which scripts may wait
        m_scripts->readEvents();
        m_scripts->resumeWaiting();
    }

    /// What the step has left, for checks and figures.
    void readStep() {
        m_time.enter("figures");
        m_isLoaded = false;
        m_view.before.swap(m_view.bodies);
        m_view.events = sized<rubble_events>();
        m_api.get_events(m_world, &m_view.events);
        const auto states =
            readRows<rubble_body_state>([&](rubble_body_state* out, uint32_t capacity, uint32_t* count) {
                return m_api.get_body_states(m_world, out, capacity, count);
            });
        m_view.bodies.clear();
        for (const rubble_body_state& state : states) {
            BodyRow row{state, sized<rubble_body_properties>()};
            if (row.isDynamic()) m_api.get_body_properties(m_world, state.body, &row.properties);
            m_view.bodies.push_back(row);
        }
        std::sort(m_view.bodies.begin(), m_view.bodies.end(),
                  [](const BodyRow& a, const BodyRow& b) { return a.state.body < b.state.body; });
        measure();
    }

    void measure() {
        auto stats = sized<rubble_step_stats>();
        auto accounting = sized<rubble_voxel_accounting>();
        m_api.get_step_stats(m_world, &stats);
        m_api.get_voxel_accounting(m_world, &accounting);
        double energy = 0.0;
        for (const BodyRow& body : m_view.bodies) {
            const auto velocity = rubble::script::vectorOf(body.state.velocity);
            if (body.isDynamic()) energy += 0.5 * body.properties.mass * rubble::script::dot(velocity, velocity);
        }
        m_result.steps.push_back({float(stats.edits_ms), float(stats.physics_ms), float(stats.poses_ms),
                                  float(stats.impacts_ms), float(stats.shadow_ms), stats.bodies, stats.bodies_awake,
                                  stats.contacts, uint32_t(stats.shadow_lag), accounting.standing, accounting.in_pieces,
                                  accounting.removed, energy, m_heap});
    }

    /// Of the world with its scripts: there is no copy of it now.
    void measureHeap() {
        const uint64_t held = bytesOf(m_result) + blockBytes(m_view.game.data());
        m_heap = heapBytes() - held - (m_settings.heldBytes ? m_settings.heldBytes() : 0);
    }

    /// A step without scripts.
    void stepAlone() {
        if (!done(m_api.step(m_world))) return;
        ++m_requests.extraSteps;
        readStep();
        look(&Check::afterStep);
    }

    /// Makes the step that an undo waits for: with it no game can be saved.
    void finishUndo() {
        if (std::exchange(m_requests.undoWaits, false)) stepAlone();
    }

    bool record() {
        m_isSecondCheck = false;
        m_time.enter("replay");
        return done(m_api.start_recording(m_world, recordingPath().c_str()));
    }

    /// The end of a recording: it is played again.
    void endRecording() {
        uint64_t hash = 0;
        finishUndo();
        m_time.enter("replay");
        if (!done(m_api.stop_recording(m_world)) || !done(m_api.get_state_hash(m_world, &hash))) return;
        if (m_settings.replayEvery && m_recordings++ % m_settings.replayEvery == 0) replay(hash);
    }

    /// Looks at all that takes long.
    void checkAll() {
        m_nextCheck = m_view.step + uint64_t(m_settings.checkInterval);
        m_time.enter("save");
        m_view.game = savedGame(m_api, m_world);
        if (m_view.game.empty()) return fail("save", m_api.get_last_error());
        keepGame();
        look(&Check::atBorder);
        if (!m_result.failure) stepBesideCopy();
    }

    /// Keeps games at about equal distances, the last one at the end. A game goes on as if it had been loaded after
    /// each save: so none is saved for images alone, and a run is the same with and without them.
    void keepGame() {
        const uint64_t due = m_view.step * uint64_t(m_settings.images) / uint64_t(m_settings.steps);
        if (due > m_result.games.size()) m_result.games.push_back(m_view.game);
    }

    /// Of a run that has failed the last image shows where.
    void keepLastGame() {
        std::vector<uint8_t> game = m_settings.images > 0 ? savedGame(m_api, m_world) : std::vector<uint8_t>();
        if (game.empty()) return;  // none are wanted, or the world cannot be saved
        if (m_result.games.size() >= size_t(m_settings.images)) m_result.games.pop_back();
        m_result.games.push_back(std::move(game));
    }

    /// Loads the game into another world, and steps both: they must stay equal.
    void stepBesideCopy() {
        m_time.enter("save");
        const LoadedCopy copy(m_api, m_view.game, kWorldFlags);
        if (!copy.error().empty()) return fail("save", copy.error());
        const int steps = m_settings.hasThreads ? kStepsBesideThreaded : kStepsBesideCopy;
        for (int i = 0; i < steps && !m_result.failure; ++i) stepBoth(copy.world());
    }

    void stepBoth(rubble_world copy) {
        uint64_t hash = 0, copied = 0;
        if (!done(m_api.step(m_world)) || !done(m_api.step(copy))) return;
        ++m_requests.extraSteps;
        readStep();
        look(&Check::afterStep);
        m_api.get_state_hash(m_world, &hash);
        m_api.get_state_hash(copy, &copied);
        if (hash != copied) fail("save", "a loaded game has another hash after a step than the one that went on");
        for (const auto& check : m_checks) {
            m_time.enter(check->name());
            if (std::string wrong = check->besideCopy(m_view, copy); !wrong.empty()) return fail(check->name(), wrong);
        }
        m_time.enter("save");
    }

    void look(std::string (Check::*at)(const StepView&)) {
        for (const auto& check : m_checks) {
            m_time.enter(check->name());
            if (std::string wrong = (*check.*at)(m_view); !wrong.empty()) return fail(check->name(), wrong);
        }
        std::erase_if(m_requests.holes,
                      [&](const SceneRequests::Hole& hole) { return hole.step <= m_view.worldSteps(); });
    }

    void replay(uint64_t expected) {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        settings.physics_threads = 2;
        settings.log = saysNothing;
        rubble_world world = 0;
        uint64_t steps = 0, hash = 0;
        if (!done(m_api.create_world(&settings, &world))) return;
        if (m_api.play_recording(world, recordingPath().c_str(), &steps) != RUBBLE_OK)
            fail("replay", m_api.get_last_error());
        m_api.get_state_hash(world, &hash);
        if (hash != expected)
            fail("replay", fmt::format("the hash of the state is {:x}, played again {:x}", expected, hash));
        m_result.replayed += int(steps);
        m_api.destroy_world(world);
    }

    /// What the scenario has asked for: loading ends a recording, another one begins after it.
    void carryOut() {
        std::vector<SceneRequests::Request> waiting;
        waiting.swap(m_requests.waiting);
        endRecording();
        if (!m_result.failure && m_view.step >= m_nextCheck) checkAll();
        m_time.enter("steps");
        for (const SceneRequests::Request& request : waiting) {
            if (m_result.failure) return;
            if (request.kind == SceneRequests::SaveAndLoad)
                saveAndLoad();
            else
                done(m_api.load_level(m_world, (m_settings.levels + "/" + request.level + ".rubble").c_str(), nullptr));
            ++m_result.loads;
        }
        for (const auto& check : m_checks) check->restart();
        m_view.bodies.clear();
        m_isLoaded = true;
        if (!m_result.failure) record();
    }

    void saveAndLoad() {
        uint64_t before = 0, after = 0;
        const std::vector<uint8_t> game = savedGame(m_api, m_world);
        m_api.get_state_hash(m_world, &before);
        if (!done(m_api.load_game_data(m_world, game.data(), game.size()))) return;
        m_api.get_state_hash(m_world, &after);
        if (before != after) fail("save", "a loaded game has another hash than the one that was saved");
    }

    const rubble_api& m_api;
    const RunSettings& m_settings;
    SceneRequests m_requests;
    StepView m_view;
    rubble_world m_world = 0;
    std::unique_ptr<rubble::script::ScriptHost> m_scripts;
    std::vector<std::unique_ptr<Check>> m_checks = makeChecks();
    RunResult m_result;
    uint64_t m_heap = 0;  ///< bytes in use when it was last looked at
    ProcessorTime m_time;
    int m_recordings = 0;          ///< that have ended
    bool m_isLoaded = false;       ///< and no step was made since: the view has nothing of what was loaded
    bool m_isSecondCheck = false;  ///< whether the next check is that of the recording
    uint64_t m_nextCheck = uint64_t(m_settings.checkInterval);  ///< a step of the scenario
};

}  // namespace

RunResult play(const rubble_api& api, const RunSettings& settings) {
    return Run(api, settings).play();
}

uint64_t heapBytes() {
    const struct mallinfo2 memory = mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

uint64_t blockBytes(const void* block) {
    return block ? malloc_usable_size(const_cast<void*>(block)) + sizeof(size_t) : 0;
}

uint64_t bytesOf(const RunResult& result) {
    uint64_t bytes = blockBytes(result.steps.data()) + blockBytes(result.games.data());
    for (const auto& game : result.games) bytes += blockBytes(game.data());
    return bytes;
}

}  // namespace stress
