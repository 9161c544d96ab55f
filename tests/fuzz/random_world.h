#pragma once
#include "runtime/world/world.h"
#include "tests/fuzz/decisions.h"

namespace rubble {

/// A small valid level with a few of everything: standing and loose shapes of all kinds of entries, shapes without
/// voxels, lights and groups, water, triggers, characters and joints of all kinds.
Level randomLevel(Decisions& decisions);
/// An edit of any kind for a world. One in `wildness` of its numbers is as nobody should give it.
Edit randomEdit(Decisions& decisions, const World& world, uint32_t wildness);
/// Aborts, with a reason, unless a save of the world can be read back and gives the same world.
void requireReadableSave(const World& world);

}  // namespace rubble
