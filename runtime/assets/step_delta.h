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

/// What a step of edits resolved to, in shape-local integers: bodies, lights, groups and weather that changed, and for
/// each shape the bricks that did. A brick is a mask of one that was there (what was carved, what a piece took over),
/// or its new content (what was painted). Who has the World as it was before gets the same bytes, with no edit, split
/// or physics run again. before: from WorldBaseline::update(). Palettes that the list gains are part of the bytes.
std::vector<uint8_t> stepDeltaToBytes(const WorldDelta& before, const FrameChanges& changes, const World& after,
                                      PaletteList& palettes);

/// Does the step to a World that is as it was before. On an error the World is as it was.
Result<FrameChanges> applyStepDelta(std::span<const uint8_t> bytes, const std::string& name, World& world,
                                    std::vector<PaletteRef>& palettes);

}  // namespace rubble
