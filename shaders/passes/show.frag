// Shows an image: as it is, or radiance with the exposure.
#include "lib/show.glsl"

uniform bool uIsExposed;  // it holds radiance
uniform sampler2D uExposure;

void main() {
    vec3 c = texture(uTarget, shownPlace()).rgb;
    show(uIsExposed ? c * (frame.exposure.x * texelFetch(uExposure, ivec2(0), 0).r) : c);
}
