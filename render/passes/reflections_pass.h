#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// What smooth surfaces and panes mirror, into "reflection".
class ReflectionsPass {
public:
    explicit ReflectionsPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;
    /// Whether any material of the scene could mirror something: else there is neither pass nor target.
    static bool needed(const FrameContext& frame);

private:
    const Program& m_mask;
    FullscreenProgram& m_program;
};

}  // namespace rubble
