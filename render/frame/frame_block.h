#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace rubble {

/// The uniforms of a frame, which every pass sees as `frame` (shaders/lib/frame.glsl).
struct FrameBlock {
    using vec4 = glm::vec4;
    using ivec4 = glm::ivec4;
    using mat4 = glm::mat4;
#include "shaders/shared/frame_block.h"
};

}  // namespace rubble
