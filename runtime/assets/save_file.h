#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// A game between two steps: the World, and the edits that wait for the next step.
struct SavedGame {
    WorldState world;
    Edits pending;
};

/// A save in memory: chunks PALT, SAVE (everything but voxels) and GRID, under the hash that the World has.
std::vector<uint8_t> gameToBytes(const SavedGame& game);
/// For a World with this number: handles are made its own. The error names file, place, what was expected and what was
/// found.
Result<SavedGame> gameFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

/// Written atomically.
Result<Done> writeSave(const std::string& path, const SavedGame& game);
Result<SavedGame> readSave(const std::string& path, uint8_t world);

}  // namespace rubble
