// What the host has drawn, as copies of its framebuffer. Needs lib/frame, color, display.
uniform sampler2D uHostColor;
uniform bool uFlipped;        // its first row is the top one
uniform bool uLinear;         // it holds radiance times exposure, else the colours of a display
uniform sampler2D uExposure;  // of the frame

float exposureNow() { return frame.exposure.x * texelFetch(uExposure, ivec2(0), 0).r; }

/// The host's pixel that is one of this image, and the other way round.
ivec2 hostPixel(ivec2 pixel) { return ivec2(pixel.x, uFlipped ? int(frame.targetSize.y) - 1 - pixel.y : pixel.y); }

/// Radiance of the host's image at a pixel of this image.
vec3 hostRadiance(ivec2 pixel) {
    vec3 color = texelFetch(uHostColor, hostPixel(pixel), 0).rgb;
    vec2 place = (vec2(pixel) + 0.5) * frame.targetSize.zw;
    return halfRange((uLinear ? color : fromDisplay(color, place)) / exposureNow());
}
