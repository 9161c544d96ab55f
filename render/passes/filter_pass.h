#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Spatial denoising: an edge-stopping a-trous filter of RenderSettings::filterPasses iterations of growing stride.
/// Derivation: shaders/passes/filter.frag.
class FilterPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit FilterPass(ShaderLibrary& shaders);
    /// Fills DenoisedLight from AccumulatedLight.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
