#include "render/passes/bounce.h"

#include <algorithm>

#include "render/passes/local_lights_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kMaxBounces = 16;  ///< a white room would keep its light for ever

}  // namespace

void bindBounce(const Program& program, const FrameContext& frame, BounceRays rays) {
    const bool gathered = rays == BounceRays::Gathered, detailed = !gathered || frame.settings.bounceColors;
    const History radiance = frame.targets.history("radiance", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    program.set("uRadianceHistory", radiance.previous);
    program.set("uSurfaceHistory", surface.previous);
    program.set("uHistoryValid", int(radiance.valid && surface.valid));
    program.set("uBounce", int(frame.settings.bounce));
    program.set("uMaxBounces", gathered ? std::clamp(frame.settings.bounces, 1, kMaxBounces) : 1);
    program.set("uMaxDistance", frame.settings.skyDistance);
    program.set("uDiffuseFractionHistory", frame.targets.history("diffuseFraction", GL_R8).previous);
    program.set("uDiffuseOnly", int(gathered));
    const bool hasLocalLights = detailed && LocalLightsPass::needed(frame) && !frame.lightGrid->empty();
    program.set("uBounceLights", int(hasLocalLights));
    if (hasLocalLights) frame.lightGrid->bind(program);
    program.set("uBodyLevels", 0);  // no voxels to look up
    if (detailed) frame.scene.bindVoxelsAt(program);
    program.set("uSunUp", int(frame.block.sunDirection.y > 0.0f));
}

}  // namespace rubble
