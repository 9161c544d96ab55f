// A round rope of twisted strands, shaded on its quad. Targets: lib/gbuffer.glsl.
#include "lib/frame.glsl"

in vec3 place;
in vec3 lastPlace;
in float across;
in float metres;
flat in vec3 side;
flat in vec3 front;
flat in float radiusDrawn;
flat in vec3 tintOut;
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outMaterial;
layout(location = 3) out vec2 outMotion;
layout(location = 4) out float outDepth;

vec2 screenUv(mat4 viewProjection, vec3 world) {
    vec4 clip = viewProjection * vec4(world, 1.0);
    return clip.xy / clip.w * 0.5 + 0.5;
}

void main() {
    float u = clamp(across, -1.0, 1.0), bulge = sqrt(max(1.0 - u * u, 0.0));
    vec3 normal = normalize(side * u + front * max(bulge, 0.05));
    vec3 world = place + front * (bulge * radiusDrawn);
    float linear = viewDepth(world);
    float strand = fract(metres / (radiusDrawn * 2.4) + asin(u) * 0.318);  // 1 / pi: strands wind around the rope
    float groove = smoothstep(0.0, 0.22, min(strand, 1.0 - strand));
    outAlbedo = vec4(tintOut * mix(0.6, 1.05, groove), 1.0 / 255.0);
    outNormal = vec4(normal, 0.0);
    outMaterial = vec4(0.75, 0.0, 0.12, 1.0);
    outMotion = screenUv(frame.viewProjectionPlain, place) - screenUv(frame.previousViewProjection, lastPlace);
    outDepth = linear;
    gl_FragDepth = surfaceDepthValue(linear);
}
