#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

namespace rubble {

/// What a GL context can hold, as far as the renderer depends on it. The defaults are what GL 3.3 promises.
struct GlLimits {
    int textureUnits = 16;         ///< samplers of a program
    int64_t bufferTexels = 65536;  ///< of a buffer texture; 0: there are none
    int textureSide = 1024;        ///< pixels of a 2D texture
    int arrayLayers = 256;         ///< of an array of 2D textures
    glm::ivec2 viewport{1024};     ///< pixels
    int uniformBlockBytes = 16384;
    int uniformBlocks = 12;  ///< of a stage

    /// Those of the context that is current.
    static GlLimits ofContext();
    /// The smaller of each.
    static GlLimits least(const GlLimits& a, const GlLimits& b);
};

}  // namespace rubble
