// The sky and the landscape around the level, all of them painted by formula, not physical models. Directions are unit
// vectors in world space, y up; results are radiance.
#include "lib/constants.glsl"
#include "lib/frame.glsl"
#include "lib/noise.glsl"

/// The glow around the sun: light that air and thin cloud scatter forward. mu: cosine of the angle to the sun.
vec3 sunGlow(float mu) {
    float m = max(mu, 0.0);
    float m2 = m * m;
    float m8 = m2 * m2 * m2 * m2;
    float m32 = m8 * m8 * m8 * m8;
    float m256 = pow(m32, 8.0);
    return frame.sunColor.rgb * (0.012 * m2 + 0.035 * m8 + 0.10 * m32 + 0.45 * m256);
}

/// The clear sky without sun disc, clouds and hills. It is smooth, so that rays which leave the world make little
/// noise.
vec3 skyRadiance(vec3 direction) {
    float mu = dot(direction, frame.sunDirection.xyz);
    float up = max(direction.y, 0.0);
    vec3 sky = mix(frame.horizonColor.rgb, frame.skyColor.rgb, 1.0 - pow(1.0 - min(up, 1.0), 4.0));
    sky += sunGlow(mu) * (1.0 - 0.6 * up);
    return mix(frame.groundColor.rgb, sky, smoothstep(-0.06, 0.02, direction.y));
}

/// The point of the compass that a direction goes to, of length 1; 0 straight up and down.
vec2 headingOf(vec3 direction) { return direction.xz / max(length(direction.xz), 1e-6); }

/// Light that the haze scatters into a ray toward a far point.
vec3 hazeRadiance(vec3 direction) { return frame.fogColor.rgb + sunGlow(dot(direction, frame.sunDirection.xyz)) * 0.5; }

/// Share of light that the haze takes over a distance: a half at the environment's fogDistance, little nearby.
float hazeAmount(float distanceMetres) {
    float ratio = distanceMetres / frame.fogColor.w;
    return 1.0 - exp2(-ratio * sqrt(ratio));
}

/// A view out of the level through the haze. Ordinary haze is a part of the colours of hills and fields, and the sky is
/// clear; one that hides things within some ten metres hides the background too, and the lower sky before the upper.
vec3 throughHaze(vec3 background, vec3 direction) {
    float clear = mix(100.0, 40.0, smoothstep(0.0, 0.3, direction.y));
    return mix(hazeRadiance(direction), background, smoothstep(5.0, clear, frame.fogColor.w));
}

/// Metres through which the haze hides hills; more where the air is clearer than usual. Fields are not hidden by more
/// than those of kFarthestFields, as a white band below hills would look like water.
const float kFarHills = 300.0, kMiddleHills = 234.0, kWoods = 181.0, kFarthestFields = 225.0;
float landscapeMetres(float metres) { return metres * max(1.0, frame.fogColor.w / 150.0); }
float landscapeHaze(float metres) { return hazeAmount(landscapeMetres(metres)); }

/// Adds clouds: fractal noise on a plane overhead, lit by the difference of thickness toward the sun.
vec3 withClouds(vec3 sky, vec3 direction) {
    float height = direction.y + 0.06;
    if (height < 0.07) return sky;
    vec2 place = direction.xz / height * 1.3 + 40.0;
    // Stretched along one axis, and faded toward the horizon, where perspective would crowd them.
    vec2 stretched = place * vec2(0.75, 1.25);
    float density = fractalNoise(stretched, 6) * 0.75 + valueNoise(stretched * 0.35 + 9.1) * 0.35;
    float more = (frame.skyCover.x - 0.5) * 0.9;
    float cover = smoothstep(0.52 - more, 0.80 - more, density);
    if (cover <= 0.0) return sky;
    vec2 toSun = headingOf(frame.sunDirection.xyz) * 0.35;
    float thickness = fractalNoise(stretched + toSun, 4) * 0.75 + valueNoise((stretched + toSun) * 0.35 + 9.1) * 0.35;
    float lit = clamp(1.0 - (thickness - 0.45) * 2.6, 0.0, 1.0);
    float mu = max(dot(direction, frame.sunDirection.xyz), 0.0);
    vec3 shade = mix(frame.skyColor.rgb, frame.horizonColor.rgb, 0.55) * 0.75;
    vec3 bright = frame.sunColor.rgb * (0.13 + 0.16 * pow(mu, 6.0)) + frame.skyColor.rgb * 0.35;
    vec3 cloud = mix(shade, bright, lit);
    float fade = smoothstep(0.07, 0.30, height);
    return mix(sky, cloud, cover * 0.85 * fade);
}

/// Outline of a range of hills: tangent of its elevation in a direction of the compass, periodic around the horizon.
float hillLine(vec2 heading, float frequency, float seed, int octaves) {
    return fractalNoise(heading * frequency + seed, octaves);
}

/// Adds three ranges of hills, the farthest first, each mixed with the haze. None is higher than kMaxHillSlope.
vec3 withHills(vec3 sky, vec3 direction) {
    vec2 heading = headingOf(direction);
    float slope = direction.y / max(length(direction.xz), 1e-4);
    if (slope > kMaxHillSlope) return sky;
    vec3 haze = hazeRadiance(direction);
    vec3 light = frame.sunColor.rgb * 0.06 + frame.skyColor.rgb * 0.35;
    float pixel = 0.0022;  // softens the outline by about a pixel
    float far = 0.035 + 0.085 * hillLine(heading, 3.1, 11.0, 4);
    sky = mix(sky, mix(vec3(0.16, 0.20, 0.24) * light, haze, landscapeHaze(kFarHills)),
              smoothstep(pixel, -pixel, slope - far));
    float middle = 0.015 + 0.060 * hillLine(heading, 5.7, 47.0, 5);
    sky = mix(sky, mix(vec3(0.14, 0.20, 0.13) * light, haze, landscapeHaze(kMiddleHills)),
              smoothstep(pixel, -pixel, slope - middle));
    float woods = 0.004 + 0.024 * hillLine(heading, 9.0, 83.0, 3) + 0.010 * hillLine(heading, 140.0, 5.0, 3);
    float shading = 0.75 + 0.5 * valueNoise(vec2(atan(heading.y, heading.x) * 160.0, slope * 500.0));
    sky = mix(sky, mix(vec3(0.13, 0.18, 0.08) * light * shading, haze, landscapeHaze(kWoods)),
              smoothstep(pixel, -pixel, slope - woods));
    return sky;
}

/// Fields from the level's edge to the horizon, on a plane a little below the ground, seen from a point over it.
vec3 fieldsBelow(vec3 origin, vec3 direction) {
    float distanceMetres = (origin.y - frame.skyCover.z) / max(-direction.y, 1e-4);
    vec2 place = direction.xz * distanceMetres + origin.xz;
    float detail = exp2(-distanceMetres * 0.02);
    float patches = fractalNoise(place * 0.02, 3);
    float tufts = mix(0.5, fractalNoise(place * 0.9, 3), detail);
    vec3 albedo =
        mix(vec3(0.115, 0.155, 0.055), vec3(0.22, 0.20, 0.085), smoothstep(0.35, 0.7, patches)) * (0.75 + 0.5 * tufts);
    vec3 light = frame.sunColor.rgb * max(frame.sunDirection.y, 0.0) * kInversePi + skyRadiance(vec3(0, 1, 0)) * 0.8;
    float haze = hazeAmount(min(distanceMetres, landscapeMetres(kFarthestFields)));
    return throughHaze(mix(albedo * light, hazeRadiance(direction), haze), direction);
}

const float kStarRadius = 0.111, kMaxStarRadius = 0.2;  // in cells, in which stars are at least 0.2 off the border

/// Stars of a clear night, fainter toward the horizon: at most one in each cell of a cube map, by a hash of the cell.
vec3 starsIn(vec3 direction) {
    if (frame.skyCover.y <= 0.0 || direction.y < 0.02) return vec3(0.0);
    vec3 a = abs(direction);
    vec3 face = a.x > max(a.y, a.z) ? vec3(direction.yz / a.x, sign(direction.x))
                : a.y > a.z         ? vec3(direction.xz / a.y, 3.0 * sign(direction.y))
                                    : vec3(direction.xy / a.z, 5.0 * sign(direction.z));
    vec2 place = face.xy * 90.0;
    ivec2 patch_ = ivec2(floor(place));
    uint dice = hashBits(uint(patch_.x + 512) + hashBits(uint(patch_.y + 512) * 16u + uint(face.z + 8.0)));
    if ((dice & 7u) > 2u) return vec3(0.0);
    vec2 star = 0.2 + 0.6 * vec2(uvec2(dice >> 8, dice >> 16) & 255u) / 255.0;
    float size = float(dice >> 24) / 255.0;
    float glow = 0.02 + 0.30 * size * size * size * size * size;
    // Never much smaller than a pixel, or it would flicker: it gets fainter instead.
    float radius = clamp(90.0 * 0.8 * pixelMetres(1.0), kStarRadius, kMaxStarRadius);
    vec2 away = (place - vec2(patch_) - star) / radius;
    glow *= kStarRadius * kStarRadius / (radius * radius);
    vec3 tint = mix(vec3(1.0, 0.82, 0.65), vec3(0.75, 0.86, 1.0), float((dice >> 3) & 31u) / 31.0);
    return tint * (frame.skyCover.y * glow * max(0.0, 1.0 - dot(away, away)) * smoothstep(0.02, 0.35, direction.y));
}

/// The sky as the camera sees it: with stars, clouds and the sun's disc.
vec3 skyBehind(vec3 direction) {
    float mu = dot(direction, frame.sunDirection.xyz);
    vec3 sky =
        withClouds(skyRadiance(vec3(direction.x, max(direction.y, 0.02), direction.z)) + starsIn(direction), direction);
    // The disc is drawn twice as wide as it is and far darker, so that it blooms and does not flicker.
    float edge = 1.0 - 0.5 * frame.sunDirection.w * frame.sunDirection.w * 4.0;
    sky += frame.sunColor.rgb * 12.0 * smoothstep(edge, 1.0 - (1.0 - edge) * 0.6, mu) *
           (1.0 - smoothstep(0.6, 0.95, frame.skyCover.x));
    return sky;
}

/// Whether fields are what a ray that leaves the level meets.
bool meetsFields(vec3 origin, vec3 direction) { return direction.y < 0.0 && origin.y > frame.skyCover.z; }

/// All that lies behind the level as the camera sees it from a point of its own.
vec3 backgroundRadiance(vec3 origin, vec3 direction) {
    if (meetsFields(origin, direction)) return fieldsBelow(origin, direction);
    return throughHaze(withHills(skyBehind(direction), direction), direction);
}

/// All that lies behind the level as a mirror shows it: without the sun's disc and stars, which highlights stand for.
vec3 mirroredBackground(vec3 origin, vec3 direction) {
    if (meetsFields(origin, direction)) return fieldsBelow(origin, direction);
    vec3 sky = skyRadiance(direction);
    return throughHaze(direction.y > 0.0 ? withHills(withClouds(sky, direction), direction) : sky, direction);
}
