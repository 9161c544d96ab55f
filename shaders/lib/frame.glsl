// The uniforms of a frame, and the mapping between pixels and the world.
#include "lib/constants.glsl"
// render/shader_library looks for the first line of this block as it stands.
// clang-format off
layout(std140) uniform FrameBlock {
#include "shared/frame_block.h"
} frame;
// clang-format on

/// 0, which compilers do not know. They do not unroll a loop that begins with it, and a software GL leaves it where no
/// pixel of a group takes part: else it would run all steps there. Mesa unrolls any other loop over a uniform array, as
/// the array's length bounds its steps.
///
/// Loops of unknown length are written do {...} while (++i < n), and begin with `if (n == 0) break;` where there may be
/// no step. A software GL leaves a loop only at its end: `for`, which asks at its beginning, runs a whole step more.
int loopBegin() { return min(frame.counters.x, 0); }

/// Whether the rays of all pixels are parallel: they begin side by side, in the plane through the camera.
bool isOrthographic() { return frame.viewMiddle.w > 0.0; }

/// A point or direction of the middle of the image, moved to a point of the screen (uv in [0, 1], without jitter).
vec3 movedAcross(vec3 middle, vec2 uv) {
    vec2 p = (uv + frame.jitter.xy) * 2.0 - 1.0;
    return middle + frame.cameraRight.xyz * (p.x * frame.cameraRight.w) + frame.cameraUp.xyz * (p.y * frame.cameraUp.w);
}

/// The ray through a point of the screen, with a length of 1 along the view axis, and where it begins:
/// position = viewOrigin(uv) + viewRay(uv) * linear depth.
vec3 viewRay(vec2 uv) { return isOrthographic() ? frame.viewMiddle.xyz : movedAcross(frame.viewMiddle.xyz, uv); }
vec3 viewOrigin(vec2 uv) {
    return isOrthographic() ? movedAcross(frame.cameraPosition.xyz, uv) : frame.cameraPosition.xyz;
}
vec3 worldFromDepth(vec2 uv, float depth) { return viewOrigin(uv) + viewRay(uv) * depth; }

/// The same in the previous frame.
vec3 previousWorldFromDepth(vec2 uv, float depth) {
    vec2 p = (uv + frame.jitter.zw) * 2.0 - 1.0;
    vec3 across = frame.previousCameraRight.xyz * p.x + frame.previousCameraUp.xyz * p.y;
    return frame.previousCameraPosition.xyz + frame.previousViewMiddle.xyz * depth +
           across * (isOrthographic() ? 1.0 : depth);
}

/// Linear depth of a position, now and in the previous frame. An orthographic view's
/// middle ray is its axis, and depth is linear in its clip space.
float viewDepth(vec3 position) { return dot(position - frame.cameraPosition.xyz, frame.cameraForward.xyz); }
float previousDepth(vec3 position) {
    vec4 clip = frame.previousViewProjection * vec4(position, 1.0);
    return isOrthographic() ? (clip.z * 0.5 + 0.5) * kSkyDepth : clip.w;
}

/// Where the ray that shows a position begins, and the unit vector from the position toward there.
vec3 eyeOf(vec3 position) {
    vec3 axis = frame.viewMiddle.xyz, eye = frame.cameraPosition.xyz;
    return isOrthographic() ? position - axis * dot(position - eye, axis) : eye;
}
vec3 toEye(vec3 position) {
    return isOrthographic() ? -frame.viewMiddle.xyz : normalize(frame.cameraPosition.xyz - position);
}
/// Where the ray began that showed a position in the previous frame.
vec3 previousEyeOf(vec3 position) {
    mat4 m = frame.previousViewProjection;
    vec3 axis = vec3(m[0].z, m[1].z, m[2].z) * (0.5 * kSkyDepth);
    return isOrthographic() ? position - axis * previousDepth(position) : frame.previousCameraPosition.xyz;
}

/// Width of what is seen, relative to that at a depth of 1.
float viewScale(float depth) { return isOrthographic() ? 1.0 : depth; }
/// Height of a pixel at a linear depth, metres.
float pixelMetres(float depth) { return 2.0 * frame.cameraUp.w * frame.targetSize.w * viewScale(depth); }

/// Depth buffer value of a linear depth, by the projections of render/frame/frame_camera.cpp.
float depthBufferValue(float linear) {
    float near = frame.cameraPosition.w, far = frame.cameraForward.w;
    return isOrthographic() ? linear / far : far * (linear - near) / (linear * (far - near));
}

/// The same of a surface. It is never that of the sky, 1, which floats would round the value of a far surface to.
float surfaceDepthValue(float linear) {
    return clamp(depthBufferValue(max(linear, frame.cameraPosition.w)), 0.0, kFarthestDepthValue);
}
