#include "render/passes/overlay_pass.h"

#include "render/gl/draw_state.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr GLuint kQuadAttributes = sizeof(OverlayQuad) / sizeof(glm::vec4);

OverlayCamera cameraOf(const FrameContext& frame, const View& view) {
    const glm::dvec3 origin = frame.scene.origin();
    glm::dmat4 toOrigin(1.0);
    toOrigin[3] = glm::dvec4(-origin, 1.0);
    return {glm::dmat4(frame.block.viewProjectionPlain) * toOrigin, glm::dvec3(frame.block.cameraPosition) + origin,
            glm::dvec3(frame.block.cameraForward), view.rotation, glm::vec2(view.size)};
}

/// Pixels with premultiplied alpha: what is beside an image's edge does not shine through.
std::vector<uint8_t> premultiplied(std::vector<uint8_t> pixels) {
    for (size_t i = 0; i + 3 < pixels.size(); i += 4)
        for (size_t channel = 0; channel < 3; ++channel)
            pixels[i + channel] = uint8_t((pixels[i + channel] * pixels[i + 3] + 127) / 255);
    return pixels;
}

}  // namespace

OverlayPass::OverlayPass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/overlay.frag", "passes/overlay.vert", "the overlay is not drawn")) {
    glBindVertexArray(m_vertexArray.get());
    for (GLuint i = 0; i < kQuadAttributes; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glBindVertexArray(0);
}

uint64_t OverlayPass::bytes() const {
    uint64_t sum = m_glyphs.bytes();
    for (const auto& [name, image] : m_images) sum += image.bytes();
    return sum;
}

/// An atlas without room is emptied, and filled with the glyphs of this frame.
void OverlayPass::fill(const FrameContext& frame, Overlay& overlay, const View& view) {
    const OverlayCamera camera = cameraOf(frame, view);
    fillQuads(overlay, camera, *m_atlas, m_quads);
    if (!m_quads.areGlyphsMissing) return;
    m_atlas->clear();
    fillQuads(overlay, camera, *m_atlas, m_quads);
    if (m_quads.areGlyphsMissing && !std::exchange(m_hasWarned, true))
        logWarning("the overlay has more different letters than a texture has room for; some are not drawn");
}

void OverlayPass::uploadGlyphs() {
    if (m_glyphVersion == m_atlas->version() || !m_atlas->size().y) return;
    if (m_glyphs.size() != m_atlas->size()) m_glyphs = Texture(GL_R8, m_atlas->size(), Filter::Linear);
    m_glyphs.upload(m_atlas->texels().data());
    m_glyphVersion = m_atlas->version();
}

void OverlayPass::uploadImages(Overlay& overlay) {
    std::erase_if(m_images, [&](const auto& image) { return !overlay.images().count(image.first); });
    for (auto& [name, image] : overlay.images()) {
        if (image.pixels.empty()) continue;
        Texture& made = m_images[name];
        if (made.size() != image.size) made = Texture(GL_RGBA8, image.size, Filter::Linear);
        made.upload(premultiplied(std::exchange(image.pixels, {})).data());
    }
}

void OverlayPass::drawRun(const OverlayRun& run) const {
    const auto image = m_images.find(run.image);
    static const Texture kNone = Texture::none(GL_RGBA8, {1, 1}, Filter::Linear);
    m_program.set("uImage", image == m_images.end() ? kNone : image->second);
    for (GLuint i = 0; i < kQuadAttributes; ++i)
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(OverlayQuad),
                              reinterpret_cast<const void*>(run.first * sizeof(OverlayQuad) + i * sizeof(glm::vec4)));
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, GLsizei(run.count));
}

void OverlayPass::draw(const FrameContext& frame, Overlay& overlay, const View& view, const Texture& depth,
                       int maxTextureSide) {
    if (!m_program) return;
    if (!m_atlas) m_atlas.emplace(maxTextureSide);
    uploadImages(overlay);
    fill(frame, overlay, view);
    uploadGlyphs();
    if (m_quads.quads.empty()) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    m_program.use();
    m_program.set("uGlyphs", m_glyphs);
    m_program.set("uDepth", depth);
    m_program.set("uViewSize", glm::vec2(view.size));
    m_program.set("uFlipped", view.isFlipped);
    m_program.set("uLinear", view.isLinear);
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_quads.quads.size() * sizeof(OverlayQuad)), m_quads.quads.data(),
                 GL_STREAM_DRAW);
    setBlend({GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA});
    for (const OverlayRun& run : m_quads.runs) {
        drawRun(run);
        ++frame.stats.drawCalls;
    }
    disableBlend();
}

}  // namespace rubble
