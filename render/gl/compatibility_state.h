#pragma once
#include <array>

#include "render/gl/gl.h"

namespace rubble {

/// What compatibility profiles have beside core ones that changes what programs draw, or what uploads hold.
struct CompatibilityState {
    /// GL_RED_SCALE, GL_RED_BIAS, and so on to GL_DEPTH_BIAS.
    static constexpr std::array<GLenum, 10> kTransfers = {0x0D14, 0x0D15, 0x0D18, 0x0D19, 0x0D1A,
                                                          0x0D1B, 0x0D1C, 0x0D1D, 0x0D1E, 0x0D1F};

    // The values of a new context.
    GLboolean alphaTest = GL_FALSE, polygonStipple = GL_FALSE, mapColor = GL_FALSE;
    GLint clampFragment = GL_FIXED_ONLY;
    std::array<GLfloat, kTransfers.size()> transfers{1, 0, 1, 0, 1, 0, 1, 0, 1, 0};

    /// As the GL has it, which must be of a compatibility profile.
    static CompatibilityState current();
    /// Makes it the GL's, which must be of a compatibility profile.
    void set() const;
};

}  // namespace rubble
