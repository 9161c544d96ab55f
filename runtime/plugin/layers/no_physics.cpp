#include "runtime/plugin/layers.h"

namespace rubble {

std::unique_ptr<PhysicsWorld> makePhysics(const PhysicsSettings&) {
    return nullptr;
}

PhysicsSettings physicsPreset(PhysicsPreset, const PhysicsSettings& given) {
    return given;
}

bool hasPhysics() {
    return false;
}

}  // namespace rubble
