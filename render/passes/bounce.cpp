#include "render/passes/bounce.h"

#include <algorithm>

#include "render/passes/local_lights_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kMostBounces = 16;  ///< a white room would keep its light for ever

}  // namespace

void bindBounce(const Program& program, const FrameContext& frame, BounceRays rays) {
    const bool gathered = rays == BounceRays::Gathered, detailed = !gathered || frame.settings.bounceColors;
    const History radiance = frame.targets.history("radiance", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    program.set("uLastRadiance", radiance.previous);
    program.set("uLastSurface", surface.previous);
    program.set("uLastValid", int(radiance.valid && surface.valid));
    program.set("uBounce", int(frame.settings.bounce));
    program.set("uBounces", gathered ? std::clamp(frame.settings.bounces, 1, kMostBounces) : 1);
    program.set("uReach", frame.settings.skyDistance);
    program.set("uLastMatte", frame.targets.history("matte", GL_R8).previous);
    program.set("uMatte", int(gathered));
    const bool lamps = detailed && LocalLightsPass::needed(frame) && !frame.lightGrid->empty();
    program.set("uLamps", int(lamps));
    if (lamps) frame.lightGrid->bind(program);
    program.set("uBodyLevels", 0);  // no voxels to look up
    if (detailed) frame.scene.bindVoxelsAt(program);
    program.set("uSunUp", int(frame.block.sunDirection.y > 0.0f));
}

}  // namespace rubble
