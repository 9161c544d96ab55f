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

}  // namespace

/// A water in view.
struct VisibleWater {
    double distance;  ///< of its box from the camera, or from the plane through an orthographic one, metres
    const Water* water;
    WaterArea area;
    int firstCorner = 0;  ///< of its area in the texture
};

namespace {

double distanceOf(const WorldBox& box, const FrameBlock& block, glm::dvec3 eye) {
    if (!block.isOrthographic()) return glm::distance(glm::clamp(eye, box.low, box.high), eye);
    const glm::dvec3 forward(block.cameraForward), half = 0.5 * (box.high - box.low);
    return std::max(glm::dot(box.low + half - eye, forward) - glm::dot(half, glm::abs(forward)), 0.0);
}

/// The waters in view, the farthest first: of two that cover a pixel the nearer one is seen.
std::vector<VisibleWater> visibleWaters(const FrameContext& frame) {
    const glm::dvec3 origin = frame.scene.origin(), eye = origin + glm::dvec3(frame.block.cameraPosition);
    std::vector<VisibleWater> visible;
    for (const Water& water : frame.scene.waters()) {
        WaterArea area = waterArea(water, frame.block, origin);
        const WorldBox box = water.bounds();
        if (area.covered.empty()) continue;
        visible.push_back({distanceOf(box, frame.block, eye), &water, std::move(area)});
    }
    std::stable_sort(visible.begin(), visible.end(),
                     [](const VisibleWater& a, const VisibleWater& b) { return a.distance > b.distance; });
    return visible;
}

/// How many waters from `first` on can be drawn one after the other over one copy of the image, as no pixel shows two.
size_t countApart(const std::vector<VisibleWater>& waters, size_t first) {
    size_t end = first + 1;
    const auto isApart = [&](size_t i) { return !waters[i].area.overlaps(waters[end].area); };
    for (; end < waters.size(); ++end)
        for (size_t i = first; i < end; ++i)
            if (!isApart(i)) return end - first;
    return end - first;
}

}  // namespace

WaterPass::WaterPass(ShaderLibrary& shaders)
    : m_program(
          shaders.loadFullscreen("passes/water.frag", {.vertexFile = "passes/water.vert"}, "water is not drawn")) {}

void WaterPass::copy(const FrameContext& frame, const PixelRect& part, bool hasPanes) {
    frame.targets.copy(Target::Radiance, Target::BehindWater, part);
    if (hasPanes) frame.targets.copy(Target::PaneLight, Target::PaneLightBehind, part);
    ++frame.stats.imageCopies;
    frame.stats.copiedPixels += part.pixels();
}

void WaterPass::draw(const FrameContext& frame, bool hasPanes) {
    if (!m_program) return;
    std::vector<VisibleWater> visible = visibleWaters(frame);
    PixelRect copied;
    std::vector<glm::vec4> corners;
    for (VisibleWater& each : visible) {
        copied = copied.merged(each.area.bounds);
        each.firstCorner = int(corners.size());
        for (const glm::dvec2 corner : each.area.covered.corners())
            corners.emplace_back(glm::vec2(corner / glm::dvec2(frame.block.targetSize)), 0.0f, 0.0f);
    }
    if (!m_corners.refill(std::as_bytes(std::span(corners)))) return;
    for (size_t i = 0; i < visible.size();) {
        const size_t end = i + countApart(visible, i);
        PixelRect part = copied;  // the first copy is all that any water refracts
        if (i > 0) part = {};
        for (size_t k = i; k < end; ++k) part = part.merged(visible[k].area.bounds);
        copy(frame, part, hasPanes);
        for (; i < end; ++i) drawOne(frame, visible[i], copied, hasPanes);
    }
}

void WaterPass::drawOne(const FrameContext& frame, const VisibleWater& visible, const PixelRect& copied,
                        bool hasPanes) const {
    const Water& water = *visible.water;
    FullscreenTargets into{.colors = {&frame.targets.at(Target::Radiance)},
                           .corners = int(visible.area.covered.corners().size()),
                           .area = visible.area.bounds};
    if (hasPanes) into.colors.push_back(&frame.targets.at(Target::PaneLight));
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        program.set("uAreaCorners", m_corners);
        program.set("uAreaFirst", visible.firstCorner);
        program.set("uDepth", frame.targets.at(Target::Depth));
        program.set("uBackground", frame.targets.at(Target::BehindWater));
        program.set("uBackgroundLow", copied.low);
        program.set("uBackgroundHigh", copied.high - 1);
        program.set("uHasPanes", int(hasPanes));
        program.set("uGlassTint", frame.targets.orNone(Target::GlassTint));
        program.set("uGlassSurface", frame.targets.orNone(Target::GlassSurface));
        program.set("uPaneLightBehind", frame.targets.orNone(Target::PaneLightBehind));
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
    frame.stats.waterPixels += uint64_t(std::llround(visible.area.covered.area()));
}

}  // namespace rubble
