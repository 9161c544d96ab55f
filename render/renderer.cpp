#include "render/renderer.h"

#include <algorithm>
#include <optional>

#include "render/frame/frame_context.h"
#include "render/frame/fullscreen_mode.h"
#include "render/frame/noise_texture.h"
#include "render/frame/view_check.h"
#include "render/frame/view_histories.h"
#include "render/gl/offscreen.h"
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
#include "render/passes/history_left_pass.h"
#include "render/passes/host_layers_pass.h"
#include "render/passes/local_lights_pass.h"
#include "render/passes/overlay_pass.h"
#include "render/passes/particles_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/passes/relight_pass.h"
#include "render/passes/ropes_pass.h"
#include "render/passes/sampler_reset.h"
#include "render/passes/show_pass.h"
#include "render/passes/sky_pass.h"
#include "render/passes/sun_pass.h"
#include "render/passes/taa_pass.h"
#include "render/passes/tonemap_pass.h"
#include "render/passes/water_pass.h"
#include "render/passes/wetness_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"
#include "render/scene/warm_up_scene.h"
#include "runtime/core/constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr float kStill = 1.0f / float(kStepsPerSecond);     ///< seconds of a frame in which no game time passes
constexpr double kLongestFrame = 1.0, kGreenSeconds = 1.0;  ///< seconds; the second: a dot tells of new shaders

std::string shaderDefines(const RenderSettings& settings, const TexelStore& texels) {
    return texels.shaderDefines() + (settings.noise == Noise::White ? "#define WHITE_NOISE\n" : "");
}
/// Makes a block the one that shaders see.
void uploadBlock(const FrameBlock& block, GLuint buffer) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer);
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer);
}

}  // namespace

struct Renderer::Impl {
    Impl(const std::string& shaderFolder, const RenderSettings& given)
        : settings(given.inRange()),
          shaders(shaderFolder, programsFor(fullscreen), shaderDefines(settings, texels), &programCache) {
        startScene();
        if (isSoftwareGl() && !texels.isShared()) samplerReset.emplace(shaders);
        shaders.endBatch();
    }
    /// An empty scene.
    void startScene() {
        scene = Scene();
        scene.setUploadBudget(settings.uploadBudget);
        scene.setBounceColors(settings.sky && settings.bounce && settings.bounceColors);
    }
    void compileAhead();
    template <class F>
    void forEachLazyPass(F&& f) {
        f(localLights), f(relight), f(glassShadow), f(wetness), f(water), f(fog), f(glare), f(particles), f(ropes),
            f(exact), f(hostLayers);
    }
    GlStateGuard guardHostState() const {
        return GlStateGuard(settings.hostState,
                            {.images = fullscreen != Fullscreen::Fragment,
                             .sharedTexels = texels.isShared(),
                             .units = texels.isShared() ? GlLimits().textureUnits + 1 : kTextureUnits});
    }

    /// The frame. Each line: the pass, the targets that it reads, those that it writes. The target pool asserts that
    /// passes use no others.
    void drawPasses(const FrameContext& frame, const View& view);
    void drawGeometry(const FrameContext& frame);
    void drawLight(const FrameContext& frame);
    void drawImage(const FrameContext& frame, const View& view);
    void showImage(const FrameContext& frame, const View& view);
    /// For passes of what most scenes never have: builds the pass with the first frame that needs it.
    template <class Pass, class... Rest>
    void drawLazily(std::optional<Pass>& pass, const FrameContext& frame, Rest&&... rest) {
        if (!pass) pass.emplace(shaders);
        pass->draw(frame, rest...);
    }
    bool isGlassSunlit() const { return settings.sun && block.sunDirection.y > 0.0f && scene.hasGlass(); }
    /// The passes of sun, sky and local lights write or add to different channels of it.
    void clearNoisyLight(const FrameContext& frame) {
        frame.targets.framebuffer({&frame.targets.target(Target::NoisyLight)}).begin();
        const float none[4] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, none);
    }
    template <class F>
    void run(const char* name, TargetSet reads, TargetSet writes, F&& draw) {
        choice.beginPass(name), timer.begin(name, int(choice.method()));
        if (samplerReset) samplerReset->draw(blueNoise, emptyVertexArray);
        history->targets.beginPass(reads, writes);
        draw();
        history->targets.endPass();
        timer.end();
        stats.passes.push_back(name);
        if (choice.hasDrawnByCompute()) stats.computePasses.push_back(name);
    }
    void beginTimes();
    void takeTimes();
    void draw(const View& view, float alpha);
    void drawOnce(const View& view);
    void drawFrames(const View& view, float alpha);
    void drawSmallerOnFailure(const View& view);
    glm::vec4 statusDot() const;
    void fillBlock(const View& view, glm::ivec2 renderSize);
    const LightGrid* updateLightGrid();
    RenderSettings settings;
    GlLimits limits =
        settings.limits ? GlLimits::least(*settings.limits, GlLimits::ofContext()) : GlLimits::ofContext();
    TexelStore texels{limits};
    ProgramCache programCache{settings.programCache};
    Fullscreen fullscreen = supportedFullscreen(settings.fullscreen);
    ShaderLibrary shaders;
    FullscreenChoice choice = initialChoice(fullscreen);
    Scene scene;
    ViewHistories histories;
    ViewHistory* history = nullptr;  ///< of the view that is drawn
    ViewCheck check;
    uint64_t moment = 1;       ///< of the scene: grows when what is drawn has changed
    bool isMomentOver = true;  ///< a snapshot was applied since the last draw
    bool isOtherView = false;  ///< it shows what another view showed last
    FrameBlock block{};
    GlName<BufferKind> blockBuffer = GlName<BufferKind>::make();
    VertexArray emptyVertexArray = VertexArray::make();
    Texture blueNoise = makeNoiseTexture();
    PassTimer timer{isSoftwareGl() || isEmbedded(), settings.processorTime};
    RenderStats stats;
    float stepAlpha = 1.0f;       ///< of this frame: 0 to 1 between the last two steps
    float frameSeconds = kStill;  ///< since the frame before of this view
    const ShowPass::TargetView* shown = &ShowPass::views()[0];
    std::string lastError;
    double greenUntil = 0.0;  ///< when the dot that tells of reloaded shaders goes out, by RenderSettings::seconds

    GBufferPass gbuffer{(shaders.setRareFeatures(false), shaders.beginBatch(), shaders)};  // all start before one ends
    GlassPass glass{shaders};
    SunPass sun{shaders};
    HistoryLeftPass historyLeft{shaders};
    SkyPass sky{shaders};
    std::optional<LightGrid> lightGrid;
    std::optional<LocalLightsPass> localLights;
    std::optional<RelightPass> relight;
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
    std::optional<GBufferPass> exact;
    std::optional<HostLayersPass> hostLayers;
    std::optional<Overlay> overlay;
    std::optional<OverlayPass> overlayPass;
    TaaPass taa{shaders};
    BloomPass bloom{shaders};
    ExposurePass exposure{shaders};
    TonemapPass tonemap{shaders};
    std::optional<SamplerReset> samplerReset;
    ShowPass show{shaders};
};

void Renderer::Impl::drawPasses(const FrameContext& frame, const View& view) {
    drawGeometry(frame);
    drawLight(frame);
    drawImage(frame, view);
}

void Renderer::Impl::drawGeometry(const FrameContext& frame) {
    using enum Target;
    run("gbuffer", {}, kGBuffer | GlassMask, [&] { gbuffer.draw(frame); });
    if (!scene.ropes().empty()) run("ropes", {}, kGBuffer, [&] { drawLazily(ropes, frame, stepAlpha); });
    if (scene.environment().wetness > 0.0f)
        run("wetness", kGBuffer, Albedo | Material | DryAlbedo | DryMaterial, [&] { drawLazily(wetness, frame); });
    if (scene.hasGlass())
        run("glass", Depth | GlassMask, GlassTint | GlassSurface | GlassDepth,
            [&] { glass.draw(frame, gbuffer.tiles()); });
    if (isGlassSunlit()) run("glass shadow", {}, {}, [&] { drawLazily(glassShadow, frame); });
}

void Renderer::Impl::drawLight(const FrameContext& frame) {
    using enum Target;
    if (HistoryLeftPass::needed(frame))
        run("history left", kLightHistory | kBounceHistory, HistoryLeft, [&] { historyLeft.draw(frame); });
    clearNoisyLight(frame);
    if (settings.sun && block.sunDirection.y > 0.0f) run("sun", kGBuffer, NoisyLight, [&] { sun.draw(frame); });
    if (settings.sky)
        run("sky", kGBuffer | kBounceHistory | kLightHistory, NoisyLight | HitProximity,
            [&] { sky.draw(frame, isGlassSunlit() ? &*glassShadow : nullptr); });
    if (LocalLightsPass::needed(frame))
        run("local lights", kGBuffer | kLightHistory | previous(Specular), NoisyLight | Specular,
            [&] { drawLazily(localLights, frame); });
    if (RelightPass::needed(frame))
        run("relight", kGBuffer | NoisyLight | kLightHistory, kRelighting | NoisyLightOffset,
            [&] { drawLazily(relight, frame); });
    run("accumulate", kGBuffer | NoisyLight | HitProximity | kRelighting | kLightHistory | previous(FastHistory),
        AccumulatedLight | Surface | FastHistory | HistoryConfidence, [&] { accumulate.draw(frame); });
    run("filter", DepthBuffer | AccumulatedLight | Surface, DenoisedLight | DenoisedLightScratch,
        [&] { filter.draw(frame); });
    if (ReflectionsPass::needed(frame))
        run("reflections",
            kGBuffer | GlassSurface | DenoisedLight | Surface | kBounceHistory |
                previous(AccumulatedReflection | ReflectionMoments),
            Reflection | ReflectionMask | NoisyReflection | AccumulatedReflection | ReflectionMoments,
            [&] { reflections.draw(frame); });
}

void Renderer::Impl::drawImage(const FrameContext& frame, const View& view) {
    using enum Target;
    run("composite", kGBuffer | GlassSurface | DenoisedLight | Specular | Surface | Reflection,
        Radiance | DiffuseFraction, [&] { composite.draw(frame, isGlassSunlit() ? &*glassShadow : nullptr); });
    bool hasPaneLight = false;
    if (scene.hasGlass() && !scene.waters().empty())
        run("pane light", kPanes, PaneLight, [&] { hasPaneLight = glass.drawLight(frame, gbuffer.tiles()); });
    if (!scene.waters().empty())
        run("water", kPanes | kBounceHistory, Radiance | BehindWater | PaneLight | PaneLightBehind,
            [&] { drawLazily(water, frame, hasPaneLight); });
    if (scene.hasGlass())
        run("glass composite", kPanes | PaneLight, Radiance | BehindGlass,
            [&] { glass.drawOver(frame, gbuffer.tiles(), hasPaneLight); });
    if (FogPass::needed(frame))
        run("fog", Depth | previous(FogLight), FogLight | Fog | Radiance, [&] { drawLazily(fog, frame); });
    if (!scene.particles().empty())
        run("particles", Depth | DepthBuffer, Radiance, [&] { drawLazily(particles, frame, stepAlpha); });
    if (settings.glare && LocalLightsPass::needed(frame) && !lightGrid->empty())
        run("glare", Depth, Radiance, [&] { drawLazily(glare, frame); });
    run("taa", Radiance | kSteadiness | previous(Resolved), Resolved, [&] { taa.draw(frame); });
    if (settings.bloom > 0.0f)
        run("bloom", Resolved, Bloom0 | Bloom1 | Bloom2 | Bloom3 | Bloom4, [&] { bloom.draw(frame); });
    run("exposure", Resolved | previous(Exposure), Exposure, [&] { exposure.draw(frame, view.hasFixedExposure); });
    run("tonemap", Resolved | Exposure | Bloom0, Final, [&] { tonemap.draw(frame); });
}

/// Where fewer pixels are traced than shown, a host's depth is composed with that of another G-buffer.
void Renderer::Impl::showImage(const FrameContext& frame, const View& view) {
    using enum Target;
    const FrameBlock atPixels = block.atDisplayedPixels();
    const glm::ivec2 size(atPixels.displaySize);
    const FrameContext exactly = frame.with(atPixels, history->exactTargets),
                       layers = frame.with(atPixels, history->hostTargets);
    const bool isExact = view.composesDepth() && size != glm::ivec2(block.targetSize);
    const bool hasLayers = shown == &ShowPass::views()[0] && size == view.size && HostLayersPass::needed(frame, view);
    if (isExact || hasLayers) uploadBlock(atPixels, blockBuffer.get());
    if (isExact) {
        history->exactTargets.beginFrame(size, size, view.cut);
        run("exact depth", {}, {}, [&] {
            drawLazily(exact, exactly);
            if (!scene.ropes().empty()) drawLazily(ropes, exactly, stepAlpha);
        });
    }
    const Texture& depth = isExact ? history->exactTargets.at(Depth) : frame.targets.at(Depth);
    if (hasLayers) {
        history->hostTargets.beginFrame(size, size, view.cut);
        const auto made = [](auto& pass) { return pass ? &*pass : nullptr; };
        const HostLayersPass::Layers all{glass, isExact ? exact->tiles() : gbuffer.tiles(), made(water), made(fog),
                                         made(particles)};
        run("host layers", Depth | Exposure | Reflection | Fog | kBounceHistory, {},
            [&] { drawLazily(hostLayers, layers, view, depth, all, stepAlpha); });
    }
    run("show", ShowPass::reads(*shown), {}, [&] {
        show.draw(frame, *shown, view, depth, statusDot());
        if (hasLayers) hostLayers->show(layers, view);
    });
    if (overlay && !overlay->empty())
        run("overlay", Depth, {}, [&] { drawLazily(overlayPass, frame, *overlay, view, depth, limits.textureSide); });
}

void Renderer::Impl::fillBlock(const View& view, glm::ivec2 renderSize) {
    history->camera.begin(view, renderSize, settings.temporal, scene.origin(), block);
    block.counters.z = int(std::count_if(scene.lights().begin(), scene.lights().end(),
                                         [](const SnapshotLight& light) { return !light.fleeting; }));
    scene.describe(block);
    if (!settings.fog) block.fog.x = 0.0f;
}

const LightGrid* Renderer::Impl::updateLightGrid() {
    if (!lightGrid && scene.lights().empty()) return nullptr;
    LightGrid& grid = lightGrid ? *lightGrid : lightGrid.emplace();
    stats.uploadBytes += grid.update(scene.lights(), block, scene.origin(), isOtherView);
    return &grid;
}

/// Builds the programs of all passes and draws steps of a scene that needs them all into a small image that is thrown
/// away, each step twice: by each of two methods if both will be tried.
void Renderer::Impl::compileAhead() {
    const GlStateGuard hostState = guardHostState();
    const TexelStore::Use use(texels);
    shaders.beginBatch();
    forEachLazyPass([&](auto& pass) { pass.emplace(shaders); });
    shaders.endBatch();
    const Offscreen image({kWarmUpSide, kWarmUpSide});
    const View view{.position = kWarmUpPosition, .size = image.size(), .framebuffer = image.framebuffer()};
    history = &histories.begin(0, view.size, limits);
    for (FrameSnapshot& step : warmUpSteps()) {
        scene.apply(std::move(step));
        for (int i = 0; i < 2; ++i) drawFrames(view, 1.0f);
    }
    histories.clear();
    forEachLazyPass([](auto& pass) { pass.reset(); });  // their programs stay in the library
    lightGrid.reset();
    startScene();
    gbuffer.startScene();
    choice = initialChoice(fullscreen);
    isMomentOver = true;
    stats = {};
}

void Renderer::Impl::draw(const View& view, float alpha) {
    if (view.size.x <= 0 || view.size.y <= 0) return;
    if (std::string error = check.error(view, settings.hostState == HostState::Restored); !error.empty()) {
        if (error != lastError) logError(error);
        return void(lastError = std::move(error));
    }
    lastError.clear();
    const GlStateGuard hostState = guardHostState();
    const TexelStore::Use use(texels);
    history = &histories.begin(view.slot, view.size, limits);
    drawFrames(view, alpha);
    drawSmallerOnFailure(view);
    stats.textureBytes = histories.bytes() + scene.bytes() + gbuffer.bytes() + blueNoise.bytes() +
                         (lightGrid ? lightGrid->bytes() : 0) + (overlayPass ? overlayPass->bytes() : 0);
    stats.computePrograms = shaders.computePrograms();
    stats.waitingBytes = scene.bodies().waitingBytes();
    stats.shapes = scene.bodies().shapes(), stats.bricks = scene.bodies().bricks();
}

void Renderer::Impl::drawFrames(const View& view, float alpha) {
    // Another view of what was drawn last shows the same motion; the same view again, that it has ended.
    isOtherView = !isMomentOver && alpha == stepAlpha && history->moment != moment;
    moment += !isOtherView;
    isMomentOver = false;
    stepAlpha = alpha;
    stats.uploadBytes = scene.beginFrame(alpha, view.position, isOtherView, view.hidden);
    shaders.setRareFeatures(scene.shadow().directory().paged().bricks > 0 ||
                            std::any_of(scene.lights().begin(), scene.lights().end(),
                                        [](const SnapshotLight& light) { return light.isRectangle(); }));
    // Where the game stands still its frames count as those of a screen.
    const double now = scene.seconds() + double(alpha - 1.0f) / kStepsPerSecond, passed = now - history->gameSeconds;
    frameSeconds = passed > 0.0 ? float(std::min(passed, kLongestFrame)) : kStill;
    history->gameSeconds = now;
    View each = view;
    const uint64_t replacements = scene.lookChanges().replacements();
    each.cut |= std::exchange(history->replacements, replacements) != replacements;  // what it shows is gone
    const bool isFirst = std::exchange(history->moment, moment) == 0 || each.cut;
    for (int i = isFirst ? settings.warmUpFrames : 0; i >= 0; --i) {
        drawOnce(each);
        each.cut = false, frameSeconds = kStill;
    }
}

void Renderer::Impl::drawSmallerOnFailure(const View& view) {
    while (history->allocationFailed()) {
        dropErrors();
        if (history->downscale == ViewHistories::kMaxDownscale)
            return logError(lastError = "the GL could not make targets of any size: it is probably out of memory");
        ++history->downscale;
        logWarning("the GL could not make render targets for a view of " + std::to_string(view.size.x) + "x" +
                   std::to_string(view.size.y) + "; it is drawn at 1/" + std::to_string(1 << history->downscale) +
                   " of that size and scaled up");
        history->clear();
        drawOnce(view);
    }
}

/// Red while shaders do not build, green for kGreenSeconds after they were reloaded.
glm::vec4 Renderer::Impl::statusDot() const {
    if (!shaders.errors().empty()) return {0.9f, 0.1f, 0.05f, 1.0f};
    return settings.seconds() < greenUntil ? glm::vec4(0.1f, 0.8f, 0.2f, 1.0f) : glm::vec4(0.0f);
}

/// Gives the times that have become known to the choice between fragments and compute.
void Renderer::Impl::takeTimes() {
    const PassTimer::Times times = timer.take();
    if (times.empty()) return;
    choice.addPassTimes(times);
    if (!settings.passTimes) return;
    stats.passMs.clear();
    for (const PassTimer::Time& time : times) stats.passMs.emplace_back(time.name, time.ms);
}

/// Starts the times of a frame.
void Renderer::Impl::beginTimes() {
    takeTimes();
    timer.beginFrame(settings.passTimes || choice.isMeasuring());
    takeTimes();
    if (const std::string decisions = choice.takeDecisions(); !decisions.empty())
        logInfo("full-screen passes are drawn by the faster method: " + decisions);
}

void Renderer::Impl::drawOnce(const View& wanted) {
    View view = wanted;
    view.size = glm::max(wanted.size >> history->downscale, glm::ivec2(1));
    beginTimes();
    stats.beginFrame();
    const glm::ivec2 renderSize =
        glm::max(glm::ivec2(glm::round(glm::vec2(view.size) * settings.resolutionScale)), glm::ivec2(1));
    history->targets.beginFrame(renderSize, view.size, view.cut);
    fillBlock(view, renderSize);
    uploadBlock(block, blockBuffer.get());
    const FrameContext frame{
        block,   settings,    scene, history->targets, blueNoise, stats, emptyVertexArray, updateLightGrid(),
        &choice, frameSeconds};
    drawPasses(frame, view);
    showImage(frame, wanted);
    if (timer.isImmediate()) takeTimes();
}

Result<std::unique_ptr<Renderer>> Renderer::create(GlLoader loader, const std::string& shaderFolder,
                                                   const RenderSettings& settings) {
    if (auto loaded = loadGl(loader); !loaded) return Error{loaded.error()};
    const GlStateGuard hostState(settings.hostState);
    auto impl = std::make_unique<Impl>(shaderFolder, settings);
    if (!impl->shaders.errors().empty()) return Error{impl->shaders.errors().front()};
    if (settings.compileAhead) impl->compileAhead();
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}
bool Renderer::hasContext() {
    return glGetString(GL_VERSION);
}
Renderer::Renderer(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Renderer::~Renderer() {
    const WithoutGlContext gone(!m_impl->check.isItsContext());
    m_impl.reset();
}
void Renderer::apply(FrameSnapshot&& snapshot) {
    m_impl->scene.apply(std::move(snapshot)), m_impl->isMomentOver = true;
}
void Renderer::draw(const View& view, float alpha) {
    m_impl->draw(view, alpha);
}
const std::string& Renderer::lastError() const {
    return m_impl->lastError;
}
std::vector<std::string> Renderer::shaderErrors() const {
    return m_impl->shaders.errors();
}
const RenderStats& Renderer::stats() const {
    return m_impl->stats;
}
Overlay& Renderer::overlay() {
    return m_impl->overlay ? *m_impl->overlay : m_impl->overlay.emplace();
}
bool Renderer::reloadShaders() {
    if (m_impl->check.isLost()) return false;
    const GlStateGuard hostState = m_impl->guardHostState();
    if (!m_impl->shaders.reloadChanged()) return false;
    m_impl->greenUntil = m_impl->settings.seconds() + kGreenSeconds;
    return true;
}
bool Renderer::showPass(std::string_view name) {
    for (const ShowPass::TargetView& view : ShowPass::views())
        if (view.name == name) return m_impl->shown = &view, true;
    return false;
}
std::vector<std::string> Renderer::passNames() const {
    std::vector<std::string> names;
    for (const auto& view : ShowPass::views()) names.emplace_back(view.name);
    return names;
}
Result<FloatImage> Renderer::readTarget(std::string_view name) const {
    const auto declared = std::find_if(kTargets.begin(), kTargets.end(), [&](auto& each) { return each.name == name; });
    const std::string text = "target \"" + std::string(name) + "\": ";
    if (declared == kTargets.end()) return Error{text + "expected a name of render/frame/targets.h"};
    ViewHistory* drawn = m_impl->check.isLost() ? nullptr : m_impl->histories.last();
    const Texture* texture = drawn ? drawn->targets.find(declared->id) : nullptr;
    if (!texture) return Error{text + "no pass has drawn it; call draw() with the settings that need it"};
    const GlStateGuard hostState = m_impl->guardHostState();
    FloatImage image(texture->size());
    if (!drawn->targets.read(*texture, image.pixels)) return Error{text + "expected colours, found a depth buffer"};
    return image;
}

}  // namespace rubble
