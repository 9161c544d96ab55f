#include "runtime/plugin/layers.h"

namespace rubble {

std::unique_ptr<PhysicsWorld> makePhysics(const PhysicsSettings& settings) {
    return std::make_unique<PhysicsWorld>(settings);
}

bool hasPhysics() {
    return true;
}

}  // namespace rubble
