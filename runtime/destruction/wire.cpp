#include "runtime/destruction/wire.h"

#include <unordered_map>

#include "runtime/core/random.h"

namespace rubble {
namespace {

struct BrickPlaceHash {
    size_t operator()(glm::ivec3 brick) const { return hashCell(brick.x, brick.y, brick.z); }
};

/// Cells that were seen. Only asked, never walked through: its order decides nothing.
class CellSet {
public:
    /// False if it was there.
    bool add(glm::ivec3 cell) {
        const int index = voxelIndex(cell & 7);
        uint64_t& word = m_bricks[cell >> 3][size_t(index >> 6)];
        const uint64_t bit = uint64_t(1) << (index & 63);
        return !(word & bit) && (word |= bit);
    }

private:
    std::unordered_map<glm::ivec3, BrickBits, BrickPlaceHash> m_bricks;
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
