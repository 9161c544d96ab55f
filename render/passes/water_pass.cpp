#include "render/passes/water_pass.h"

#include <algorithm>
#include <array>
#include <glm/mat4x4.hpp>

#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr size_t kMostCorners = 32;
constexpr std::array kOutlines = {"uOutline0", "uOutline1", "uOutline2", "uOutline3"};  // 8 corners each

}  // namespace

WaterPass::WaterPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/water.frag", "lib/fullscreen.vert")) {
    if (!m_program) logError("water is not drawn: " + shaders.errors().back());
}

void WaterPass::setWater(const FrameContext& frame, const Water& water) const {
    const glm::dvec3 origin = frame.scene.origin();
    std::array<glm::mat4, kOutlines.size()> corners{};
    const size_t count = std::min(water.outline.size(), kMostCorners);
    for (size_t i = 0; i < count; ++i) {
        glm::vec4& pair = corners[i / 8][int(i % 8 / 2)];
        (i % 2 ? pair.z : pair.x) = float(water.outline[i].x - origin.x);
        (i % 2 ? pair.w : pair.y) = float(water.outline[i].z - origin.z);
    }
    for (size_t i = 0; i < kOutlines.size(); ++i) m_program.set(kOutlines[i], corners[i]);
    m_program.set("uCorners", int(count));
    m_program.set("uSurface", float(water.surface - origin.y));
    m_program.set("uColor", water.color);
    m_program.set("uClarity", water.clarity);
    m_program.set("uWaves", glm::vec4(water.waves.height, water.waves.length, water.waves.speed, water.waves.direction));
    m_program.set("uSeconds", float(frame.scene.seconds()));
}

void WaterPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.at("radiance")}).begin();
    m_program.use();
    m_program.set("uDepth", frame.targets.at("depth"));
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    for (const Water& water : frame.scene.waters()) {
        setWater(frame, water);
        m_program.set("uAdds", 0);  // first what is left of the light from below, then the water's own
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        frame.drawFullscreen();
        m_program.set("uAdds", 1);
        glBlendFunc(GL_ONE, GL_ONE);
        frame.drawFullscreen();
    }
    glDisable(GL_BLEND);
}

}  // namespace rubble
