// Colour spaces.

/// Relative luminance of linear Rec. 709 colour.
float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

/// The YCoCg space: luma and two chroma axes (Malvar and Sullivan 2003).
vec3 toYCoCg(vec3 c) {
    return vec3(0.25 * c.r + 0.5 * c.g + 0.25 * c.b, 0.5 * c.r - 0.5 * c.b, -0.25 * c.r + 0.5 * c.g - 0.25 * c.b);
}
vec3 fromYCoCg(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

/// Linear to sRGB, IEC 61966-2-1.
vec3 linearToSrgb(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThan(c, vec3(0.0031308))));
}

/// sRGB to linear.
vec3 srgbToLinear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c)); }

/// What a half float holds of light, for all that is written to RGBA16F: what is too bright becomes as bright as can be
/// (a GL may write infinity instead), and NaN becomes black: history would keep such values for ever.
const float kMaxHalf = 65504.0;
float halfRange(float x) { return x > 0.0 ? min(x, kMaxHalf) : 0.0; }
vec3 halfRange(vec3 c) { return vec3(halfRange(c.r), halfRange(c.g), halfRange(c.b)); }
vec4 halfRange(vec4 c) { return vec4(halfRange(c.rgb), halfRange(c.a)); }
