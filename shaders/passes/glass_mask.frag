// Marks the pixels that have glass in the depth buffer.
uniform sampler2D uGlassMask;

void main() {
    if (texelFetch(uGlassMask, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
}
