#include "render/passes/host_layers_pass.h"

#include "render/gl/draw_state.h"
#include "render/passes/fog_pass.h"
#include "render/passes/glass_pass.h"
#include "render/passes/host_depth.h"
#include "render/passes/particles_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/passes/water_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr const char* kNoLayers = "glass, water and fog are not drawn over what the host has drawn";

/// Copies what a framebuffer's read buffer holds of colour or depth.
void copyFramebuffer(const Texture& into) {
    bindForUpload(GL_TEXTURE_2D, into.name());
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, into.size().x, into.size().y);
}

/// Whether blits can copy the depth of the framebuffer that is bound: OpenGL ES changes no format.
bool canBlitDepth(unsigned framebuffer) {
    const GLenum depth = framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
    GLint type = GL_NONE, bits = 0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    return type == GL_FLOAT && bits == 32;
}

/// The same as two copyFramebuffer() in OpenGL ES, which copies neither depths nor colours to floats but by a blit.
void blitFramebuffer(unsigned from, const Framebuffer& color, const Framebuffer& depth) {
    const glm::ivec2 size = color.size();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    for (const auto& [into, what] : {std::pair(&color, GL_COLOR_BUFFER_BIT), std::pair(&depth, GL_DEPTH_BUFFER_BIT)}) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, into->name());
        glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GLbitfield(what), GL_NEAREST);
    }
}

/// Copies what mirrors show to the displayed pixels.
void copyReflection(const FrameContext& frame) {
    if (!ReflectionsPass::needed(frame) || !frame.scene.hasGlass()) return;
    const Texture& from = frame.mainTargets->at(Target::Reflection);
    const Texture& into = frame.targets.target(Target::Reflection);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.mainTargets->framebuffer({&from}).name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.targets.framebuffer({&into}).name());
    glBlitFramebuffer(0, 0, from.size().x, from.size().y, 0, 0, into.size().x, into.size().y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

}  // namespace

HostLayersPass::HostLayersPass(ShaderLibrary& shaders)
    : m_image(shaders.load("passes/host_image.frag", "lib/fullscreen.vert", kNoLayers)),
      m_layers(shaders.load("passes/host_layers.frag", "lib/fullscreen.vert", kNoLayers)) {}

bool HostLayersPass::needed(const FrameContext& frame, const View& view) {
    const Scene& scene = frame.scene;
    return view.composesDepth() &&
           (scene.hasGlass() || !scene.waters().empty() || !scene.particles().empty() || FogPass::needed(frame));
}

/// False if there is no image of one sample a pixel.
bool HostLayersPass::copyImage(const FrameContext& frame, const View& view) const {
    const Texture& color = frame.targets.target(Target::HostColor);
    const Texture& depth = frame.targets.target(Target::HostDepth);
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    GLint samples = 0, drawn = GL_NONE, read = GL_NONE;
    glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
    glGetIntegerv(GL_DRAW_BUFFER0, &drawn);
    glGetIntegerv(GL_READ_BUFFER, &read);
    if (samples > 0 || drawn == GL_NONE || (isEmbedded() && !canBlitDepth(view.framebuffer))) return false;
    glReadBuffer(GLenum(drawn));
    if (isEmbedded()) {
        const Framebuffer &intoColor = frame.targets.framebuffer({&color}),
                          &intoDepth = frame.targets.framebuffer({}, &depth);
        blitFramebuffer(view.framebuffer, intoColor, intoDepth);
    } else {
        copyFramebuffer(color);
        copyFramebuffer(depth);
    }
    glReadBuffer(GLenum(read));
    return true;
}

void HostLayersPass::bind(const Program& program, const FrameContext& frame, const View& view) const {
    program.set("uHostColor", frame.targets.at(Target::HostColor));
    program.set("uFlipped", view.isFlipped);
    program.set("uLinear", view.isLinear);
    program.set("uExposure", frame.mainTargets->at(Target::Exposure));
}

/// Fills Radiance, Depth, GlassMask and DepthBuffer with the host's image.
void HostLayersPass::takeOver(const FrameContext& frame, const View& view, const Texture& depth) const {
    TargetPool& targets = frame.targets;
    targets
        .framebuffer({&targets.history(Target::Radiance).current, &targets.target(Target::Depth),
                      &targets.target(Target::GlassMask)},
                     &targets.target(Target::DepthBuffer))
        .begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    m_image.use();
    bind(m_image, frame, view);
    setHostDepth(m_image, view);
    m_image.set("uHostDepth", targets.at(Target::HostDepth));
    m_image.set("uDepth", depth);
    frame.drawTriangle();
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void HostLayersPass::draw(const FrameContext& frame, const View& view, const Texture& depth, const Layers& layers,
                          float alpha) {
    m_isDrawn = false;
    if (!m_image || !m_layers || !copyImage(frame, view)) return;
    m_isDrawn = true;
    takeOver(frame, view, depth);
    const bool hasGlass = frame.scene.hasGlass(), hasWater = layers.water && !frame.scene.waters().empty();
    bool hasPaneLight = false;
    if (hasGlass) {
        copyReflection(frame);
        layers.glass.draw(frame, layers.tiles);
        hasPaneLight = hasWater && layers.glass.drawLight(frame, layers.tiles);
    }
    if (hasWater) layers.water->draw(frame, hasPaneLight);
    if (hasGlass) layers.glass.drawOver(frame, layers.tiles, hasPaneLight);
    if (layers.fog && FogPass::needed(frame)) layers.fog->drawOver(frame, frame.mainTargets->at(Target::Fog));
    if (layers.particles && !frame.scene.particles().empty()) layers.particles->draw(frame, alpha);
}

void HostLayersPass::show(const FrameContext& frame, const View& view) {
    if (!m_isDrawn) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    m_layers.use();
    bind(m_layers, frame, view);
    m_layers.set("uRadiance", frame.targets.history(Target::Radiance).current);
    m_layers.set("uDepth", frame.targets.at(Target::Depth));
    frame.drawTriangle();
}

}  // namespace rubble
