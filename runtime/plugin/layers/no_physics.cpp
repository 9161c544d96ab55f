#include "runtime/plugin/layers.h"

namespace rubble {

std::unique_ptr<PhysicsWorld> makePhysics(const PhysicsSettings&) {
    return nullptr;
}

bool hasPhysics() {
    return false;
}

}  // namespace rubble
