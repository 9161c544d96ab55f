#pragma once
#include "render/gl/offscreen.h"
#include "render/shader_library/shader_library.h"

namespace rubble {

/// Gives the samplers of all texture units one state, by the draw of one pixel. Mesa sets no sampler for a buffer
/// texture: the unit keeps that of whatever was drawn before, and llvmpipe builds a program again for other samplers.
/// After this draw a pass has the programs that it had in other frames, whatever was drawn before it.
class SamplerReset {
public:
    /// Builds its program. If that fails, draw() does nothing.
    explicit SamplerReset(ShaderLibrary& shaders);
    /// Draws. any: a texture with the samplers' state. Binds its framebuffer and program.
    void draw(const Texture& any, const VertexArray& empty) const;

private:
    const Program& m_program;
    Offscreen m_target{{1, 1}};
};

}  // namespace rubble
