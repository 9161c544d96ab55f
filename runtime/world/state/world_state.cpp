#include "runtime/world/state/world_state.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/core/ranges.h"
#include "runtime/world/objects/object_errors.h"

namespace rubble {

WorldBox withinRange(const WorldBox& box) {
    const WorldBox out{glm::max(box.low, glm::dvec3(ranges::kPlace.low)),
                       glm::min(box.high, glm::dvec3(ranges::kPlace.high))};
    return objectError(out).empty() ? out : WorldBox{};
}

WorldBox boundsAround(const WorldBox& shapes) {
    constexpr double kMinMargin = 128.0, kMaxMargin = 512.0;  // metres
    if (shapes.low == shapes.high) return {};
    const glm::dvec3 size = shapes.high - shapes.low;
    const double margin = std::clamp(0.5 * std::max({size.x, size.y, size.z}), kMinMargin, kMaxMargin);
    return withinRange({shapes.low - margin, shapes.high + margin});
}

WorldBox WorldState::boundsInUse() const {
    if (settings.bounds.low != settings.bounds.high) return {settings.bounds.low, settings.bounds.high};
    return bounds.low != bounds.high ? bounds : boundsAround(made);
}

void restartPendingSplits(WorldState& world) {
    std::erase_if(world.pendingSplits, [&](PendingSplit& pending) {
        Shape* shape = world.shapes.find(pending.shape);
        if (shape) shape->knownConnected = false;
        pending = {pending.shape, {}, {}};
        return !shape;
    });
}

}  // namespace rubble
