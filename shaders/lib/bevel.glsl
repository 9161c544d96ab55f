// Rounded edges of near voxels: the normal is blended with the normals around it within a few millimetres, where the
// depth says that it is the same surface. The taps lie on a spiral that turns by the golden angle.
const float kBevelMetres = 0.012;

vec3 bevelledNormal(Surface s, ivec2 pixel) {
    float pixelSide = pixelMetres(s.depth);
    float radius = kBevelMetres / pixelSide;
    float strength = smoothstep(0.5, 1.2, radius);
    radius = clamp(radius, 1.0, 12.0);
    ivec2 high = ivec2(frame.targetSize.xy) - 1;
    vec3 sum = s.normal * 2.0;
    vec2 spiral = vec2(1.0, 0.0);
    int i = loopBegin();
    do {
        if (strength <= 0.0) break;
        vec2 offset = spiral * radius * sqrt((float(i) + 0.5) / 8.0);
        // Rotates by the golden angle.
        spiral = vec2(dot(spiral, vec2(-0.7373688, -0.6754903)), dot(spiral, vec2(0.6754903, -0.7373688)));
        ivec2 p = clamp(pixel + ivec2(floor(offset + 0.5)), ivec2(0), high);
        if (abs(texelFetch(uDepth, p, 0).r - s.depth) < 0.05 + 4.0 * pixelSide) sum += texelFetch(uNormal, p, 0).xyz;
    } while (++i < 8);
    return strength > 0.0 ? normalize(mix(s.normal, normalize(sum), 0.7 * strength)) : s.normal;
}
