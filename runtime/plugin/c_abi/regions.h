#pragma once
#include "runtime/plugin/include/rubble/rubble.h"

// Functions of the table: collision layers, water, triggers and characters.
namespace rubble::abi {

rubble_result setCollision(rubble_world world, const rubble_collision_filter* edit);
rubble_result addWater(rubble_world world, const rubble_water_settings* water);
rubble_result removeWater(rubble_world world, rubble_water water);
rubble_result addTrigger(rubble_world world, const rubble_trigger_settings* trigger);
rubble_result removeTrigger(rubble_world world, rubble_trigger trigger);
rubble_result addCharacter(rubble_world world, const rubble_character_settings* character);
rubble_result removeCharacter(rubble_world world, rubble_character character);
rubble_result moveCharacter(rubble_world world, const rubble_character_move* move);
rubble_result teleportCharacter(rubble_world world, const rubble_character_teleport* place);
rubble_result waters(rubble_world world, rubble_water* out, uint32_t capacity, uint32_t* count);
rubble_result triggers(rubble_world world, rubble_trigger* out, uint32_t capacity, uint32_t* count);
rubble_result getCharacterStates(rubble_world world, rubble_character_state* out, uint32_t capacity, uint32_t* count);
rubble_result triggerEvents(rubble_world world, rubble_trigger_event* out, uint32_t capacity, uint32_t* count);
rubble_result getTriggerBodies(rubble_world world, rubble_trigger trigger, rubble_body* out, uint32_t capacity,
                               uint32_t* count);

}  // namespace rubble::abi
