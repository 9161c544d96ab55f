#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Writes the alpha of "noisyLight": the share of the sun's disc that each pixel sees.
class SunPass {
public:
    explicit SunPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
