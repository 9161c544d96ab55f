#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Fog with shafts of light in it: its light at half the size, smoothed, then laid over "radiance".
class FogPass {
public:
    explicit FogPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;
    /// The environment has fog.
    static bool needed(const FrameContext& frame);

private:
    void drawLight(const FrameContext& frame) const;
    void drawFilter(const FrameContext& frame) const;
    void drawOver(const FrameContext& frame) const;

    FullscreenProgram& m_light;
    FullscreenProgram& m_filter;
    FullscreenProgram& m_over;
};

}  // namespace rubble
