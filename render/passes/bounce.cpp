#include "render/passes/bounce.h"

#include <algorithm>

#include "render/passes/history_left_pass.h"
#include "render/passes/local_lights_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kMaxBounces = 16;  ///< paths between white walls must end

}  // namespace

void bindBounce(const Program& program, const FrameContext& frame, BounceRays rays) {
    const bool isDiffuse = rays == BounceRays::Diffuse, isDetailed = !isDiffuse || frame.settings.bounceColors;
    const History radiance = frame.pastTargets().history(Target::Radiance);
    const History surface = frame.pastTargets().history(Target::Surface);
    const bool isSameSize = radiance.previous.size() == glm::ivec2(frame.block.targetSize);
    program.set("uRadianceHistory", radiance.previous);
    program.set("uSurfaceHistory", surface.previous);
    program.set("uHistoryValid", int(radiance.valid && surface.valid && isSameSize));
    HistoryLeftPass::bind(program, frame);
    program.set("uBounce", int(frame.settings.bounce));
    program.set("uMaxBounces", isDiffuse ? std::clamp(frame.settings.bounces, 1, kMaxBounces) : 1);
    program.set("uMaxDistance", frame.settings.skyDistance);
    program.set("uDiffuseFractionHistory", frame.pastTargets().history(Target::DiffuseFraction).previous);
    program.set("uDiffuseOnly", int(isDiffuse));
    const bool hasLocalLights = isDetailed && LocalLightsPass::needed(frame) && !frame.lightGrid->empty();
    program.set("uBounceLights", int(hasLocalLights));
    LightGrid::bind(program, frame.lightGrid);
    frame.scene.bindVoxelsAt(program);
    if (!isDetailed) program.set("uBodyLevels", 0);  // no voxels are looked up
    program.set("uSunUp", int(frame.block.sunDirection.y > 0.0f));
}

}  // namespace rubble
