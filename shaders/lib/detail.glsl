// Detail of a voxel's faces: small variations of colour, roughness and normal from maps of one texel a voxel (made by
// render/scene/detail_maps.h). Needs lib/frame, bodies.
uniform sampler2D uDetailMaps;
uniform bool uDetail;

const int kDetailSide = 32;    // texels of a map's side
const float kTiltSteps = 5.0;  // to each side, in which encodeTilt() stores a tilt

struct Detail {
    float color, roughness;  // factors
    vec2 tilt;               // of the face along two axes, -1 to 1
};

/// Pixels of a voxel's side below which it shows no detail; from three times as many on it shows all of it.
const float kMinDetailPixels = 1.2;

Detail detailAt(uint map, ivec3 cell, vec3 face, float voxelPixels) {
    Detail detail = Detail(1.0, 1.0, vec2(0.0));
    if (!uDetail || map == 0u || face == vec3(0.0)) return detail;
    vec3 axis = abs(face);
    ivec2 texelPosition = axis.x > 0.5 ? cell.zy : axis.y > 0.5 ? cell.xz : cell.xy;
    texelPosition += ivec2(axis.yz) * ivec2(11, 17);  // each face of a voxel reads another texel
    vec4 texel =
        texelFetch(uDetailMaps, (texelPosition & (kDetailSide - 1)) + ivec2(0, kDetailSide * (int(map) - 1)), 0) *
            255.0 / 127.0 -
        128.0 / 127.0;
    texel *= clamp((voxelPixels - kMinDetailPixels) / (2.0 * kMinDetailPixels), 0.0, 1.0);
    detail.color = 1.0 + 0.5 * texel.r;
    detail.roughness = 1.0 + 0.5 * texel.g;
    detail.tilt = texel.ba;
    return detail;
}

/// A tilt as a whole number from 1 to 121; 0 stands for no tilt. decodeTilt() in lib/gbuffer.glsl reads it.
float encodeTilt(vec2 tilt) {
    vec2 steps = floor(tilt * kTiltSteps + 0.5);
    return steps == vec2(0.0) ? 0.0 : 1.0 + steps.x + kTiltSteps + (steps.y + kTiltSteps) * (2.0 * kTiltSteps + 1.0);
}
