#include "render/passes/glass_shadow_pass.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/gl/draw_state.h"
#include "render/scene/scene.h"
#include "render/scene/sun_basis.h"

namespace rubble {
namespace {

constexpr GLenum kFormat = GL_RGBA16F;
constexpr int kSide = 512;         ///< texels
constexpr float kCell = 0.1f;      ///< metres per texel
constexpr float kStep = 4.0f;      ///< metres by which the map moves with the camera
constexpr float kHeight = 200.0f;  ///< metres toward the sun from the map's centre: no glass stands farther
constexpr float kAhead = 0.3f;     ///< of the map's side: its centre lies that far ahead of the camera
constexpr float kMinDown = 0.1f;  ///< sine of the angle at which a view must look down for that to depend on the fields
constexpr float kNoPane = 1e4f;   ///< metres toward the sun: farther than any pane, as the least distance counts

/// How far ahead of the camera the map's centre lies. What an orthographic view shows may be any distance away: there
/// it is where the middle of the view meets the fields, if it does.
float metresAhead(const FrameBlock& block) {
    const float usual = kAhead * kSide * kCell, down = -block.cameraForward.y;
    if (!block.isOrthographic() || down < kMinDown) return usual;
    return std::max((block.cameraPosition.y - block.skyCover.z) / down, 0.0f);
}

}  // namespace

GlassShadowPass::GlassShadowPass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/glass_shadow.frag", "passes/glass_shadow.vert")),
      m_map(kFormat, glm::ivec2(kSide)),
      m_framebuffer({&m_map}) {
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glEnableVertexAttribArray(0);
    glVertexAttribDivisor(0, 1);
    glVertexAttribIPointer(0, 1, GL_INT, 0, nullptr);
    glBindVertexArray(0);
    clear();  // the composite pass reads the map also where the program does not build
}

/// Empties the map, and binds it.
void GlassShadowPass::clear() {
    m_framebuffer.begin();
    const float none[4] = {1, 1, 1, kNoPane};
    glClearBufferfv(GL_COLOR, 0, none);
}

/// Places the map in front of the camera, in steps of kStep, so that it needs no redraw at every frame.
void GlassShadowPass::fitMap(const FrameContext& frame) {
    m_sun = glm::vec3(frame.block.sunDirection);
    const SunBasis basis = sunBasis(m_sun);
    m_right = basis.right;
    m_up = basis.up;
    const glm::vec3 focus =
        glm::vec3(frame.block.cameraPosition) + glm::vec3(frame.block.cameraForward) * metresAhead(frame.block);
    const glm::vec3 place =
        glm::floor(glm::vec3(glm::dot(focus, m_right), glm::dot(focus, m_up), glm::dot(focus, m_sun)) / kStep) * kStep;
    m_center = m_right * place.x + m_up * place.y + m_sun * place.z;
}

bool GlassShadowPass::overlaps(const Bodies::Instance& body, glm::vec3 place, float radius) const {
    const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
    const glm::vec3 offset = body.position + body.rotation * ((low + high) * 0.5f) - place;
    const float extent = radius + 0.5f * glm::length(high - low);
    return std::abs(glm::dot(offset, m_right)) < extent && std::abs(glm::dot(offset, m_up)) < extent;
}

/// Lists the bodies with glass that the map covers.
void GlassShadowPass::listBodies(const FrameContext& frame) {
    m_bodies.clear();
    const auto& instances = frame.scene.bodies().instances();
    for (size_t i = 0; i < instances.size(); ++i)
        if (!instances[i].empty() && instances[i].glass && overlaps(instances[i], m_center, 0.5f * kSide * kCell))
            m_bodies.push_back(int(i));
}

/// Whether shadow casters have changed that may lie before or behind glass, as the sun sees it.
bool GlassShadowPass::hasChangedAround(const FrameContext& frame) const {
    const auto& instances = frame.scene.bodies().instances();
    for (const DirtyRegions::Box& box : frame.scene.dirtyRegions().boxes()) {
        const glm::dvec3 low = glm::dvec3(box.low) * DirtyRegions::kWordMetres,
                         high = glm::dvec3(box.high) * DirtyRegions::kWordMetres;
        const glm::vec3 middle(0.5 * (low + high) - frame.scene.origin());
        const float radius = 0.5f * float(glm::distance(low, high));
        for (const int body : m_bodies)
            if (overlaps(instances[size_t(body)], middle, radius)) return true;
    }
    return false;
}

void GlassShadowPass::draw(const FrameContext& frame) {
    const glm::vec3 before = m_center;
    fitMap(frame);
    const bool isUpToDate = m_drawnChanges == frame.scene.glassChanges() && before == m_center;
    if (!m_program || (isUpToDate && !hasChangedAround(frame))) return;
    m_drawnChanges = frame.scene.glassChanges();
    listBodies(frame);
    clear();
    if (m_bodies.empty()) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    frame.scene.bindShadow(m_program);
    m_program.set("uRight", toMap(m_right));
    m_program.set("uUp", toMap(m_up));
    m_program.set("uMapCorner", m_center + m_sun * kHeight - (m_right + m_up) * (0.5f * kSide * kCell));
    m_program.set("uTexelRight", m_right * kCell);
    m_program.set("uTexelUp", m_up * kCell);
    m_program.set("uMapHeight", kHeight);
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_bodies.size() * sizeof(int)), m_bodies.data(), GL_STREAM_DRAW);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    setBlend({GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_SRC_COLOR, GL_FUNC_ADD, GL_MIN});
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, GLsizei(m_bodies.size()));
    ++frame.stats.drawCalls;
    ++frame.stats.bodyDraws;
    disableBlend();
    glDisable(GL_CULL_FACE);
}

glm::vec4 GlassShadowPass::toMap(glm::vec3 axis) const {
    constexpr float kScale = 1.0f / (kSide * kCell);
    return {axis * kScale, 0.5f - glm::dot(axis, m_center) * kScale};
}

void GlassShadowPass::bind(const Program& program, const GlassShadowPass* pass) {
    static const Texture none = Texture::none(kFormat, glm::ivec2(kSide));
    program.set("uGlassShadow", int(pass != nullptr));
    program.set("uGlassShadowMap", pass ? pass->m_map : none);
    if (!pass) return;
    program.set("uGlassShadowRight", pass->toMap(pass->m_right));
    program.set("uGlassShadowUp", pass->toMap(pass->m_up));
    program.set("uGlassShadowSun", glm::vec4(pass->m_sun, -glm::dot(pass->m_sun, pass->m_center)));
}

}  // namespace rubble
