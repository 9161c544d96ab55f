// One ray a pixel, from textures. r is 1 where it is stopped.
uniform sampler2D uOrigins;     // xyz cells, w maximum distance in cells (negative: no ray)
uniform sampler2D uDirections;  // xyz unit vector
out vec4 result;

void main() {
    vec4 origin = texelFetch(uOrigins, ivec2(gl_FragCoord.xy), 0);
    vec3 direction = texelFetch(uDirections, ivec2(gl_FragCoord.xy), 0).xyz;
    result = vec4(0.0);
    if (origin.w >= 0.0 && traceCells(origin.xyz, direction, origin.w)) result.r = 1.0;
}
