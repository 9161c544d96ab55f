#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rubble {

/// The uniforms of a frame, which every pass sees as `frame` (shaders/lib/frame.glsl).
struct FrameBlock {
    using vec4 = glm::vec4;
    using ivec4 = glm::ivec4;
    using mat4 = glm::mat4;
#include "shaders/shared/frame_block.h"

    /// Whether the rays of all pixels are parallel, as in lib/frame.glsl.
    bool isOrthographic() const {
        return viewMiddle.w > 0.0f;
    }
    /// The same view at the displayed pixels, without jitter.
    FrameBlock atDisplayedPixels() const {
        FrameBlock shown = *this;
        shown.targetSize = displaySize;
        shown.jitter = glm::vec4(0.0f);
        shown.viewProjection = viewProjectionPlain;
        return shown;
    }
    /// What a place of the image adds to the ray of its middle, or to where that begins if the view is orthographic.
    /// place: -1 to 1.
    glm::vec3 across(glm::vec2 place) const {
        return glm::vec3(cameraRight) * (place.x * cameraRight.w) + glm::vec3(cameraUp) * (place.y * cameraUp.w);
    }
    /// Where the ray through a place of the image begins, without jitter. place: -1 to 1.
    glm::vec3 rayStart(glm::vec2 place) const {
        return isOrthographic() ? glm::vec3(cameraPosition) + across(place) : glm::vec3(cameraPosition);
    }
    /// That ray, 1 long along the view axis.
    glm::vec3 ray(glm::vec2 place) const {
        return isOrthographic() ? glm::vec3(viewMiddle) : glm::vec3(viewMiddle) + across(place);
    }
};

}  // namespace rubble
