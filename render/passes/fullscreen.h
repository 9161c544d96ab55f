#pragma once
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// What a full-screen draw writes into.
struct FullscreenTargets {
    TargetPool& pool;                    ///< whose the targets are
    std::vector<const Texture*> colors;  ///< by output of the shader
    const Texture* depth = nullptr;      ///< of limited programs: the depth buffer that shows where there is a surface
    std::vector<glm::vec4> clear = {};   ///< what the colours hold where nothing is drawn; empty: what they held
    int tiles = 0;  ///< squares that a vertex shader of the pass's own draws, instead of the triangle
};

/// One draw of a program over all of its targets, by triangles or by compute: the same numbers. Its targets are bound
/// and its program is in use from the constructor on.
class FullscreenDraw {
public:
    FullscreenDraw(const FrameContext& frame, FullscreenProgram& program, const FullscreenTargets& into);
    const Program& program() const { return m_program.program(m_by); }
    void run() const;

private:
    void rasterize() const;
    void dispatch() const;

    const FrameContext& m_frame;
    const FullscreenTargets& m_into;
    FullscreenMethod m_by;
    FullscreenProgram& m_program;
};

/// setUniforms gets the program, in use.
template <class SetUniforms>
void drawFullscreen(const FrameContext& frame, FullscreenProgram& program, const FullscreenTargets& into,
                    SetUniforms&& setUniforms) {
    const FullscreenDraw draw(frame, program, into);
    setUniforms(draw.program());
    draw.run();
}

}  // namespace rubble
