// What a display shows of exposed radiance: a film curve and a slight vignette. Needs lib/color.

const float kFilmExposure = 0.5;  // a white wall in the default evening sun then has three quarters of display white

/// A fit of the ACES film curve (Narkowicz 2015) with a lighter toe, so that shadows keep their colour.
vec3 filmCurve(vec3 x) { return clamp((x * (2.51 * x + 0.05)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

/// Its inverse, of 0 to 1: the positive root of (2.51 - 2.43 y) x^2 + (0.05 - 0.59 y) x - 0.14 y.
vec3 inverseFilmCurve(vec3 y) {
    vec3 a = 2.51 - 2.43 * y, b = 0.05 - 0.59 * y;
    return (sqrt(b * b + 0.56 * a * y) - b) / (2.0 * a);
}

/// Share of light that is left toward the corners of the image.
float vignetteAt(vec2 uv) {
    vec2 aside = (uv - 0.5) * vec2(1.0, 0.8);
    float r2 = dot(aside, aside);
    return 1.0 - 0.5 * r2 * r2 - 0.12 * r2;
}

vec3 toDisplay(vec3 exposed, vec2 uv) { return linearToSrgb(filmCurve(exposed * vignetteAt(uv) * kFilmExposure)); }
vec3 fromDisplay(vec3 color, vec2 uv) {
    return inverseFilmCurve(srgbToLinear(clamp(color, 0.0, 1.0))) / (vignetteAt(uv) * kFilmExposure);
}
