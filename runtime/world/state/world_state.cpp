#include "runtime/world/state/world_state.h"

namespace rubble {

void restartPendingSplits(WorldState& world) {
    std::erase_if(world.pendingSplits, [&](PendingSplit& pending) {
        Shape* shape = world.shapes.find(pending.shape);
        if (shape) shape->knownConnected = false;
        pending = {pending.shape, {}, {}};
        return !shape;
    });
}

}  // namespace rubble
