#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Makes what lies open to the sky wet: draws over the G-buffer's albedo and material, so that light and reflections
/// need to know nothing of it. Made for the first level with Environment::wetness > 0.
class WetnessPass {
public:
    explicit WetnessPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
