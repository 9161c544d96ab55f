// Marks, in the depth buffer, the pixels that the G-buffer saw through glass.
uniform sampler2D uGlassMask;

void main() {
    if (texelFetch(uGlassMask, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
}
