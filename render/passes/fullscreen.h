#pragma once
#include <optional>
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// What a full-screen draw writes into.
struct FullscreenTargets {
    std::vector<const Texture*> colors;  ///< by output of the shader
    const Texture* depth = nullptr;  ///< for FullscreenKind::surfacesOnly: the G-buffer's depth buffer, or another mask
    std::vector<glm::vec4> clear = {};  ///< values of the colours before the draw; empty: they are not cleared
    int tiles = 0;                      ///< squares that the pass's own vertex shader draws, instead of the triangle
    int corners = 0;  ///< of a convex polygon that it draws as a fan; by compute all of `area` is drawn
    std::optional<PixelRect> area = {};  ///< only these pixels are drawn; `clear` must be empty
};

/// One draw of a program over all of its targets, by triangles or by compute, with the same result. From the
/// constructor to run() its targets are bound and its program is in use.
class FullscreenDraw {
public:
    /// `into` must outlive it.
    FullscreenDraw(const FrameContext& frame, FullscreenProgram& program, const FullscreenTargets& into);
    /// The program that draws, to set uniforms.
    const Program& program() const { return m_program.program(m_method); }
    /// Draws.
    void run() const;

private:
    void rasterize() const;
    void dispatch() const;

    const FrameContext& m_frame;
    const FullscreenTargets& m_into;
    FullscreenMethod m_method;
    FullscreenProgram& m_program;
};

/// Draws a program over all of its targets. setUniforms(program) is called with the program in use.
template <class SetUniforms>
void drawFullscreen(const FrameContext& frame, FullscreenProgram& program, const FullscreenTargets& into,
                    SetUniforms&& setUniforms) {
    const FullscreenDraw draw(frame, program, into);
    setUniforms(draw.program());
    draw.run();
}

}  // namespace rubble
