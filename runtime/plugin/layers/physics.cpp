#include "runtime/plugin/layers.h"

namespace rubble {

std::unique_ptr<PhysicsWorld> makePhysics(const PhysicsSettings& settings) {
    return std::make_unique<PhysicsWorld>(settings);
}

PhysicsSettings physicsPreset(PhysicsPreset preset, const PhysicsSettings& given) {
    switch (preset) {
        case PhysicsPreset::Given:
            return given;
        case PhysicsPreset::Fast:
            return fastPhysics();
        case PhysicsPreset::Balanced:
            return balancedPhysics();
        case PhysicsPreset::Accurate:
            return accuratePhysics();
    }
    return given;
}

bool hasPhysics() {
    return true;
}

}  // namespace rubble
