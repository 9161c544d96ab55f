// The uniforms of a frame, and the mapping between pixels and the world.
// render/shader_library looks for the first line of this block as it stands.
// clang-format off
layout(std140) uniform FrameBlock {
#include "shared/frame_block.h"
} frame;
// clang-format on

/// 0, which compilers do not know. They do not unroll a loop that begins with it, and a software GL leaves it where no
/// pixel of a group takes part: else it would run all steps there.
int loopBegin() { return min(frame.counters.x, 0); }

/// Direction through a point of the screen (uv in [0, 1], without jitter) with a length of 1 along the view axis:
/// position = camera + viewRay(uv) * linear depth.
vec3 viewRay(vec2 uv) {
    vec2 p = (uv + frame.jitter.xy) * 2.0 - 1.0;
    return frame.viewMiddle.xyz + frame.cameraRight.xyz * (p.x * frame.cameraRight.w) +
           frame.cameraUp.xyz * (p.y * frame.cameraUp.w);
}

/// The same for the previous frame, whose camera was at previousCameraPosition.
vec3 previousViewRay(vec2 uv) {
    vec2 p = (uv + frame.jitter.zw) * 2.0 - 1.0;
    return frame.previousViewMiddle.xyz + frame.previousCameraRight.xyz * p.x + frame.previousCameraUp.xyz * p.y;
}

/// Depth buffer value of a linear depth, by the projection of render/frame/frame_camera.cpp.
float depthBufferValue(float linear) {
    float near = frame.cameraPosition.w, far = frame.cameraForward.w;
    return far * (linear - near) / (linear * (far - near));
}

vec3 worldFromDepth(vec2 uv, float depth) { return frame.cameraPosition.xyz + viewRay(uv) * depth; }
