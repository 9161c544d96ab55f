#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Smooths "accumulated" along surfaces into "lighting", in RenderSettings::filterPasses steps of growing stride.
class FilterPass {
public:
    explicit FilterPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
