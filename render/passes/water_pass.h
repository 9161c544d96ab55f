#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

struct VisibleWater;

/// Draws the waters in view over the radiance: what is seen through them is absorbed along its path. From above it is
/// refracted by the waves, what is around is reflected by rays, and foam lies where the water ends. From below the
/// surface shows Snell's window and mirrors around it.
class WaterPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit WaterPass(ShaderLibrary& shaders);
    /// Draws over Radiance. hasPanes: over PaneLight too.
    void draw(const FrameContext& frame, bool hasPanes);

private:
    /// Copies the image in a rectangle.
    static void copy(const FrameContext& frame, const PixelRect& part, bool hasPanes);
    /// copied: the part of BehindWater that holds the image.
    void drawOne(const FrameContext& frame, const VisibleWater& water, const PixelRect& copied, bool hasPanes) const;

    FullscreenProgram& m_program;
    BufferTexture m_corners{GL_RGBA32F};  ///< of the areas of all waters in view
};

}  // namespace rubble
