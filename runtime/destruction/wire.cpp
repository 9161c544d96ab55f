#include "runtime/destruction/wire.h"

#include <unordered_map>

#include "runtime/core/random.h"

namespace rubble {
namespace {

struct BrickHash {
    size_t operator()(glm::ivec3 brick) const { return hashCell(brick.x, brick.y, brick.z); }
};

/// The cells visited so far. It is only looked up, never iterated, so the order of its buckets decides nothing.
class CellSet {
public:
    /// Adds a cell. False if it was in the set.
    bool add(glm::ivec3 cell) {
        BrickBits& bits = m_bricks[brickOfCell(cell)];
        const int index = voxelIndex(cellInBrick(cell));
        if (hasVoxel(bits, index)) return false;
        setVoxel(bits, index);
        return true;
    }

private:
    std::unordered_map<glm::ivec3, BrickBits, BrickHash> m_bricks;
};

}  // namespace

bool isWireConnected(const VoxelGrid& grid, glm::ivec3 from, const EntrySet& wire, const EntrySet& goal) {
    const uint8_t first = grid.at(from);
    if (first && goal[first]) return true;
    if (!first || !wire[first]) return false;
    CellSet seen;
    seen.add(from);
    std::vector<glm::ivec3> open = {from};
    while (!open.empty()) {
        const glm::ivec3 cell = open.back();
        open.pop_back();
        for (const glm::ivec3 step : kFaceOffsets) {
            const uint8_t entry = grid.at(cell + step);
            if (entry && goal[entry]) return true;
            if (entry && wire[entry] && seen.add(cell + step)) open.push_back(cell + step);
        }
    }
    return false;
}

}  // namespace rubble
