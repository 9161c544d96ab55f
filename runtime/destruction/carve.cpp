#include "runtime/destruction/carve.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "runtime/voxel/brick_entries.h"

namespace rubble {
namespace {

/// By palette entry: its Hardness; Unbreakable if the tool does not break it. Looked up when it is first asked for:
/// most shapes use few of the entries.
class EntryClasses {
public:
    EntryClasses(const Palette& palette, const MaterialTable& materials, Tool tool)
        : m_palette(palette), m_materials(materials), m_tool(tool) {
        m_classes.fill(kUnknown);
    }
    uint8_t operator[](uint8_t entry) {
        uint8_t& known = m_classes[entry];
        if (known == kUnknown) {
            const Material& material = m_materials[m_palette[entry].material];
            known = uint8_t(breaksWith(material, m_tool) ? material.hardness : Hardness::Unbreakable);
        }
        return known;
    }

private:
    static constexpr uint8_t kUnknown = 255;
    const Palette& m_palette;
    const MaterialTable& m_materials;
    Tool m_tool;
    std::array<uint8_t, 256> m_classes;
};

BrickBits bitsToRemove(const Brick& brick, const std::array<BrickBits, 3>& touched, EntryClasses& classes) {
    BrickBits candidates, out{};
    for (size_t z = 0; z < 8; ++z) candidates[z] = touched[0][z] | touched[1][z] | touched[2][z];
    forEachEntry(brick, candidates, [&](uint8_t entry, size_t z, uint64_t bits) {
        const uint8_t hardness = classes[entry];
        if (hardness < 3) out[z] |= bits & touched[hardness][z];
    });
    return out;
}

/// Removes voxels of bricks of one node. If the node's moments are cached (see nodeMoments()), subtracts the removed
/// ones and caches the rest: cheaper than summing again.
void removeFromNode(VoxelGrid& grid, glm::ivec3 position, std::span<const BrickSubset> cells,
                    const Densities& densities, CarveResult& out) {
    NodeRef node = grid.takeNode(position);
    const NodeMoments* known = node->cachedMoments.find();
    std::unique_ptr<NodeMoments> left;
    if (known && known->areFor(densities)) left = std::make_unique<NodeMoments>(*known);
    BrickNode& changed = node.own();
    MassMoments gone;
    for (const BrickSubset& subset : cells) {
        const int child = childIndex(subset.brick);
        const Brick& brick = *changed.bricks[size_t(child)];
        forEachEntry(brick, subset.voxels, [&](uint8_t entry, size_t, uint64_t bits) {
            const uint64_t count = uint64_t(std::popcount(bits));
            out.removed[entry] += count;
            out.voxels += count;
        });
        gone += brickMoments(brick, subset.voxels, childPosition(child), densities);
        out.addBrick(subset);
        BrickBits keep;
        for (size_t z = 0; z < 8; ++z) keep[z] = ~subset.voxels[z];
        changed.set(child, maskBrick(brick, keep));
    }
    out.moments += gone.shifted(position * kNodeSize);
    if (left) {
        left->sums -= gone;
        changed.cachedMoments.keep(std::move(left));
    }
    if (changed.mask) grid.putNode(position, std::move(node));
}

/// Appends the voxels of a node's bricks that the brush removes. `touched` by radius; equal radii share the work.
void findCells(const BrickNode& node, glm::ivec3 position, const CellBox& range, const Brush& brush,
               EntryClasses& classes, std::vector<BrickSubset>& out) {
    forEachChild(node.mask, [&](int child) {
        const glm::ivec3 brick = position * kNodeBricks + childPosition(child);
        if (glm::any(glm::lessThan(brick, range.low)) || glm::any(glm::greaterThanEqual(brick, range.high))) return;
        std::array<BrickBits, 3> touched;
        for (size_t c = 0; c < 3; ++c)
            touched[c] =
                c && brush.radii[c] == brush.radii[c - 1] ? touched[c - 1] : brushBits(brush, brick, brush.radii[c]);
        const BrickBits gone = bitsToRemove(*node.bricks[size_t(child)], touched, classes);
        if (gone != BrickBits{}) out.push_back({brick, gone});
    });
}

/// Calls f(node, cells) for each node of which the brush removes voxels.
template <class F>
void forEachCarvedNode(const VoxelGrid& grid, const Brush& brush, const Palette& palette,
                       const MaterialTable& materials, Tool tool, F&& f) {
    const CellBox range = brushBricks(brush, grid.sizeInBricks());
    if (range.empty()) return;
    EntryClasses classes(palette, materials, tool);
    const glm::ivec3 first = nodeOfBrick(range.low), last = nodeOfBrick(range.high - 1);
    std::vector<BrickSubset> cells;
    for (glm::ivec3 node = first; node.z <= last.z; ++node.z)
        for (node.y = first.y; node.y <= last.y; ++node.y)
            for (node.x = first.x; node.x <= last.x; ++node.x) {
                const BrickNode* content = grid.nodeAt(node);
                if (!content) continue;
                cells.clear();
                findCells(*content, node, range, brush, classes, cells);
                if (!cells.empty()) f(node, cells);
            }
}

}  // namespace

void carve(VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials,
           CarveResult& out, Tool tool) {
    const Densities densities(palette, materials);
    forEachCarvedNode(grid, brush, palette, materials, tool,
                      [&](glm::ivec3 node, const std::vector<BrickSubset>& cells) {
                          removeFromNode(grid, node, cells, densities, out);
                      });
}

uint64_t countCarved(const VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials,
                     Tool tool) {
    uint64_t voxels = 0;
    forEachCarvedNode(grid, brush, palette, materials, tool, [&](glm::ivec3, const std::vector<BrickSubset>& cells) {
        for (const BrickSubset& subset : cells)
            for (const uint64_t layer : subset.voxels) voxels += uint64_t(std::popcount(layer));
    });
    return voxels;
}

void removeCells(VoxelGrid& grid, const BrickSubset& cells, const Densities& densities, CarveResult& out) {
    const Brick* brick = grid.brickAt(cells.brick);
    if (!brick) return;
    BrickSubset gone{cells.brick, cells.voxels};
    for (size_t z = 0; z < 8; ++z) gone.voxels[z] &= brick->occupancy[z];
    if (gone.voxels != BrickBits{}) removeFromNode(grid, nodeOfBrick(cells.brick), {&gone, 1}, densities, out);
}

}  // namespace rubble
