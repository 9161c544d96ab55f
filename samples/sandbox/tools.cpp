#include "samples/sandbox/tools.h"

#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kHammerDistance = 3.5;  // metres
constexpr double kSprayDistance = 5.0;
constexpr double kExplosiveDistance = 60.0;
constexpr double kHammerImpulse = 400.0;  // N s
constexpr std::array<std::array<uint8_t, 3>, 4> kSprayColors = {
    {{214, 40, 57}, {247, 181, 0}, {27, 153, 139}, {46, 94, 170}}};

}  // namespace

Edits useTool(HandTool tool, const World& world, glm::dvec3 originWorld, glm::dvec3 directionWorld, uint32_t seed) {
    const double maxDistance = tool == HandTool::Hammer     ? kHammerDistance
                               : tool == HandTool::SprayCan ? kSprayDistance
                                                            : kExplosiveDistance;
    const WorldHit hit = castRay(world, {originWorld, directionWorld, maxDistance});
    if (!hit.hit) return {};
    switch (tool) {
        case HandTool::Hammer: {
            CarveEdit carve;
            carve.position = hit.position;
            carve.radii = {0.45, 0.25, 0.0};
            if (!hit.shape) return {};  // the ground around the level
            ImpulseEdit push{world.shapes().at(hit.shape).body, hit.position,
                             glm::normalize(directionWorld) * kHammerImpulse};
            return {carve, push};
        }
        case HandTool::Explosive: {
            ExplodeEdit explosion;
            explosion.position = hit.position;
            explosion.size = 1.6;
            return {explosion};
        }
        case HandTool::SprayCan: {
            PaintEdit paint;
            paint.position = hit.position;
            paint.radius = 0.35;
            paint.color = kSprayColors[seed / 256 % kSprayColors.size()];
            paint.probability = 96;
            paint.seed = seed;
            return {paint};
        }
    }
    return {};
}

}  // namespace rubble
