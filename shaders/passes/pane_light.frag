// The light of panes that waters may cover: lib/pane_light.glsl.
#include "lib/frame.glsl"
#include "lib/noise.glsl"
#include "lib/brdf.glsl"
#include "lib/sky.glsl"
#include "lib/color.glsl"
#include "lib/pane_light.glsl"

out vec4 paneLight;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(uGlassSurface, pixel, 0).w <= 0.0) discard;
    paneLight = paneLightAt(pixel, viewRay(gl_FragCoord.xy * frame.targetSize.zw));
}
