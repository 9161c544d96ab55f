#include "render/passes/water_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat4x4.hpp>

#include "render/frame/shader_constants.h"
#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr size_t kMaxCorners = 32;
constexpr float kRingSpeed = 0.9f;   // m/s
constexpr float kRingDecay = 1.2f;   // 1/s
constexpr float kRingAttack = 8.0f;  // 1/s: a ring has its full height after 1/8 s
constexpr float kRingCore = 0.3f;    // metres added to radii, so that the height of a small ring stays finite
constexpr std::array kOutlines = {"uOutline0", "uOutline1", "uOutline2", "uOutline3"};  // 8 corners each

void setWater(const Program& program, const Scene& scene, const Water& water) {
    const glm::dvec3 origin = scene.origin();
    std::array<glm::mat4, kOutlines.size()> corners{};
    const size_t count = std::min(water.outline.size(), kMaxCorners);
    for (size_t i = 0; i < count; ++i) {
        glm::vec4& pair = corners[i / 8][int(i % 8 / 2)];
        (i % 2 ? pair.z : pair.x) = float(water.outline[i].x - origin.x);
        (i % 2 ? pair.w : pair.y) = float(water.outline[i].z - origin.z);
    }
    for (size_t i = 0; i < kOutlines.size(); ++i) program.set(kOutlines[i], corners[i]);
    program.set("uCornerCount", int(count));
    program.set("uSurface", float(water.surface - origin.y));
    program.set("uColor", water.color);
    program.set("uClarity", water.clarity);
    program.set("uWaves", glm::vec4(water.waves.height, water.waves.length, water.waves.speed, water.waves.direction));
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

WaterPass::WaterPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/water.frag")) {
    if (!m_program) logError("water is not drawn: " + shaders.errors().back());
}

void WaterPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    for (const Water& water : frame.scene.waters()) {
        const Texture& behind = frame.targets.copy(Target::Radiance, Target::BehindWater);
        drawFullscreen(frame, m_program, {{&frame.targets.at(Target::Radiance)}}, [&](const Program& program) {
            program.set("uDepth", frame.targets.at(Target::Depth));
            program.set("uBackground", behind);
            program.set("uBlueNoise", frame.blueNoise);
            frame.scene.bindShadow(program);
            bindBounce(program, frame, BounceRays::Mirrored);
            setWater(program, frame.scene, water);
            setRipples(program, frame.scene, water);
        });
    }
}

}  // namespace rubble
