#include "runtime/world/objects/world_objects.h"

#include <algorithm>

namespace rubble {

uint32_t highestGeneration(const WorldObjects& objects) {
    uint32_t highest = 0;
    forEachKind([&](const auto& map) { highest = std::max(highest, map.highestGeneration()); }, objects);
    return highest;
}

bool isReserved(const WorldObjects& objects, AnyHandle handle) {
    bool out = false;
    withMapOf(objects, handle, [&](const auto& map, auto typed) { out = map.isReserved(typed); });
    return out;
}

ObjectKinds<FreeSlots> freeSlotsOf(const WorldObjects& objects) {
    ObjectKinds<FreeSlots> out;
    forEachKind([](const auto& map, std::vector<uint32_t>& free) { free = map.freeSlots(); }, objects, out);
    return out;
}

}  // namespace rubble
