#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Reflections: one ray per pixel whose surface or pane reflects enough light, through the shadow volume, averaged over
/// time and filtered where the surface is not an ideal mirror. A first draw marks these pixels, so that the others cost
/// nothing.
class ReflectionsPass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit ReflectionsPass(ShaderLibrary& shaders);
    /// Fills Reflection; ReflectionMask marks the pixels that have one.
    void draw(const FrameContext& frame) const;
    /// Whether the settings want reflections and the scene has surfaces that reflect: smooth, of glass, or wet.
    static bool needed(const FrameContext& frame);

private:
    const Texture& drawMask(const FrameContext& frame) const;
    void accumulate(const FrameContext& frame, const Texture& mask) const;
    void filter(const FrameContext& frame, const Texture& mask) const;

    const Program& m_mask;
    FullscreenProgram &m_program, &m_accumulate, &m_accumulateChanged, &m_filter;
};

}  // namespace rubble
