#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Mixes "light" with what earlier pictures saw there, into the histories "accumulated" and "surface".
class AccumulatePass {
public:
    explicit AccumulatePass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    const Program& m_program;
};

}  // namespace rubble
