#include "render/gl/gl_limits.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/gl/gl.h"

namespace rubble {
namespace {

int limitOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

GlLimits GlLimits::ofContext() {
    GlLimits limits;
    limits.textureUnits = limitOf(GL_MAX_TEXTURE_IMAGE_UNITS);
    limits.bufferTexels = isEmbedded() ? 0 : limitOf(GL_MAX_TEXTURE_BUFFER_SIZE);
    limits.textureSide = limitOf(GL_MAX_TEXTURE_SIZE);
    limits.arrayLayers = limitOf(GL_MAX_ARRAY_TEXTURE_LAYERS);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, &limits.viewport.x);
    limits.uniformBlockBytes = limitOf(GL_MAX_UNIFORM_BLOCK_SIZE);
    limits.uniformBlocks = limitOf(GL_MAX_FRAGMENT_UNIFORM_BLOCKS);
    return limits;
}

GlLimits GlLimits::least(const GlLimits& a, const GlLimits& b) {
    return {.textureUnits = std::min(a.textureUnits, b.textureUnits),
            .bufferTexels = std::min(a.bufferTexels, b.bufferTexels),
            .textureSide = std::min(a.textureSide, b.textureSide),
            .arrayLayers = std::min(a.arrayLayers, b.arrayLayers),
            .viewport = glm::min(a.viewport, b.viewport),
            .uniformBlockBytes = std::min(a.uniformBlockBytes, b.uniformBlockBytes),
            .uniformBlocks = std::min(a.uniformBlocks, b.uniformBlocks)};
}

}  // namespace rubble
