#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/voxel/brick_node.h"
#include "runtime/voxel/brick_parts.h"

namespace rubble {

/// The 6-connected components of what a node holds, seen from inside the node alone, in the order of their lowest
/// brick.
struct NodeParts {
    /// Of a node of several components: which one each part of each brick belongs to.
    struct Detail {
        std::array<uint16_t, 65> firstPart{};  ///< by child
        std::vector<uint16_t> component;       ///< by part, brick after brick
    };
    uint32_t count = 0;
    std::unique_ptr<const Detail> detail;  ///< null if there is only one
    std::vector<uint32_t> voxels;          ///< by component

    uint16_t componentOf(int child, size_t part) const {
        return detail ? detail->component[detail->firstPart[size_t(child)] + part] : uint16_t(0);
    }
};

/// Worked out once a node.
const NodeParts& nodeParts(const BrickNode& node);

/// The parts of a node's bricks, for as long as this lives.
class BrickPartCache {
public:
    explicit BrickPartCache(const BrickNode& node) : m_node(node) {}
    std::span<const BrickPart> operator[](int child);

private:
    const BrickNode& m_node;
    BrickMask m_known = 0;
    std::array<std::span<const BrickPart>, 64> m_parts;
    std::vector<BrickPart> m_scratch;
    std::vector<std::vector<BrickPart>> m_kept;  ///< of the bricks that keep none themselves
};

/// The bricks of a node that lie on one of its faces (see kFaceOffsets).
inline constexpr std::array<BrickMask, 6> kFaceBricks = {0x1111111111111111ull, 0x8888888888888888ull,
                                                         0x000f000f000f000full, 0xf000f000f000f000ull,
                                                         0x000000000000ffffull, 0xffff000000000000ull};
/// How far a brick's bit moves to the facing brick of the neighbour there: childIndex goes from one side to the other.
inline constexpr std::array<int, 6> kNeighborShift = {3, -3, 12, -12, 48, -48};

/// Calls f(componentOfA, componentOfB) for components that touch through a face of `a`; the same pair may come again.
/// f returns whether it wants more.
template <class F>
void forEachContact(const BrickNode& a, const BrickNode& b, size_t face, F&& f) {
    const NodeParts &inA = nodeParts(a), &inB = nodeParts(b);
    const int shift = kNeighborShift[face];
    const auto facing = [&](BrickMask mask) { return shift > 0 ? mask >> shift : mask << -shift; };
    const BrickMask both = a.mask & kFaceBricks[face] & facing(b.mask);
    const bool isOnePair = inA.count == 1 && inB.count == 1;
    if (isOnePair && (a.full & kFaceBricks[face] & facing(b.full))) {
        f(uint16_t(0), uint16_t(0));
        return;
    }
    std::vector<BrickPart> scratchA, scratchB;
    for (BrickMask left = both; left; left &= left - 1) {
        const int childA = std::countr_zero(left), childB = childA + shift;
        const auto partsA = brickParts(*a.bricks[size_t(childA)], scratchA),
                   partsB = brickParts(*b.bricks[size_t(childB)], scratchB);
        for (size_t i = 0; i < partsA.size(); ++i)
            for (size_t j = 0; partsA[i].faces[face] && j < partsB.size(); ++j)
                if (partsA[i].faces[face] & partsB[j].faces[face ^ 1])
                    if (!f(inA.componentOf(childA, i), inB.componentOf(childB, j)) || isOnePair) return;
    }
}

}  // namespace rubble
