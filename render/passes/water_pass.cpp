#include "render/passes/water_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "render/frame/shader_constants.h"
#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/scene/scene.h"
#include "render/scene/water_area.h"

namespace rubble {
namespace {

constexpr float kRingSpeed = 0.9f;      // m/s
constexpr float kRingDecay = 1.2f;      // 1/s
constexpr float kRingAttack = 8.0f;     // 1/s: a ring has its full height after 1/8 s
constexpr float kRingCore = 0.3f;       // metres added to radii, so that the height of a small ring stays finite
constexpr float kShortestWave = 1e-3f;  // metres: shorter ones are drawn so

void setWater(const Program& program, const Scene& scene, const Water& water) {
    const glm::dvec3 origin = scene.origin();
    program.set("uSurface", float(water.surface - origin.y));
    program.set("uBottom", float(water.surface - water.depth - origin.y));
    program.set("uColor", water.color);
    const glm::vec3 transmittance = glm::clamp(water.color, glm::vec3(1e-4f), glm::vec3(1.0f));
    program.set("uExtinction", -glm::log(transmittance) / std::max(water.clarity, 1e-3f));
    program.set("uWaves", glm::vec4(water.waves.height, std::max(water.waves.length, kShortestWave), water.waves.speed,
                                    water.waves.direction));
    program.set("uSeconds", float(scene.seconds()));
}

/// The rings on this water, as the shader reads them: centre, radius of the crest, and its height now. A ring that
/// keeps its energy is lower the longer its crest: its height falls as 1 / sqrt(radius), and by damping.
void setRipples(const Program& program, const Scene& scene, const Water& water) {
    const glm::dvec3 origin = scene.origin();
    std::array<glm::vec4, shared::kMaxRipples> rings;
    int count = 0;
    for (const SnapshotRipple& ripple : scene.ripples()) {
        if (ripple.surface != water.surface || size_t(count) == shared::kMaxRipples) continue;
        const float radius = ripple.radius + kRingSpeed * ripple.age;
        const float fade = std::exp(-kRingDecay * ripple.age) * std::min(ripple.age * kRingAttack, 1.0f) *
                           std::sqrt((ripple.radius + kRingCore) / (radius + kRingCore));
        rings[size_t(count++)] = {float(ripple.center.x - origin.x), float(ripple.center.y - origin.z), radius,
                                  ripple.strength * fade};
    }
    program.set("uRippleCount", count);
    if (count > 0) program.set("uRipples[0]", std::span<const glm::vec4>(rings.data(), size_t(count)));
}

/// A water in view.
struct VisibleWater {
    double distance;  ///< of the camera from its box, metres
    const Water* water;
    PixelRect area;
};

/// The waters in view, the farthest first: of two that cover a pixel the nearer one is seen.
std::vector<VisibleWater> visibleWaters(const FrameContext& frame) {
    const glm::dvec3 origin = frame.scene.origin(), eye = origin + glm::dvec3(frame.block.cameraPosition);
    std::vector<VisibleWater> visible;
    for (const Water& water : frame.scene.waters()) {
        const PixelRect area = waterArea(water, frame.block, origin);
        const WorldBox box = water.bounds();
        if (!area.empty()) visible.push_back({glm::distance(glm::clamp(eye, box.low, box.high), eye), &water, area});
    }
    std::stable_sort(visible.begin(), visible.end(),
                     [](const VisibleWater& a, const VisibleWater& b) { return a.distance > b.distance; });
    return visible;
}

}  // namespace

WaterPass::WaterPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen("passes/water.frag", {}, "water is not drawn")) {}

void WaterPass::draw(const FrameContext& frame, bool hasPanes) const {
    if (!m_program) return;
    const std::vector<VisibleWater> visible = visibleWaters(frame);
    PixelRect copied;
    for (const VisibleWater& each : visible) copied = copied.merged(each.area);
    for (size_t i = 0; i < visible.size(); ++i) {
        // One copy of the image is enough, unless a water lies behind another one on the screen.
        const bool isOverAnother = std::any_of(visible.begin(), visible.begin() + ptrdiff_t(i),
                                               [&](const auto& other) { return other.area.overlaps(visible[i].area); });
        if (i == 0 || isOverAnother) {
            const PixelRect& part = i == 0 ? copied : visible[i].area;
            frame.targets.copy(Target::Radiance, Target::BehindWater, part);
            if (hasPanes) frame.targets.copy(Target::PaneLight, Target::PaneLightBehind, part);
            ++frame.stats.imageCopies;
        }
        drawOne(frame, *visible[i].water, visible[i].area, copied, hasPanes);
    }
}

void WaterPass::drawOne(const FrameContext& frame, const Water& water, const PixelRect& area, const PixelRect& copied,
                        bool hasPanes) const {
    FullscreenTargets into{.colors = {&frame.targets.at(Target::Radiance)}, .area = area};
    if (hasPanes) into.colors.push_back(&frame.targets.at(Target::PaneLight));
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        program.set("uDepth", frame.targets.at(Target::Depth));
        program.set("uBackground", frame.targets.at(Target::BehindWater));
        program.set("uBackgroundLow", copied.low);
        program.set("uBackgroundHigh", copied.high - 1);
        program.set("uHasPanes", int(hasPanes));
        if (hasPanes) {
            program.set("uGlassTint", frame.targets.at(Target::GlassTint));
            program.set("uGlassSurface", frame.targets.at(Target::GlassSurface));
            program.set("uPaneLightBehind", frame.targets.at(Target::PaneLightBehind));
        }
        program.set("uBlueNoise", frame.blueNoise);
        frame.scene.bindShadow(program);
        bindBounce(program, frame, BounceRays::Mirrored);
        // From below the last frame shows everything through water: rays must not meet it there.
        if (double(frame.block.cameraPosition.y) + frame.scene.origin().y < water.surface)
            program.set("uHistoryValid", 0);
        frame.scene.waterOutlines().bind(program, size_t(&water - frame.scene.waters().data()));
        setWater(program, frame.scene, water);
        setRipples(program, frame.scene, water);
    });
    ++frame.stats.waters;
    frame.stats.waterPixels += area.pixels();
}

}  // namespace rubble
