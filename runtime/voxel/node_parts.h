#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/voxel/brick_node.h"
#include "runtime/voxel/brick_parts.h"

namespace rubble {

/// The 6-connected components of the voxels of one node, without regard to its neighbours, ordered by their lowest
/// brick.
struct NodeParts {
    /// In a node of several components: the component of each part (component of one brick, see BrickPart).
    struct Detail {
        std::array<uint16_t, 65> firstPart{};  ///< by child: where its parts begin in `component`
        std::vector<uint16_t> component;       ///< by part, brick after brick
    };
    uint32_t count = 0;                    ///< components
    std::unique_ptr<const Detail> detail;  ///< null if there is only one component
    std::vector<uint32_t> voxels;          ///< by component

    /// The component that a part of brick `child` belongs to.
    uint16_t componentOf(int child, size_t part) const {
        return detail ? detail->component[detail->firstPart[size_t(child)] + part] : uint16_t(0);
    }
};

/// [any-thread] The components of a node, computed once and cached in the node.
const NodeParts& nodeParts(const BrickNode& node);

/// The parts of a node's bricks, also of those bricks that do not cache their own. Valid for as long as this object
/// lives.
class BrickPartCache {
public:
    /// The node must outlive this object and not change.
    explicit BrickPartCache(const BrickNode& node) : m_node(node) {}
    /// The parts of brick `child`, which must be in the node's mask.
    std::span<const BrickPart> operator[](int child);

private:
    const BrickNode& m_node;
    BrickMask m_known = 0;
    std::array<std::span<const BrickPart>, 64> m_parts;
    std::vector<BrickPart> m_scratch;
    std::vector<std::vector<BrickPart>> m_kept;  ///< parts of the bricks that cache none
};

/// The bricks of a node that lie on one of its faces, by face in the order of kFaceOffsets.
inline constexpr std::array<BrickMask, 6> kFaceBricks = {0x1111111111111111ull, 0x8888888888888888ull,
                                                         0x000f000f000f000full, 0xf000f000f000f000ull,
                                                         0x000000000000ffffull, 0xffff000000000000ull};
/// By face: what to add to a brick's childIndex() to get that of the brick beyond the face, in the neighbouring node.
inline constexpr std::array<int, 6> kNeighborShift = {3, -3, 12, -12, 48, -48};

/// Calls f(componentOfA, componentOfB) for components that touch through a face of `a`; `b` is the node beyond that
/// face. The same pair may come again. Stops when f returns false.
template <class F>
void forEachContact(const BrickNode& a, const BrickNode& b, size_t face, F&& f) {
    const NodeParts &inA = nodeParts(a), &inB = nodeParts(b);
    const int shift = kNeighborShift[face];
    const auto facing = [&](BrickMask mask) { return shift > 0 ? mask >> shift : mask << -shift; };
    const BrickMask both = a.mask & kFaceBricks[face] & facing(b.mask);
    const bool isOnePair = inA.count == 1 && inB.count == 1;  // then the first contact says all
    if (isOnePair && (a.full & kFaceBricks[face] & facing(b.full))) {
        f(uint16_t(0), uint16_t(0));
        return;
    }
    std::vector<BrickPart> scratchA, scratchB;
    for (BrickMask left = both; left; left &= left - 1) {
        const int childA = std::countr_zero(left), childB = childA + shift;
        const auto partsA = brickParts(*a.bricks[size_t(childA)], scratchA),
                   partsB = brickParts(*b.bricks[size_t(childB)], scratchB);
        const bool goesOn = forEachTouchingPair(partsA, partsB, face, [&](size_t i, size_t j) {
            return f(inA.componentOf(childA, i), inB.componentOf(childB, j)) && !isOnePair;
        });
        if (!goesOn) return;
    }
}

}  // namespace rubble
