#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/core/result.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// A game between two steps: the World, and the edits that wait for the next step.
struct SavedGame {
    WorldState world;
    Edits pending;
};

/// A saved game in memory: a chunk file (chunk_file.h) with chunks PALT, SAVE (everything but voxels), WAIT (the
/// shapes that wait for their split, if there are any), HOST (scripts and what the host keeps), GENS (the generation of
/// slots that were never used, if it is not 1) and GRID, whose content hash is World::hash() after
/// World::resetCaches(). `memory`: gets what reading it takes (MemoryBudget).
std::vector<uint8_t> gameToBytes(const SavedGame& game, uint64_t* memory = nullptr);
/// The same of a state whose World::hash() is known, and of one that no World can have.
std::vector<uint8_t> gameToBytes(const SavedGame& game, uint64_t hash, uint64_t* memory);
/// Reads a saved game. Its handles become those of the World with the number `world`. `name`: of the file, for
/// messages.
Result<SavedGame> gameFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);
/// The same from a reader of the file's bytes, with its budget of memory.
Result<SavedGame> gameFrom(ByteReader& in, const std::string& name, uint8_t world);

/// Writes a saved game, whole or not at all.
Result<Done> writeSave(const std::string& path, const SavedGame& game);
/// Reads a saved game from a file; see gameFromBytes().
Result<SavedGame> readSave(const std::string& path, uint8_t world);

}  // namespace rubble
