#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/palette_list.h"
#include "runtime/core/result.h"
#include "runtime/world/history/world_delta.h"
#include "runtime/world/world.h"

namespace rubble {

/// What the edits of a step came to, as the difference of two worlds: the objects that changed, and of each shape the
/// bricks that changed. A brick is written as a mask of one that was there before (carved, or taken over by a piece) or
/// as its new content (painted). Whoever has the World before the step gets the World after its edits from this,
/// without running edits or physics. before: the old values, from WorldBaseline::update(). New palettes are added to
/// `palettes` and are part of the bytes, so both sides must see all deltas in order.
std::vector<uint8_t> stepDeltaToBytes(const WorldDelta& before, const FrameChanges& changes, const World& after,
                                      PaletteList& palettes);

/// Applies a delta to a World in the state before its step. `palettes`: those of all deltas so far; new ones are added.
/// `name`: of the source, for messages. On an error the World is unchanged.
Result<FrameChanges> applyStepDelta(std::span<const uint8_t> bytes, const std::string& name, World& world,
                                    std::vector<PaletteRef>& palettes);

}  // namespace rubble
