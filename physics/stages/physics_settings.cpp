#include "physics/stages/physics_settings.h"

namespace rubble {

PhysicsSettings fastPhysics() {
    PhysicsSettings settings;
    settings.substeps = 3;
    settings.loadBearingRatio = 10.0;
    return settings;
}

PhysicsSettings balancedPhysics() {
    return {};
}

PhysicsSettings accuratePhysics() {
    PhysicsSettings settings;
    settings.substeps = 16;
    settings.iterations = 2;
    settings.contactHertz = 240.0;
    settings.rotation = RotationRule::Always;
    return settings;
}

}  // namespace rubble
