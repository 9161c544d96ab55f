#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

class GlassShadowPass;

/// Light of the sky and of what hides it: cosine-weighted rays over the hemisphere with a path behind each hit.
/// Derivation: shaders/passes/sky.frag.
class SkyPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit SkyPass(ShaderLibrary& shaders);
    /// Fills the colour of NoisyLight (mean radiance) and HitProximity. glassShadow: null if there is no glass in the
    /// sun.
    void draw(const FrameContext& frame, const GlassShadowPass* glassShadow) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
