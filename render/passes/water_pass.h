#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Draws water surfaces over the radiance: what is below is refracted by the waves and absorbed along its path through
/// the water, what is around is reflected by rays, and foam lies where the water ends. Only from above; of an outline
/// the first 32 corners count.
class WaterPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit WaterPass(ShaderLibrary& shaders);
    /// Draws over Radiance.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
