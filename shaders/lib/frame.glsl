// The frame's uniforms, and the way between pixels and the world.
layout(std140) uniform FrameBlock {
#include "shared/frame_block.h"
} frame;

// Direction through a point of the screen (uv in [0, 1], jitter included by the caller's uv), with 1 along the view axis:
// position = camera + viewRay * linear depth.
vec3 viewRay(vec2 uv) {
    vec2 p = (uv + frame.jitter.xy) * 2.0 - 1.0;
    return frame.cameraForward.xyz + frame.cameraRight.xyz * (p.x * frame.cameraRight.w) + frame.cameraUp.xyz * (p.y * frame.cameraUp.w);
}

vec3 worldFromDepth(vec2 uv, float depth) { return frame.cameraPosition.xyz + viewRay(uv) * depth; }
