#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "render/frame/frame_camera.h"
#include "render/frame/frame_context.h"
#include "render/gl/pass_timer.h"
#include "render/gl/state_guard.h"
#include "render/passes/accumulate_pass.h"
#include "render/passes/bloom_pass.h"
#include "render/passes/composite_pass.h"
#include "render/passes/exposure_pass.h"
#include "render/passes/filter_pass.h"
#include "render/passes/fog_pass.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/glare_pass.h"
#include "render/passes/glass_pass.h"
#include "render/passes/glass_shadow_pass.h"
#include "render/passes/local_lights_pass.h"
#include "render/passes/particles_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/passes/ropes_pass.h"
#include "render/passes/show_pass.h"
#include "render/passes/sky_pass.h"
#include "render/passes/sun_pass.h"
#include "render/passes/taa_pass.h"
#include "render/passes/tonemap_pass.h"
#include "render/passes/water_pass.h"
#include "render/passes/wetness_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"
#include "render/shader_library/fullscreen_choice.h"
#include "runtime/core/blue_noise.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

/// The intermediate targets that can be shown, and how.
struct TargetView {
    const char* name;
    const char* target;
    ShowPass::Mode mode;
};
using enum ShowPass::Mode;
constexpr TargetView kTargetViews[] = {
    {"final", "final", Color},
    {"albedo", "albedo", Color},
    {"normal", "normal", Signed},
    {"emission", "normal", Alpha},
    {"material", "material", Color},
    {"motion", "motion", Motion},
    {"depth", "depth", Distance},
    {"glassTint", "glassTint", Color},
    {"glassSurface", "glassSurface", Signed},
    {"noisySun", "noisyLight", Alpha},
    {"noisySky", "noisyLight", Linear},
    {"hitProximity", "hitProximity", Color},
    {"sun", "denoisedLight", Alpha},
    {"denoisedLight", "denoisedLight", Linear},
    {"history", "surface", History},
    {"reflection", "reflection", Linear},
    {"radiance", "radiance", Linear},
    {"resolved", "resolved", Linear},
    {"bloom", "bloom0", Linear},
};

/// What a context can do, and what is worth while on it: on llvmpipe passes take 0.97 to 3.4 times as long by compute,
/// the whole frame 1.24 to 1.34 times, so software renderers do not even build it.
Fullscreen possible(Fullscreen wanted) {
    if (wanted == Fullscreen::Auto) return hasCompute() && !isSoftwareGl() ? Fullscreen::Fastest : Fullscreen::Fragment;
    if (wanted == Fullscreen::Fragment || hasCompute()) return wanted;
    logWarning("RenderSettings::fullscreen: compute programs need GL 4.3 or newer, found older: fragments draw");
    return Fullscreen::Fragment;
}

ShaderLibrary::Fullscreen libraryMode(Fullscreen drawn) {
    if (drawn == Fullscreen::Fastest) return ShaderLibrary::Fullscreen::Both;
    return drawn == Fullscreen::Compute ? ShaderLibrary::Fullscreen::Compute : ShaderLibrary::Fullscreen::Fragment;
}

FullscreenChoice initialChoice(Fullscreen drawn) {
    if (drawn == Fullscreen::Fastest) return FullscreenChoice::fastest();
    return FullscreenChoice(drawn == Fullscreen::Compute ? FullscreenMethod::Compute : FullscreenMethod::Fragment);
}

}  // namespace

struct Renderer::Impl {
    Impl(const std::string& shaderFolder, const RenderSettings& given)
        : settings(given), shaders(shaderFolder, libraryMode(fullscreen)) {
        scene.setUploadBudget(given.uploadBudget);
        scene.setBounceColors(given.sky && given.bounce && given.bounceColors);
        blueNoise = Texture(GL_R8, glm::ivec2(kBlueNoiseSize), Filter::Nearest, Wrap::Repeat);
        blueNoise.upload(makeBlueNoise().data());
    }

    /// The frame: each pass reads what those above it have drawn.
    void drawPasses(const FrameContext& frame) {
        run("gbuffer", [&] { gbuffer.draw(frame); });
        if (!scene.ropes().empty()) run("ropes", [&] { drawLazily(ropes, frame, stepAlpha); });
        if (scene.environment().wetness > 0.0f) run("wetness", [&] { drawLazily(wetness, frame); });
        if (scene.hasGlass()) run("glass", [&] { glass.draw(frame, gbuffer.tiles()); });
        if (isGlassSunlit()) run("glass shadow", [&] { drawLazily(glassShadow, frame); });
        clearNoisyLight(frame);
        if (settings.sun && block.sunDirection.y > 0.0f) run("sun", [&] { sun.draw(frame); });
        if (settings.sky) run("sky", [&] { sky.draw(frame); });
        if (LocalLightsPass::needed(frame)) run("local lights", [&] { drawLazily(localLights, frame); });
        run("accumulate", [&] { accumulate.draw(frame); });
        run("filter", [&] { filter.draw(frame); });
        if (ReflectionsPass::needed(frame)) run("reflections", [&] { reflections.draw(frame); });
        run("composite", [&] { composite.draw(frame, isGlassSunlit() ? &*glassShadow : nullptr); });
        if (!scene.waters().empty()) run("water", [&] { drawLazily(water, frame); });
        if (scene.hasGlass()) run("glass composite", [&] { glass.drawOver(frame, gbuffer.tiles()); });
        if (FogPass::needed(frame)) run("fog", [&] { drawLazily(fog, frame); });
        if (!scene.particles().empty()) run("particles", [&] { drawLazily(particles, frame, stepAlpha); });
        if (settings.glare && LocalLightsPass::needed(frame) && !lightGrid->empty())
            run("glare", [&] { drawLazily(glare, frame); });
        run("taa", [&] { taa.draw(frame); });
        if (settings.bloom > 0.0f) run("bloom", [&] { bloom.draw(frame); });
        run("exposure", [&] { exposure.draw(frame); });
        run("tonemap", [&] { tonemap.draw(frame); });
    }

    /// Passes of what most scenes never have: made with the first frame that needs them.
    template <class Pass, class... Rest>
    void drawLazily(std::optional<Pass>& pass, const FrameContext& frame, Rest... rest) {
        if (!pass) pass.emplace(shaders);
        pass->draw(frame, rest...);
    }

    bool isGlassSunlit() const { return settings.sun && block.sunDirection.y > 0.0f && scene.hasGlass(); }

    /// Passes add to it, each in its own channels.
    void clearNoisyLight(const FrameContext& frame) {
        frame.targets.framebuffer({&frame.targets.target("noisyLight", GL_RGBA16F)}).begin();
        const float none[4] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, none);
    }

    template <class F>
    void run(const char* name, F&& draw) {
        timer.begin(name);
        choice.beginPass(name);
        draw();
        timer.end(figures.passMs);
        if (choice.hasDrawnByCompute()) figures.computePasses.push_back(name);
    }
    void beginTimes();
    void draw(const View& view, float alpha);
    void drawOnce(const View& view);
    void drawSmallerOnFailure(const View& view);
    glm::vec4 dot() const;
    void fillBlock(const View& view, glm::ivec2 traced);
    const Texture* find(std::string_view target) const;
    void uploadBlock();
    const LightGrid* updateLightGrid();

    RenderSettings settings;
    Fullscreen fullscreen = possible(settings.fullscreen);
    ShaderLibrary shaders;
    FullscreenChoice choice = initialChoice(fullscreen);
    Scene scene;
    TargetPool targets, pictures;  ///< as in FrameContext
    FrameCamera camera;
    FrameBlock block{};
    GlName<BufferKind> blockBuffer = GlName<BufferKind>::make();
    VertexArray emptyVertexArray = VertexArray::make();
    Texture blueNoise;
    PassTimer timer{isSoftwareGl(), settings.processorTime};
    RenderFigures figures;
    bool hasDrawn = false;
    float stepAlpha = 1.0f;  ///< of the frame being drawn
    const TargetView* shown = &kTargetViews[0];
    int downscale = 0;  ///< of the view's size, where the GL cannot do more
    std::string lastError;
    std::chrono::steady_clock::time_point reloaded{};

    GBufferPass gbuffer{shaders};
    GlassPass glass{shaders};
    SunPass sun{shaders};
    SkyPass sky{shaders};
    std::optional<LightGrid> lightGrid;
    std::optional<LocalLightsPass> localLights;
    AccumulatePass accumulate{shaders};
    FilterPass filter{shaders};
    ReflectionsPass reflections{shaders};
    CompositePass composite{shaders};
    std::optional<GlassShadowPass> glassShadow;
    std::optional<WetnessPass> wetness;
    std::optional<WaterPass> water;
    std::optional<FogPass> fog;
    std::optional<GlarePass> glare;
    std::optional<ParticlesPass> particles;
    std::optional<RopesPass> ropes;
    TaaPass taa{shaders};
    BloomPass bloom{shaders};
    ExposurePass exposure{shaders};
    TonemapPass tonemap{shaders};
    ShowPass show{shaders};
};

void Renderer::Impl::fillBlock(const View& view, glm::ivec2 traced) {
    camera.begin(view, traced, settings.temporal, scene.origin(), block);
    const Environment& e = scene.environment();
    block.counters.z = int(scene.lights().size());
    block.counters.w = settings.noise == Noise::White;
    block.sunDirection = glm::vec4(glm::normalize(e.sunDirection), e.sunAngle);
    block.sunColor = glm::vec4(e.sunColor, 0.0f);
    block.skyColor = glm::vec4(e.skyColor, 0.0f);
    block.horizonColor = glm::vec4(e.horizonColor, 0.0f);
    block.groundColor = glm::vec4(e.groundColor, e.wetness > 0.0f ? std::min(e.wetness, 1.0f) : 0.0f);
    block.fogColor = glm::vec4(e.fogColor, e.fogDistance);
    block.fog = glm::vec4(e.fogDensity, float(double(e.fogBase) - scene.origin().y), std::max(e.fogHeight, 0.1f),
                          std::clamp(e.fogForward, -0.9f, 0.9f));
    block.fogTint = glm::vec4(e.fogTint, 0.0f);
    block.skyCover = glm::vec4(e.clouds, e.stars, 0.0f, 0.0f);
    block.exposure = glm::vec4(e.exposure);
    scene.describeShadow(block);
}

const LightGrid* Renderer::Impl::updateLightGrid() {
    if (scene.lights().empty() && !lightGrid) return nullptr;
    if (!lightGrid) lightGrid.emplace();
    figures.uploadBytes += lightGrid->update(scene.lights(), block, scene.origin());
    return &*lightGrid;
}

void Renderer::Impl::uploadBlock() {
    glBindBuffer(GL_UNIFORM_BUFFER, blockBuffer.get());
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, blockBuffer.get());
}

constexpr int kMaxDownscale = 6;

/// How often a size must be halved to fit what the GL can draw into.
int downscaleFor(glm::ivec2 size) {
    GLint side = 0, viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const glm::ivec2 most(std::min(side, viewport[0]), std::min(side, viewport[1]));
    int downscale = 0;
    while (downscale < kMaxDownscale && ((size.x >> downscale) > most.x || (size.y >> downscale) > most.y)) ++downscale;
    return downscale;
}

void Renderer::Impl::draw(const View& view, float alpha) {
    if (view.size.x <= 0 || view.size.y <= 0) return;
    if (isContextLost()) {
        if (lastError.empty())
            logError(lastError = "the GL context was lost: destroy this renderer, make a context and a new one");
        return;
    }
    lastError.clear();
    const GlStateGuard hostState;
    downscale = std::max(downscale, downscaleFor(view.size));
    figures.uploadBytes = scene.beginFrame(alpha, view.position);
    stepAlpha = alpha;
    const bool fresh = view.cut || !hasDrawn;
    hasDrawn = true;
    View each = view;
    for (int i = fresh ? settings.warmUpFrames : 0; i >= 0; --i) {
        drawOnce(each);
        each.cut = false;
    }
    drawSmallerOnFailure(view);
    scene.endFrame();
    figures.textureBytes = targets.bytes() + pictures.bytes() + scene.bytes() + gbuffer.bytes() + blueNoise.bytes() +
                           (lightGrid ? lightGrid->bytes() : 0);
    figures.computePrograms = shaders.computePrograms();
    figures.waitingBytes = scene.bodies().waitingBytes();
    figures.shapes = scene.bodies().shapes();
    figures.bricks = scene.bodies().bricks();
}

void Renderer::Impl::drawSmallerOnFailure(const View& view) {
    while (targets.allocationFailed() || pictures.allocationFailed()) {
        if (downscale == kMaxDownscale) {
            logError(lastError = "the GL refuses every size of targets to draw into: is it out of memory?");
            return;
        }
        ++downscale;
        logWarning("the GL refuses targets for a view of " + std::to_string(view.size.x) + "x" +
                   std::to_string(view.size.y) + ": drawn at 1/" + std::to_string(1 << downscale) + " of it");
        targets.clear();
        pictures.clear();
        drawOnce(view);
    }
}

/// Red while shaders do not build, green for a second after they were reloaded.
glm::vec4 Renderer::Impl::dot() const {
    if (!shaders.errors().empty()) return {0.9f, 0.1f, 0.05f, 1.0f};
    const bool justNow = std::chrono::steady_clock::now() - reloaded < std::chrono::seconds(1);
    return justNow ? glm::vec4(0.1f, 0.8f, 0.2f, 1.0f) : glm::vec4(0.0f);
}

const Texture* Renderer::Impl::find(std::string_view target) const {
    const Texture* found = targets.find(target);
    return found ? found : pictures.find(target);
}

/// A scale that is none counts as 1.
glm::ivec2 tracedSize(glm::ivec2 view, float scale) {
    if (!(scale >= 0.1f && scale < 1.0f)) return view;
    return glm::max(glm::ivec2(glm::round(glm::vec2(view) * scale)), glm::ivec2(1));
}

/// Starts the times of a frame; those of the last one are told to the choice among fragments and compute.
void Renderer::Impl::beginTimes() {
    if (timer.isImmediate()) choice.addPassTimes(figures.passMs);
    timer.beginFrame(figures.passMs);
    if (!timer.isImmediate()) choice.addPassTimes(figures.passMs);
    if (const std::string news = choice.takeDecisions(); !news.empty())
        logInfo("full-screen passes are drawn by what was faster: " + news);
}

void Renderer::Impl::drawOnce(const View& wanted) {
    View view = wanted;
    view.size = glm::max(wanted.size >> downscale, glm::ivec2(1));
    beginTimes();
    figures.drawCalls = figures.bodyDraws = 0;
    figures.computePasses.clear();
    const glm::ivec2 traced = tracedSize(view.size, settings.resolutionScale);
    targets.beginFrame(traced, view.cut);
    pictures.beginFrame(view.size, view.cut);
    fillBlock(view, traced);
    uploadBlock();
    const FrameContext frame{
        block, settings, scene, targets, pictures, blueNoise, figures, emptyVertexArray, updateLightGrid(), &choice};
    drawPasses(frame);
    const Texture* target = find(shown->target);
    run("show", [&] { show.draw(frame, target ? *target : blueNoise, shown->mode, wanted, dot()); });
}

RenderSettings RenderSettings::preset(std::string_view name) {
    RenderSettings settings;
    if (name == "fast") {
        settings.resolutionScale = 0.75f;
        settings.skyDistance = 12.0f;
        settings.skyExactDistance = 1.6f;
        settings.bounceColors = false;
        settings.bounces = 1;
        settings.filterPasses = 2;
    }
    if (name == "accurate") {
        settings.skyRays = 8;
        settings.sunRays = 4;
        settings.filterPasses = 5;
        settings.bounces = 3;
    }
    return settings;
}

Fullscreen RenderSettings::fullscreenFromName(std::string_view name) {
    if (name == "fastest") return Fullscreen::Fastest;
    return name == "compute" ? Fullscreen::Compute : name == "fragment" ? Fullscreen::Fragment : Fullscreen::Auto;
}

Result<std::unique_ptr<Renderer>> Renderer::create(GlLoader loader, const std::string& shaderFolder,
                                                   const RenderSettings& settings) {
    if (auto loaded = loadGl(loader); !loaded) return Error{loaded.error()};
    const GlStateGuard hostState;
    auto impl = std::make_unique<Impl>(shaderFolder, settings);
    if (!impl->shaders.errors().empty()) return Error{impl->shaders.errors().front()};
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Renderer::~Renderer() = default;

void Renderer::apply(FrameSnapshot&& snapshot) {
    m_impl->scene.apply(std::move(snapshot));
}
void Renderer::draw(const View& view, float alpha) {
    m_impl->draw(view, alpha);
}

const std::string& Renderer::lastError() const {
    return m_impl->lastError;
}

bool Renderer::reloadShaders() {
    const GlStateGuard hostState;
    const bool any = m_impl->shaders.reloadChanged();
    if (any) m_impl->reloaded = std::chrono::steady_clock::now();
    return any;
}

std::vector<std::string> Renderer::shaderErrors() const {
    return m_impl->shaders.errors();
}

bool Renderer::showPass(std::string_view name) {
    for (const TargetView& shown : kTargetViews)
        if (shown.name == name) {
            m_impl->shown = &shown;
            return true;
        }
    return false;
}

std::vector<std::string> Renderer::passNames() const {
    std::vector<std::string> names;
    for (const TargetView& shown : kTargetViews) names.emplace_back(shown.name);
    return names;
}

Result<FloatImage> Renderer::readTarget(std::string_view name) const {
    const Texture* texture = m_impl->find(name);
    if (!texture) return Error{"no pass has drawn a target \"" + std::string(name) + "\""};
    if (pixelFormat(texture->internalFormat()).format == GL_DEPTH_COMPONENT)
        return Error{"target \"" + std::string(name) + "\" holds no colours"};
    const GlStateGuard hostState;
    FloatImage image(texture->size());
    m_impl->targets.framebuffer({texture}).begin();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glReadPixels(0, 0, image.size.x, image.size.y, GL_RGBA, GL_FLOAT, image.pixels.data());
    return image;
}

const RenderFigures& Renderer::figures() const {
    return m_impl->figures;
}

}  // namespace rubble
