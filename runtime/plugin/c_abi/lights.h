#pragma once
#include "runtime/plugin/include/rubble/rubble.h"

// Functions of the table: sky, sun, air and lights.
namespace rubble::abi {

rubble_result environment(rubble_world world, rubble_environment* out);
rubble_result setEnvironment(rubble_world world, const rubble_environment* environment);
rubble_result applySkyModel(rubble_environment* environment, const double* toSun);
rubble_result lights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);
rubble_result lightState(rubble_world world, rubble_light light, rubble_light_state* out);
rubble_result setLight(rubble_world world, const rubble_light_state* light);
rubble_result addLight(rubble_world world, const rubble_light_state* light);
rubble_result removeLight(rubble_world world, rubble_light light);
rubble_result getAddedLights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);

}  // namespace rubble::abi
