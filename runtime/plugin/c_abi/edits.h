#pragma once
#include "runtime/plugin/include/rubble/rubble.h"
#include "runtime/world/world.h"

namespace rubble::abi {

// The host's edits as the World's, checked. Throw ApiError.
CarveEdit toEdit(const World& world, const rubble_carve& carve);
BreakEdit toEdit(const World& world, const rubble_break& given);
ExplodeEdit toEdit(const World& world, const rubble_explosion& explosion);
PaintEdit toEdit(const World& world, const rubble_paint& paint);
ImpulseEdit toEdit(const World& world, const rubble_impulse& impulse);

}  // namespace rubble::abi
