#pragma once
#include "render/gl/gl.h"

namespace rubble {

/// While it lives, triangles at the far plane cover only the pixels that show a surface, or only those of the sky. The
/// framebuffer must have the G-buffer's depth buffer. The depth test skips a pixel before its shader runs; a branch in
/// the shader would not, on a software renderer.
class DepthLimit {
public:
    enum class To { Surfaces, Sky };
    /// Sets the depth test.
    explicit DepthLimit(To to) {
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_FALSE);
        glDepthFunc(to == To::Surfaces ? GL_GREATER : GL_EQUAL);
    }
    ~DepthLimit() {
        glDisable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
    }
    DepthLimit(const DepthLimit&) = delete;
    DepthLimit& operator=(const DepthLimit&) = delete;
};

}  // namespace rubble
