// Crumbs and splinters of glass as small tumbling cubes.
#include "lib/particle.glsl"

/// A box with a random rotation that changes with age, by a ray-box intersection in its own space.
vec4 cube() {
    vec3 spin = stateOut.yzw * kTwoPi + stateOut.x * vec3(9.0, 13.0, 7.0) + depths.w;
    vec3 s = sin(spin), c = cos(spin);
    mat3 turn = mat3(c.y * c.z, c.y * s.z, -s.y, s.x * s.y * c.z - c.x * s.z, s.x * s.y * s.z + c.x * c.z, s.x * c.y,
                     c.x * s.y * c.z + s.x * s.z, c.x * s.y * s.z - s.x * c.z, c.x * c.y);
    vec3 size = kind == kGlint ? vec3(1.0, 0.75, 0.12) : vec3(1.0, 0.6 + 0.4 * stateOut.y, 0.45 + 0.55 * stateOut.z);
    vec3 forward = frame.cameraForward.xyz;
    vec3 origin = (frame.cameraRight.xyz * corner.x + frame.cameraUp.xyz * corner.y - forward * 3.0) * turn,
         direction = forward * turn;
    vec3 inverse = 1.0 / (direction + vec3(1e-5));
    vec3 low = (-size - origin) * inverse, high = (size - origin) * inverse;
    vec3 first = min(low, high), last = max(low, high);
    float enter = max(first.x, max(first.y, first.z));
    if (enter > min(last.x, min(last.y, last.z))) discard;
    vec3 normal = turn * (-sign(direction) * step(vec3(enter - 1e-4), first));
    if (kind == kCrumb)
        return vec4(tintOut.rgb *
                        (sunLight * max(dot(normal, frame.sunDirection.xyz), 0.0) + airLight * (0.7 + 0.3 * normal.y)),
                    1.0) *
               tintOut.a;
    // Glass reflects the sky and, at the right angle, the sun.
    vec3 mirrored = reflect(-toEye(particle.xyz), normal);
    float flash = pow(max(dot(mirrored, frame.sunDirection.xyz), 0.0), 24.0);
    return vec4(airLight * (0.5 + 0.4 * mirrored.y) + sunLight * (flash * 9.0), 0.6) * tintOut.a;
}

void main() {
    if (depths.x - particle.w > surfaceDepth()) discard;
    color = applyHaze(cube());
}
