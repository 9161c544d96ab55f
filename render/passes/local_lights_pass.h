#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Adds sphere and cone lights to the colour of "light", each within the part of the view that it can reach. Draws nothing
/// for lights whose reach the view does not meet.
class LocalLightsPass {
public:
    explicit LocalLightsPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    const Program& m_program;
};

}  // namespace rubble
