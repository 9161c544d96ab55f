#include "runtime/world/state/world_state.h"

#include <algorithm>

namespace rubble {

WorldBox boundsAround(const WorldBox& shapes) {
    constexpr double kMinMargin = 128.0, kMaxMargin = 512.0;  // metres
    if (shapes.low == shapes.high) return {};
    const glm::dvec3 size = shapes.high - shapes.low;
    const double margin = std::clamp(0.5 * std::max({size.x, size.y, size.z}), kMinMargin, kMaxMargin);
    return {shapes.low - margin, shapes.high + margin};
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
