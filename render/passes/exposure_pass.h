#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Adapts the exposure to "resolved": one texel, the history "exposure".
class ExposurePass {
public:
    explicit ExposurePass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
