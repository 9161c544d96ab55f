// Reads 32 textures, as many as a program may have: render/passes/sampler_reset.h says why.
uniform sampler2D uAny[32];

out vec4 color;

#define ONE(i) texelFetch(uAny[i], ivec2(0), 0)
#define FOUR(i) (ONE(i) + ONE(i + 1) + ONE(i + 2) + ONE(i + 3))

void main() {
    color = FOUR(0) + FOUR(4) + FOUR(8) + FOUR(12) + FOUR(16) + FOUR(20) + FOUR(24) + FOUR(28);
}
