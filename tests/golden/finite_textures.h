#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render/gl/gl.h"

namespace rubble {

/// Describes the float textures of the context that hold a NaN or an infinity; empty if there is none.
inline std::string nonFiniteTextures(GLuint namesBelow = 512) {
    std::string bad;
    std::vector<float> values;
    for (GLuint name = 1; name < namesBelow; ++name) {
        if (!glIsTexture(name)) continue;
        while (glGetError() != GL_NO_ERROR) {
        }
        glBindTexture(GL_TEXTURE_2D, name);
        if (glGetError() != GL_NO_ERROR) continue;  // not a 2D texture
        GLint width = 0, height = 0, format = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
        const GLint kFloats[] = {GL_RGBA16F, GL_RGBA32F, GL_RG16F, GL_RG32F, GL_R16F, GL_R32F, GL_R11F_G11F_B10F};
        if (width == 0 || std::find(std::begin(kFloats), std::end(kFloats), format) == std::end(kFloats)) continue;
        values.resize(size_t(width) * size_t(height) * 4);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, values.data());
        const auto count = std::count_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
        if (count)
            bad += "texture " + std::to_string(name) + ", format " + std::to_string(format) + ", " +
                   std::to_string(width) + "x" + std::to_string(height) + ": " + std::to_string(count) +
                   " values are not finite; ";
    }
    return bad;
}

}  // namespace rubble
