// A straight segment of rope: a quad along it that faces the camera.
#include "lib/frame.glsl"

layout(location = 0) in vec4 from;  // xyz from the render origin, w metres along the rope
layout(location = 1) in vec4 to;
layout(location = 2) in vec4 lastFrom;  // xyz of both ends in the previous frame; w radius
layout(location = 3) in vec4 lastTo;
layout(location = 4) in vec4 tint;  // rgb sRGB

out vec3 place;  // on the quad
out vec3 lastPlace;
out float across;  // -1 to 1
out float metres;  // along the rope
flat out vec3 side;
flat out vec3 front;  // to the camera, at right angles to the rope
flat out float radiusDrawn;
flat out vec3 tintOut;

void main() {
    float ends[6] = float[6](0.0, 1.0, 1.0, 0.0, 1.0, 0.0);
    float sides[6] = float[6](-1.0, -1.0, 1.0, -1.0, 1.0, 1.0);
    float end = ends[gl_VertexID];
    across = sides[gl_VertexID];
    vec3 along = normalize(to.xyz - from.xyz + vec3(0.0, 1e-6, 0.0));
    vec3 middle = mix(from.xyz, to.xyz, end);
    side = normalize(cross(along, toEye(middle)) + vec3(1e-6));
    front = cross(side, along);
    // Never thinner than 0.6 of a pixel, or it would have gaps.
    radiusDrawn = max(lastFrom.w, 0.3 * pixelMetres(max(viewDepth(middle), 0.1)));
    vec3 overlap = along * ((end * 2.0 - 1.0) * radiusDrawn * 0.35);
    place = middle + side * (across * radiusDrawn) + overlap;
    lastPlace = mix(lastFrom.xyz, lastTo.xyz, end) + side * (across * radiusDrawn) + overlap;
    metres = mix(from.w, to.w, end);
    tintOut = tint.rgb;
    gl_Position = frame.viewProjection * vec4(place, 1.0);
}
