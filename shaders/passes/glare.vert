// A quad around each local light in view, for the glare that the eye's lens scatters. Its brightness follows the part
// of the light that is visible, by four rays.
#include "lib/frame.glsl"
#include "lib/sampling.glsl"
#include "lib/shadow_trace.glsl"
#include "lib/local_lights.glsl"

uniform sampler2D uDepth;  // linear

out vec2 corner;
flat out vec3 glare;  // radiance at its centre

const float kAngle = 0.055;            // radians from centre to edge
const float kScatteredShare = 0.0035;  // of a light's light
const int kRays = 4;
const float kUsualTangent = 0.58;  // of half a vertical field of view of 60 degrees

/// Share of a light's sphere that the camera sees.
float visibilityOf(LocalLight light, vec3 eye) {
    float open = 0.0;
    for (int i = 0; i < kRays; ++i) {
        vec3 toPoint = light.position +
                       light.radius * uniformSphere(vec2(0.25 * float(i), (float(i) + 0.5) / float(kRays))) -
                       eye;
        float range = length(toPoint), t;
        open +=
            shadowTrace(eye, toPoint / range, max(range - max(2.0 * light.radius, 0.25), 0.0), t)
                ? 0.0
                : 1.0;
    }
    return open / float(kRays);
}

/// Whether the ray toward a light begins inside a voxel.
bool beginsInVoxel(vec4 clip) {
    vec2 place = clamp(clip.xy / max(clip.w, 1e-4) * 0.5 + 0.5, 0.0, 0.9999);
    return texelFetch(uDepth, ivec2(place * frame.targetSize.xy), 0).r <= kNearestSurface;
}

void main() {
    const vec2 kCorners[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
    corner = kCorners[gl_VertexID];
    LocalLight light = readLight(gl_InstanceID);
    vec3 eye = eyeOf(light.position), toLight = light.position - eye;
    float range = length(toLight);
    vec4 clip = frame.viewProjection * vec4(light.position, 1.0);
    // Areas have no glare, as their surface is seen; a cone's bulb is seen a little from all sides.
    float seen = light.kind >= kArea || range < 0.3
                     ? 0.0
                     : 0.12 + 0.88 * coneAttenuation(light, -dot(toLight, light.axis) / range);
    if (beginsInVoxel(clip)) seen = 0.0;
    if (seen > 0.0) seen *= visibilityOf(light, eye) * smoothstep(0.3, 1.5, range);
    glare = light.color * (seen * kScatteredShare / (range * range * kPi * kAngle * kAngle));
    bool any_ = luminance(glare) * frame.exposure.x > 0.002;
    // Orthographic views have no angles: there it has the size that it has in a usual perspective.
    vec2 window = vec2(frame.cameraRight.w, frame.cameraUp.w);
    vec2 size = vec2(kAngle) / (isOrthographic() ? window / window.y * kUsualTangent : window);
    gl_Position = any_ ? clip + vec4(corner * size * clip.w, 0.0, 0.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_Position.z = any_ ? 0.0 : 2.0;
}
