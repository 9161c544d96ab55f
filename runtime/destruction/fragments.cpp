#include "runtime/destruction/fragments.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/core/assertion.h"
#include "runtime/core/index_map.h"
#include "runtime/core/random.h"
#include "runtime/destruction/fragment_style.h"
#include "runtime/destruction/pack_piece.h"
#include "runtime/destruction/pane.h"

// Voronoi fracture on voxels, in integers.
//
// Every voxel of the zone gets the label of its nearest site, and the voxels of one label are one fragment. Space is
// divided into cubes of a fragment's size with one site in each, moved inside its cube by a hash of the cube and the
// seed (S. Worley, "A cellular texture basis function", SIGGRAPH 1996). So the nearest site is taken from eight cubes,
// and no list of sites is needed. The cubes are stretched along the grain for splinters and half as large near the hit;
// all grow if more fragments than allowed would come out. A hash of the voxel displaces it before the search: rough
// borders. Bricks in bond take cubes in shifted rows instead. Materials never share a fragment. Voxels near the hit
// become dust, as do fragments that are too small; a fragment of several components is split into them. Coordinates are
// in 1/256 of a cell.

namespace rubble {
namespace {

using Point = std::array<int64_t, 3>;

constexpr size_t kNoGroup = 255;
constexpr int kMaxGrainCells = 64;          ///< from the hit along each axis, to find the grain
constexpr uint64_t kMinFragmentShare = 16;  ///< a fragment of less than 1/16 of the average size becomes dust

/// The voxels of one material in the zone.
struct Group {
    const FragmentStyle* style = nullptr;
    uint8_t material = 0;
    int64_t breakRadius2 = 0, dust2 = 0;  ///< squared radii around the hit, in 1/256 of a cell
    Point size{};                         ///< of a fragment along each axis, in 1/256 of a cell
    uint64_t voxels = 0;                  ///< their number
    glm::ivec3 nearest{0};                ///< the cell nearest to the hit
    int64_t nearest2 = INT64_MAX;         ///< its squared distance

    /// Voxels of an average fragment.
    uint64_t fragmentVoxels() const {
        return uint64_t(std::max<int64_t>(size[0] * size[1] / 256 * size[2] / 65536, 1));
    }
};

int64_t floorDivide(int64_t a, int64_t b) {
    return a / b - (a % b < 0);
}

/// A position in units of the cubes that hold the sites, in 1/256 of a cube.
using CubePoint = std::array<int32_t, 3>;

/// The cube of the site that is nearest to a point. A site stays within 96/256 of the middle of its cube.
glm::ivec3 nearestSite(const CubePoint& point, uint32_t seed) {
    glm::ivec3 best(0);
    int64_t best2 = INT64_MAX;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 site(((point[0] - 128) >> 8) + (corner & 1), ((point[1] - 128) >> 8) + (corner >> 1 & 1),
                              ((point[2] - 128) >> 8) + (corner >> 2));
        const uint32_t hash = hashCell(site.x, site.y, site.z, seed);
        int64_t away2 = 0;
        for (int a = 0; a < 3; ++a) {
            const int64_t at = site[a] * 256 + 128 + int32_t((hash >> 8 * a & 255) * 3 / 4) - 96;
            away2 += (point[size_t(a)] - at) * (point[size_t(a)] - at);
        }
        if (away2 < best2) best2 = away2, best = site;
    }
    return best;
}

/// The brick of a running bond that holds a point: two cubes long, every other row shifted by one.
glm::ivec3 brickInBond(const CubePoint& point) {
    const int row = point[1] >> 8;
    return {(point[0] + (row & 1) * 256) >> 9, row, point[2] >> 8};
}

/// One call of fracture().
class Fracturer {
public:
    Fracturer(VoxelGrid& grid, const Brush& sphere, const Palette& palette, const MaterialTable& materials,
              const FracturePlan& plan)
        : m_grid(grid),
          m_sphere(sphere),
          m_palette(palette),
          m_materials(materials),
          m_densities(palette, materials),
          m_plan(plan) {
        m_groupOf.fill(kNoGroup);
    }

    FractureResult run() {
        makeGroups();
        collectZone();
        for (size_t g = 0; g < m_groups.size(); ++g)
            if (m_groups[g].style->wholePane && m_groups[g].voxels) growPane(g);
        chooseSizes();
        for (const BrickSubset& subset : m_zone) assignClusters(subset);
        removeZone();
        return std::move(m_out);
    }

private:
    /// The voxels of one label.
    struct Cluster {
        size_t group;
        uint64_t voxels = 0;
        std::vector<BrickSubset> subsets;
    };

    void makeGroups();
    void collectZone();
    void growPane(size_t group);
    void chooseSizes();
    void assignClusters(const BrickSubset& subset);
    void removeZone();
    void addFragment(const Cluster& cluster);
    bool isConnectedBrick(const VoxelGrid& grid);
    void addPiece(Piece&& piece, const Group& group);
    void addDust(const Brick& brick, const BrickBits& bits, glm::ivec3 position);
    /// Whether it becomes dust: too small for a fragment, or one too many.
    bool isTooSmall(uint64_t voxels, const Group& group) const {
        return voxels * kMinFragmentShare < group.fragmentVoxels() || voxels < m_plan.minVoxels ||
               m_out.fragments.size() >= m_plan.maxFragments;
    }
    int grainOf(const Group& group) const;
    uint64_t labelOf(size_t group, glm::ivec3 cell, bool isNear) const;
    bool isOnCrack(size_t group, glm::ivec3 cell, bool isNear, uint64_t label) const;

    int64_t distance2(glm::ivec3 cell) const {
        int64_t sum = 0;
        for (int a = 0; a < 3; ++a) {
            const int64_t d = int64_t(cell[a]) * kBrushUnit + kBrushUnit / 2 - m_sphere.a[size_t(a)];
            sum += d * d;
        }
        return sum;
    }

    VoxelGrid& m_grid;
    const Brush& m_sphere;
    const Palette& m_palette;
    const MaterialTable& m_materials;
    const Densities m_densities;
    const FracturePlan& m_plan;
    std::array<uint8_t, 256> m_groupOf{};  ///< by palette entry
    std::vector<Group> m_groups;
    std::vector<BrickSubset> m_zone;  ///< voxels that break; each brick once, by cellBefore()
    std::vector<Cluster> m_clusters;  ///< in the order of their first voxel
    IndexMap m_clusterOf;             ///< by label
    std::vector<BrickPart> m_parts;   ///< of isConnectedBrick()
    FractureResult m_out;
};

/// Lists the materials of the palette that break.
void Fracturer::makeGroups() {
    std::array<uint8_t, 256> groupOfMaterial;
    groupOfMaterial.fill(kNoGroup);
    for (size_t i = 1; i < 256; ++i) {
        const uint8_t material = m_palette[i].material;
        const Material& of = m_materials[material];
        if (material == 0 || of.hardness > Hardness::Hard || !breaksWith(of, m_plan.tool)) continue;
        const FragmentStyle& style = fragmentStyle(of.fragments);
        const int64_t radius = m_sphere.radii[size_t(of.hardness)];
        if (style.pattern == FragmentPattern::None || radius <= 0) continue;
        if (groupOfMaterial[material] == kNoGroup) {
            groupOfMaterial[material] = uint8_t(m_groups.size());
            Group& group = m_groups.emplace_back();
            group.style = &style;
            group.material = material;
            const int64_t breakRadius = radius * style.breakRadius / 255, dust = radius * style.dust / 255;
            group.breakRadius2 = breakRadius * breakRadius;
            group.dust2 = dust * dust;
        }
        m_groupOf[i] = groupOfMaterial[material];
    }
}

/// Lists the voxels within the break radius of their material.
void Fracturer::collectZone() {
    const CellBox range = brushBricks(m_sphere, m_grid.sizeInBricks());
    for (int z = range.low.z; z < range.high.z; ++z)
        for (int y = range.low.y; y < range.high.y; ++y)
            for (int x = range.low.x; x < range.high.x; ++x) {
                BrickSubset subset{{x, y, z}, {}};
                const Brick* brick = m_grid.brickAt(subset.brick);
                if (!brick) continue;
                forEachVoxel(brick->occupancy, [&](int i) {
                    const size_t g = m_groupOf[brick->at(i)];
                    if (g == kNoGroup) return;
                    Group& group = m_groups[g];
                    const glm::ivec3 cell = subset.brick * kBrickSize + voxelInBrick(i);
                    const int64_t away2 = distance2(cell);
                    if (away2 > group.breakRadius2) return;
                    setVoxel(subset.voxels, i);
                    ++group.voxels;
                    if (away2 < group.nearest2) group.nearest2 = away2, group.nearest = cell;
                });
                if (subset.voxels != BrickBits{}) m_zone.push_back(subset);
            }
}

/// Adds the whole pane that was hit to the zone.
void Fracturer::growPane(size_t g) {
    const auto isOfPane = [&](uint8_t entry) { return m_groupOf[entry] == g; };
    m_groups[g].voxels = 0;
    for (const BrickSubset& subset : findPane(m_grid, m_groups[g].nearest, isOfPane, m_plan.maxPaneVoxels)) {
        for (const uint64_t layer : subset.voxels) m_groups[g].voxels += uint64_t(std::popcount(layer));
        auto known = std::find_if(m_zone.begin(), m_zone.end(),
                                  [&](const BrickSubset& other) { return other.brick == subset.brick; });
        if (known == m_zone.end()) known = m_zone.insert(known, {subset.brick, {}});
        for (size_t z = 0; z < 8; ++z) known->voxels[z] |= subset.voxels[z];
    }
    std::sort(m_zone.begin(), m_zone.end(),
              [](const BrickSubset& a, const BrickSubset& b) { return cellBefore(a.brick, b.brick); });
}

/// The axis along which the material extends farthest from the hit.
int Fracturer::grainOf(const Group& group) const {
    int longest = 0, grain = 0;
    for (int a = 0; a < 3; ++a) {
        int length = 0;
        for (const int direction : {-1, 1})
            for (int i = 1; i <= kMaxGrainCells; ++i) {
                glm::ivec3 cell = group.nearest;
                cell[a] += direction * i;
                if (m_palette[m_grid.at(cell)].material != group.material) break;
                ++length;
            }
        if (length > longest) longest = length, grain = a;
    }
    return grain;
}

/// Sizes of the fragments of each material, so that at most about maxFragments are expected.
void Fracturer::chooseSizes() {
    for (Group& group : m_groups) {
        group.size.fill(std::max<int64_t>(m_plan.unitsPerMetre * group.style->size / 1000, kBrushUnit));
        if (group.style->elongation > 1 && group.voxels) group.size[size_t(grainOf(group))] *= group.style->elongation;
    }
    const auto expected = [&] {
        uint64_t sum = 0;
        for (const Group& group : m_groups) sum += group.voxels / group.fragmentVoxels();
        return sum;
    };
    while (expected() > m_plan.maxFragments)
        for (Group& group : m_groups)
            for (int64_t& size : group.size) size = size * 5 / 4;
}

/// The fragment that a voxel belongs to: its material, whether it is near the hit, and its site.
uint64_t Fracturer::labelOf(size_t g, glm::ivec3 cell, bool isNear) const {
    const Group& group = m_groups[g];
    const uint32_t jitter = hashCell(cell.x, cell.y, cell.z, m_plan.seed ^ 0x7f4a7c15u);
    CubePoint point{};
    for (size_t a = 0; a < 3; ++a) {
        const int64_t size = isNear ? std::max<int64_t>(group.size[a] / 2, kBrushUnit) : group.size[a];
        const int64_t center = int64_t(cell[int(a)]) * kBrushUnit + kBrushUnit / 2;
        const int32_t displacement = (int32_t(jitter >> 8 * a & 255) - 128) * group.style->roughness / 255;
        point[a] = int32_t(floorDivide(center * 256, size)) + displacement;
    }
    const bool isBond = group.style->pattern == FragmentPattern::Bond;
    const glm::ivec3 site = isBond ? brickInBond(point) : nearestSite(point, m_plan.seed + uint32_t(isNear));
    const auto bits = [](int v) { return uint64_t(uint32_t(v) & 0x3ffffu); };
    return uint64_t(g) << 55 | uint64_t(isNear) << 54 | bits(site.x) << 36 | bits(site.y) << 18 | bits(site.z);
}

/// Whether the next voxel along some axis belongs to another fragment of the pane. Such voxels become dust: without a
/// gap the fragments would be stuck in the frame.
bool Fracturer::isOnCrack(size_t g, glm::ivec3 cell, bool isNear, uint64_t label) const {
    for (int a = 0; a < 3; ++a) {
        glm::ivec3 next = cell;
        ++next[a];
        const uint8_t entry = m_grid.at(next);
        if (entry && m_groupOf[entry] == g && labelOf(g, next, isNear) != label) return true;
    }
    return false;
}

/// Makes each voxel of a brick dust, or part of the cluster of its label.
void Fracturer::assignClusters(const BrickSubset& subset) {
    const Brick& brick = *m_grid.brickAt(subset.brick);
    BrickBits dust{};
    uint64_t lastLabel = ~uint64_t(0);
    uint32_t cluster = 0;
    forEachVoxel(subset.voxels, [&](int i) {
        const size_t g = m_groupOf[brick.at(i)];
        const Group& group = m_groups[g];
        const glm::ivec3 cell = subset.brick * kBrickSize + voxelInBrick(i);
        const int64_t away2 = distance2(cell);
        if (away2 <= group.dust2) return setVoxel(dust, i);
        const bool isNear = away2 * 4 < group.breakRadius2;
        const uint64_t label = labelOf(g, cell, isNear);
        if (group.style->wholePane && isOnCrack(g, cell, isNear, label)) return setVoxel(dust, i);
        if (label != lastLabel) {
            uint32_t& known = m_clusterOf[label];
            if (known == IndexMap::kNone) known = uint32_t(m_clusters.size()), m_clusters.push_back({g, 0, {}});
            cluster = known;
            lastLabel = label;
        }
        Cluster& into = m_clusters[cluster];
        if (into.subsets.empty() || into.subsets.back().brick != subset.brick)
            into.subsets.push_back({subset.brick, {}});
        setVoxel(into.subsets.back().voxels, i);
        ++into.voxels;
    });
    addDust(brick, dust, subset.brick);
}

void Fracturer::addDust(const Brick& brick, const BrickBits& bits, glm::ivec3 position) {
    if (bits == BrickBits{}) return;
    forEachVoxel(bits, [&](int i) { ++m_out.dust.removed[brick.at(i)], ++m_out.dust.voxels; });
    m_out.dust.moments += brickMoments(brick, bits, position, m_densities);
}

/// Whether all of a grid is one brick, whose voxels are connected: most fragments are.
bool Fracturer::isConnectedBrick(const VoxelGrid& grid) {
    if (grid.sizeInBricks() != glm::ivec3(1)) return false;
    m_parts.clear();
    findBrickParts(grid.brickAt(glm::ivec3(0))->occupancy, m_parts);
    return m_parts.size() == 1;
}

/// Makes a cluster fragments: one for each of its components.
void Fracturer::addFragment(const Cluster& cluster) {
    const Group& group = m_groups[cluster.group];
    if (isTooSmall(cluster.voxels, group)) {
        for (const BrickSubset& subset : cluster.subsets)
            addDust(*m_grid.brickAt(subset.brick), subset.voxels, subset.brick);
        return;
    }
    Piece packed = packPiece(m_grid, cluster.subsets);
    if (isConnectedBrick(packed.grid)) return addPiece(std::move(packed), group);
    const std::vector<Component> parts = findComponents(packed.grid);
    if (parts.size() == 1) return addPiece(std::move(packed), group);
    for (const Component& part : parts) {
        Piece piece = takePiece(packed.grid, part);
        piece.offset += packed.offset;
        addPiece(std::move(piece), group);
    }
}

/// Makes a connected piece a fragment, or dust if it is too small.
void Fracturer::addPiece(Piece&& piece, const Group& group) {
    MassMoments moments;
    piece.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        moments += brickMoments(*brick, brick->occupancy, position, m_densities);
    });
    moments = moments.shifted(piece.offset);
    if (!isTooSmall(piece.grid.voxelCount(), group)) {
        m_out.fragments.push_back({std::move(piece), moments});
        return;
    }
    piece.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) { ++m_out.dust.removed[brick->at(i)], ++m_out.dust.voxels; });
    });
    m_out.dust.moments += moments;
}

/// Makes the fragments, and removes the zone from the grid.
void Fracturer::removeZone() {
    for (const Cluster& cluster : m_clusters) addFragment(cluster);
    for (const BrickSubset& subset : m_zone) {
        const BrickRef brick = m_grid.shareBrick(subset.brick);
        BrickBits keep;
        for (size_t z = 0; z < 8; ++z) keep[z] = brick->occupancy[z] & ~subset.voxels[z];
        m_grid.setBrick(subset.brick, maskBrick(*brick, keep));
        m_out.dust.addBrick(subset);
    }
}

}  // namespace

FractureResult fracture(VoxelGrid& grid, const Brush& sphere, const Palette& palette, const MaterialTable& materials,
                        const FracturePlan& plan) {
    RUBBLE_ASSERT(sphere.kind == BrushKind::Sphere);
    return Fracturer(grid, sphere, palette, materials, plan).run();
}

}  // namespace rubble
