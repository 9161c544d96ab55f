// A quad of the overlay: a glyph of a distance field, a box with smooth sides, an image, or a line of the world.
#include "lib/color.glsl"

uniform sampler2D uGlyphs;  // 0.5 on the outline, more inside
uniform sampler2D uImage;   // premultiplied
uniform sampler2D uDepth;   // linear, of the voxels
uniform vec2 uViewSize;     // pixels
uniform bool uFlipped;      // the first row of pixels is the top one
uniform bool uLinear;       // the framebuffer holds light, not the colours of a display

in vec2 place;
in vec2 clipPlace;
in float quadDepth;
flat in vec4 shapeOut;
flat in vec2 lookOut;
flat in vec4 tintOut;
flat in float softness;
out vec4 color;

const float kGlyph = 0.0, kBox = 1.0, kImage = 2.0, kLine = 3.0;  // OverlayQuad::Kind
const float kSpread = 8.0;                                        // kGlyphSpread
const float kDepthSlack = 0.01;  // of the depth: what lies on a surface is before it

/// Whether voxels hide this pixel.
bool isHidden() {
    float depth = lookOut.x == kLine ? 1.0 / quadDepth : quadDepth;
    vec2 at = gl_FragCoord.xy / uViewSize;
    if (uFlipped) at.y = 1.0 - at.y;
    return texelFetch(uDepth, ivec2(at * vec2(textureSize(uDepth, 0))), 0).r < depth * (1.0 - kDepthSlack);
}

/// How much of the pixel a glyph covers. pixel: its size, in texels.
float glyphCoverage(vec2 texel, float pixel) {
    float inside = (texture(uGlyphs, texel / vec2(textureSize(uGlyphs, 0))).r - 128.0 / 255.0) * (255.0 / 128.0) * kSpread;
    float width = max(pixel, 2.0 * softness);
    return clamp((inside + lookOut.y) / width + 0.5, 0.0, 1.0);
}

/// The same of a box with round corners; q: from its middle, in its own units.
float boxCoverage(vec2 q, float pixel) {
    vec2 beyond = abs(q) - shapeOut.xy + shapeOut.z;
    float outside = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - shapeOut.z;
    float covered = clamp(0.5 - outside / pixel, 0.0, 1.0);
    return shapeOut.w > 0.0 ? covered * clamp(0.5 + (outside + shapeOut.w) / pixel, 0.0, 1.0) : covered;
}

void main() {
    vec2 texel = shapeOut.xy + place * shapeOut.zw;
    vec2 q = (place * 2.0 - 1.0) * (shapeOut.xy + vec2(lookOut.x == kLine ? 0.0 : softness, softness));
    vec2 coordinate = lookOut.x == kGlyph ? texel : q;
    float pixel = max(0.5 * (length(dFdx(coordinate)) + length(dFdy(coordinate))), 1e-6);
    vec4 image = texture(uImage, texel);
    if (any(lessThan(clipPlace, vec2(0.0))) || any(greaterThan(clipPlace, vec2(1.0)))) discard;
    if (quadDepth > 0.0 && isHidden()) discard;
    vec4 straight = tintOut;
    if (uLinear) straight.rgb = srgbToLinear(straight.rgb);
    vec4 solid = vec4(straight.rgb * straight.a, straight.a);
    if (lookOut.x == kImage) {
        if (uLinear) image.rgb = srgbToLinear(image.rgb / max(image.a, 1e-3)) * image.a;
        color = image * solid;
    } else {
        color = solid * (lookOut.x == kGlyph ? glyphCoverage(texel, pixel) : boxCoverage(q, pixel));
    }
}
