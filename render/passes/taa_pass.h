#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Anti-aliases "radiance" over time into the history "resolved".
class TaaPass {
public:
    explicit TaaPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
