#include "runtime/world/objects/world_objects.h"

namespace rubble {

ObjectKinds<FreeSlots> freeSlotsOf(const WorldObjects& objects) {
    ObjectKinds<FreeSlots> out;
    forEachKind([](const auto& map, std::vector<uint32_t>& free) { free = map.freeSlots(); }, objects, out);
    return out;
}

}  // namespace rubble
