// Shows any target. The modes are those of ShowPass::Mode in render/passes/show_pass.h.
#include "lib/show.glsl"

uniform int uMode;

void main() {
    vec4 v = texture(uTarget, shownPlace());
    vec3 c = v.rgb;
    if (uMode == 1) c = pow(c / (1.0 + c), vec3(1.0 / 2.2));  // radiance
    if (uMode == 2) c = v.rgb * 0.5 + 0.5;                    // directions
    if (uMode == 3) c = vec3(1.0 - exp(-v.r / 20.0));         // metres
    if (uMode == 4) c = vec3(v.rg * 10.0 + 0.5, 0.5);         // motion, uv per frame
    if (uMode == 5) c = vec3(abs(v.a));  // the emission of fine voxels is below 0
    if (uMode == 6) c = vec3(v.b / 32.0);  // frames accumulated
    show(c);
}
