#pragma once
#include <span>

#include "render/frame/frame_context.h"

namespace rubble {

/// Draws one target to the view's framebuffer, mapped to visible colours. Where the view composes depth, what its
/// framebuffer holds nearer stays, and the depth of the voxels is written.
class ShowPass {
public:
    /// How a target's values become a colour; the numbers are those of passes/show_data.frag.
    enum class Mode { Color, Linear, Signed, Distance, Motion, Alpha, History, Exposed };
    /// A target that can be shown, and how.
    struct TargetView {
        const char* name;  ///< for Renderer::showPass()
        Target target;
        Mode mode;
    };
    /// All of them; the first one is the final image.
    static std::span<const TargetView> views();
    /// The targets that draw() reads for a view.
    static TargetSet reads(const TargetView& shown);

    /// Builds its programs. If one fails, shaders.errors() says why and draw() does nothing.
    explicit ShowPass(ShaderLibrary& shaders);
    /// Shows the blue noise where no pass has drawn the target. statusDot: colour of a dot in the corner, if its alpha
    /// is 1. A linear view shows its radiance instead of the final image. depth: linear, of the voxels, in any size.
    void draw(const FrameContext& frame, const TargetView& shown, const View& view, const Texture& depth,
              glm::vec4 statusDot) const;

private:
    const Program& m_image;  ///< for modes Color and Exposed
    const Program& m_data;   ///< for the others, which cost more
};

}  // namespace rubble
