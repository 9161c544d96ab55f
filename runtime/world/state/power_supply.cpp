#include "runtime/world/state/power_supply.h"

#include "runtime/destruction/wire.h"

namespace rubble {

bool isPowered(const WorldData& world, LightGroupHandle handle, const LightGroup& group) {
    const Shape* shape = world.shapes.find(group.supply);
    if (!shape) return false;
    EntrySet wire{}, goal{};
    for (size_t i = 1; i < 256; ++i) {
        wire[i] = world.wire && (*shape->palette)[i].material == world.wire;
        goal[i] = (*shape->palette)[i].lightGroup == handle.slot() + 1;
    }
    return isWireConnected(shape->grid, group.supplyCell, wire, goal);
}

}  // namespace rubble
