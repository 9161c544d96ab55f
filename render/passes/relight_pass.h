#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// By how much the light of each pixel differs from its history where lights are others than in the previous frame:
/// direct light by shadow rays (shaders/passes/changed_lights.frag), and what came by bounces as the mean over many
/// pixels (shaders/passes/light_offset.frag). Temporal accumulation adds both to the history, which then holds for the
/// lights of this frame and need not be dropped.
class RelightPass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit RelightPass(ShaderLibrary& shaders);
    /// Fills ChangedLight and LightOffset, as far as there are changes for them.
    void draw(const FrameContext& frame) const;
    /// Whether a light is another, or it is known that light has changed, and there is a history.
    static bool needed(const FrameContext& frame);
    /// Sets the uniforms uChangedLight and uLightOffset, and whether there are any. The program must be in use.
    static void bind(const Program& program, const FrameContext& frame);

private:
    void sampleDifferences(const FrameContext& frame) const;
    void findOffset(const FrameContext& frame) const;

    FullscreenProgram& m_differences;
    FullscreenProgram& m_offset;
    FullscreenProgram& m_offsetFilter;
};

}  // namespace rubble
