const float kPi = 3.14159265;

/// Two unit vectors that make a right-handed frame with n (Duff et al., "Building an orthonormal basis, revisited").
mat3 orthonormalBasis(vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

/// Uniform on the unit disc.
vec2 uniformDisc(vec2 u) {
    float angle = 2.0 * kPi * u.x;
    return sqrt(u.y) * vec2(cos(angle), sin(angle));
}

/// A direction around n with density cos / pi: the mean radiance over these is irradiance / pi.
vec3 cosineDirection(vec3 n, vec2 u) {
    vec2 d = uniformDisc(u);
    return normalize(orthonormalBasis(n) * vec3(d, sqrt(max(0.0, 1.0 - u.y))));
}

/// Uniform on the unit sphere.
vec3 uniformSphere(vec2 u) {
    float z = 1.0 - 2.0 * u.y;
    float angle = 2.0 * kPi * u.x;
    return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
}

/// A direction within `angle` radians around `axis`, even over these.
vec3 coneDirection(vec3 axis, float angle, vec2 u) {
    float halfSine = sin(0.5 * angle);
    float drop = u.y * 2.0 * halfSine * halfSine;  // 1 - cosine: a sun's is lost in 1 - ...
    float azimuth = 2.0 * kPi * u.x;
    return normalize(orthonormalBasis(axis) * vec3(sqrt(drop * (2.0 - drop)) * vec2(cos(azimuth), sin(azimuth)), 1.0 - drop));
}

/// A half vector seen from v in proportion to what a GGX surface shows of it (Heitz 2018), by a spherical cap (Dupuy and Benyoub 2023,
/// "Sampling Visible GGX Normals with Spherical Caps"). All in the surface's frame, z up.
vec3 sampleVisibleNormal(vec3 v, float alpha, vec2 u) {
    vec3 stretched = normalize(vec3(alpha * v.xy, v.z));
    float z = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
    float angle = 2.0 * kPi * u.x;
    vec3 h = stretched + vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
    return normalize(vec3(alpha * h.xy, max(1e-4, h.z)));
}
