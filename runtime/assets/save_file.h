#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// A game between two steps: the World, and the edits that wait for the next step.
struct SavedGame {
    WorldState world;
    Edits pending;
};

/// A saved game in memory: a chunk file (chunk_file.h) with chunks PALT, SAVE (everything but voxels) and GRID, whose
/// content hash is World::hash().
std::vector<uint8_t> gameToBytes(const SavedGame& game);
/// Reads a saved game. Its handles become those of the World with the number `world`. `name`: of the file, for
/// messages.
Result<SavedGame> gameFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

/// Writes a saved game, whole or not at all.
Result<Done> writeSave(const std::string& path, const SavedGame& game);
/// Reads a saved game from a file; see gameFromBytes().
Result<SavedGame> readSave(const std::string& path, uint8_t world);

}  // namespace rubble
