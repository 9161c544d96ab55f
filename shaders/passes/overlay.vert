// A quad of the overlay (render/overlay/overlay_quads.h): a parallelogram in clip space.
layout(location = 0) in vec4 corner;
layout(location = 1) in vec4 right;
layout(location = 2) in vec4 down;
layout(location = 3) in vec4 shape;
layout(location = 4) in vec4 clip;
layout(location = 5) in vec4 look;
layout(location = 6) in vec4 tint;
layout(location = 7) in vec4 depths;

uniform bool uFlipped;  // the first row of pixels is the top one

out vec2 place;  // on the quad, 0 to 1
out vec2 clipPlace;
out float quadDepth;
flat out vec4 shapeOut;
flat out vec2 lookOut;  // kind, what a glyph grows by
flat out vec4 tintOut;
flat out float softness;

void main() {
    vec2 corners[6] = vec2[6](vec2(0.0), vec2(1.0, 0.0), vec2(1.0), vec2(0.0), vec2(1.0), vec2(0.0, 1.0));
    place = corners[gl_VertexID];
    clipPlace = clip.xy + place.x * clip.zw + place.y * look.xy;
    quadDepth = depths.x + place.x * depths.y + place.y * depths.z;
    shapeOut = shape;
    lookOut = look.zw;
    tintOut = tint;
    softness = depths.w;
    gl_Position = corner + place.x * right + place.y * down;
    if (uFlipped) gl_Position.y = -gl_Position.y;
}
