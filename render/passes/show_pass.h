#pragma once
#include <string_view>

#include "render/frame/frame_context.h"

namespace rubble {

/// Draws one target to the view's framebuffer, scaled to what an eye can see.
class ShowPass {
public:
    /// How a target's values become a colour; the numbers are those of passes/show.frag.
    enum class Mode { Color = 0, Linear = 1, Signed = 2, Distance = 3, Motion = 4, Alpha = 5, Red = 6, History = 7 };

    explicit ShowPass(ShaderLibrary& shaders);
    /// dot: a coloured one in the corner, if its alpha is 1.
    void draw(const FrameContext& frame, const Texture& target, Mode mode, const View& view, glm::vec4 dot) const;

private:
    const Program& m_program;
};

}  // namespace rubble
