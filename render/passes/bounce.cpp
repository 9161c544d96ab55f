#include "render/passes/bounce.h"

namespace rubble {

void bindBounce(const Program& program, const FrameContext& frame) {
    const History radiance = frame.targets.history("radiance", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    program.set("uLastRadiance", radiance.previous);
    program.set("uLastSurface", surface.previous);
    program.set("uLastValid", int(radiance.valid && surface.valid));
    program.set("uBounce", int(frame.settings.bounce));
    program.set("uSunUp", int(frame.block.sunDirection.y > 0.0f));
}

}  // namespace rubble
