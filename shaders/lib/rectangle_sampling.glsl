// Directions to a rectangle, uniform over the solid angle that it takes: C. Ureña, M. Fajardo, A. King, "An
// Area-Preserving Parametrization for Spherical Rectangles", Eurographics Symposium on Rendering 2013. Uniform over its
// area would take few directions to a near part of a large rectangle, and each would count very much.
//
// Coordinates are along the rectangle's two sides and its normal, from the point that looks at it. The planes through
// that point and the sides cut its unit sphere into a quadrilateral whose inner angles say its solid angle (Girard).
#include "lib/constants.glsl"

struct SphericalRectangle {
    vec2 low, high;    // of the rectangle along its sides, metres
    float away;        // coordinate of its plane, metres, below 0
    vec4 planes;       // coordinate along the normal of the normals of the planes: below, right, above, left
    float offset;      // 2 pi less the angles at the left side
    float solidAngle;  // sr
};

/// From the rectangle's centre and half its size.
SphericalRectangle sphericalRectangle(vec3 centre, vec2 halfSize) {
    vec2 low = centre.xy - halfSize, high = centre.xy + halfSize;
    float away = -max(abs(centre.z), 1e-4);
    vec4 sides = vec4(-low.y, high.x, high.y, -low.x), planes = sides * inversesqrt(sides * sides + away * away);
    vec4 angles = acos(clamp(-planes * planes.yzwx, -1.0, 1.0));
    float offset = 2.0 * kPi - angles.z - angles.w;
    return SphericalRectangle(low, high, away, planes, offset, angles.x + angles.y - offset);
}

/// The angle in sampleRectangle(). u: uniform in [0, 1).
float rectangleAngle(SphericalRectangle r, float u) { return u * r.solidAngle + r.offset; }

/// A point of the rectangle along its sides, whose direction has the density 1 / solidAngle. turn: cosine and sine of
/// rectangleAngle(). u: uniform in [0, 1).
vec2 sampleRectangle(SphericalRectangle r, vec2 turn, float u) {
    float f = (turn.x * r.planes.x - r.planes.z) / (abs(turn.y) < 1e-6 ? 1e-6 : turn.y);
    float cosine = (f > 0.0 ? 1.0 : -1.0) * min(inversesqrt(max(f * f + r.planes.x * r.planes.x, 1e-12)), 1.0);
    float x = clamp(-cosine * r.away * inversesqrt(max(1.0 - cosine * cosine, 1e-12)), r.low.x, r.high.x);
    float range2 = x * x + r.away * r.away;
    vec2 ends = vec2(r.low.y, r.high.y), sines = ends * inversesqrt(range2 + ends * ends);
    float height = mix(sines.x, sines.y, u);
    float y = clamp(height * sqrt(range2) * inversesqrt(max(1.0 - height * height, 1e-12)), r.low.y, r.high.y);
    return vec2(x, y);
}
