// Directions and points drawn with given densities from two uniform numbers u in [0, 1)^2. All are inverses of a
// cumulative distribution (Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., appendix A):
//   disc        area inside radius r is r^2, so r = sqrt(u.y); the angle is uniform
//   cosine      Malley's method: a point of the unit disc raised to the hemisphere has the density cos / pi
//   sphere      bands of equal height have equal area (Archimedes), so z is uniform
//   cone        the same within 1 - z <= 1 - cos(angle)
// Visible GGX normals: see sampleVisibleNormal().
#include "lib/constants.glsl"

/// Two unit vectors that make a right-handed basis with n (Duff et al. 2017, "Building an orthonormal basis,
/// revisited").
mat3 orthonormalBasis(vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

/// A point of the unit disc.
vec2 uniformDisc(vec2 u) {
    float angle = 2.0 * kPi * u.x;
    return sqrt(u.y) * vec2(cos(angle), sin(angle));
}

/// A direction around n with density cos / pi: the mean radiance of such directions is irradiance / pi.
vec3 cosineDirection(vec3 n, vec2 u) {
    vec2 d = uniformDisc(u);
    return normalize(orthonormalBasis(n) * vec3(d, sqrt(max(0.0, 1.0 - u.y))));
}

/// A direction of the sphere.
vec3 uniformSphere(vec2 u) {
    float z = 1.0 - 2.0 * u.y;
    float angle = 2.0 * kPi * u.x;
    return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
}

/// A direction within `angle` radians of `axis`.
vec3 coneDirection(vec3 axis, float angle, vec2 u) {
    float halfSine = sin(0.5 * angle);
    float drop = u.y * 2.0 * halfSine * halfSine;  // 1 - cosine, which for the sun would vanish in float
    float azimuth = 2.0 * kPi * u.x;
    return normalize(orthonormalBasis(axis) *
                     vec3(sqrt(drop * (2.0 - drop)) * vec2(cos(azimuth), sin(azimuth)), 1.0 - drop));
}

/// A GGX normal with the density of those visible from v, D_v = G1(v) max(0, v.h) D(h) / v.z (Heitz 2018). A GGX
/// surface is a stretched hemisphere: after scaling by alpha, v sees a plain one, and the directions reflected from its
/// visible normals fill the spherical cap z > -v.z evenly. So c is drawn from that cap, and the normal is c + v, scaled
/// back (Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"). z is up.
vec3 sampleVisibleNormal(vec3 v, float alpha, vec2 u) {
    vec3 stretched = normalize(vec3(alpha * v.xy, v.z));
    float z = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
    float angle = 2.0 * kPi * u.x;
    vec3 h = stretched + vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
    return normalize(vec3(alpha * h.xy, max(1e-4, h.z)));
}
