#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Smooths "accumulatedLight" along surfaces into "denoisedLight", in RenderSettings::filterPasses steps of growing
/// stride.
class FilterPass {
public:
    explicit FilterPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
