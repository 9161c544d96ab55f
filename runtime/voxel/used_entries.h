#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A set of palette entries, one bit each.
struct UsedEntries {
    std::array<uint64_t, 4> bits{};
    /// Whether the entry is in it.
    bool contains(size_t entry) const { return bits[entry / 64] >> (entry % 64) & 1; }
    /// Adds an entry.
    void insert(size_t entry) { bits[entry / 64] |= uint64_t(1) << (entry % 64); }
    /// Adds all entries of another set.
    void insert(const UsedEntries& other) {
        for (size_t i = 0; i < bits.size(); ++i) bits[i] |= other.bits[i];
    }
    /// Whether an entry is in both sets.
    bool intersects(const UsedEntries& other) const {
        uint64_t shared = 0;
        for (size_t i = 0; i < bits.size(); ++i) shared |= bits[i] & other.bits[i];
        return shared != 0;
    }
    /// Calls f(entry) for each, ascending.
    template <class F>
    void forEach(F&& f) const {
        for (size_t i = 0; i < bits.size(); ++i)
            for (uint64_t left = bits[i]; left; left &= left - 1) f(64 * i + size_t(std::countr_zero(left)));
    }
};

/// [any-thread] The entries of a node's voxels; cached in the node.
const UsedEntries& usedEntries(const BrickNode& node);
/// [any-thread] The entries of a grid's voxels: an entry is free if it has no material and is not among them. Costs the
/// nodes that changed since it was asked last, and a word or two for each other one.
UsedEntries usedEntries(const VoxelGrid& grid);

}  // namespace rubble
