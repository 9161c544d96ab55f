#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Adds local lights to the colour of "noisyLight", and what smooth surfaces show of them as "specular", in one draw
/// over the tiles of the view that any of them reaches.
class LocalLightsPass {
public:
    explicit LocalLightsPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;
    /// The settings want local lights and the scene has some.
    static bool needed(const FrameContext& frame);

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
