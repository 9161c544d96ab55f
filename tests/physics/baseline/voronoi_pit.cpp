#include "tests/physics/baseline/voronoi_pit.h"

#include <algorithm>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/voxel/mass_properties.h"

namespace rubble {
namespace {

constexpr uint8_t kMasonry = 7;

/// Entry i has material i.
const PaletteRef& palette() {
    static const PaletteRef shared = [] {
        auto entries = std::make_shared<Palette>();
        for (size_t i = 1; i < defaultMaterials().materials.size(); ++i) (*entries)[i].material = uint8_t(i);
        return entries;
    }();
    return shared;
}

/// Pieces of a block of n^3 cells of a jittered lattice, 7 voxels apart.
std::vector<VoxelGrid> voronoiPieces(int count, Random& random) {
    int n = 1;
    while (n * n * n < count) ++n;
    constexpr int kSpacing = 7;
    std::vector<glm::vec3> seeds;
    for (int i = 0; i < n * n * n; ++i) {
        glm::vec3 seed(i % n, i / n % n, i / n / n);
        for (int axis = 0; axis < 3; ++axis)
            seed[axis] = (seed[axis] + 0.5f + float(random.unit() - 0.5) * 0.7f) * kSpacing;
        seeds.push_back(seed);
    }
    std::vector<VoxelGrid> pieces;
    for (int i = 0; i < n * n * n && int(pieces.size()) < count; ++i) {
        const glm::ivec3 home(i % n, i / n % n, i / n / n), low = (home - 1) * kSpacing;
        VoxelGrid grid(glm::ivec3(3 * kSpacing));
        {
            GridWriter writer(grid);
            for (int z = 0; z < 3 * kSpacing; ++z)
                for (int y = 0; y < 3 * kSpacing; ++y)
                    for (int x = 0; x < 3 * kSpacing; ++x) {
                        const glm::ivec3 cell = low + glm::ivec3(x, y, z);
                        if (glm::any(glm::lessThan(cell, glm::ivec3(0))) ||
                            glm::any(glm::greaterThanEqual(cell, glm::ivec3(n * kSpacing))))
                            continue;
                        const glm::vec3 center = glm::vec3(cell) + 0.5f;
                        int nearest = -1;
                        float closest = 1e9f;
                        for (int k = 0; k < 27; ++k) {
                            const glm::ivec3 other = home + glm::ivec3(k % 3, k / 3 % 3, k / 9) - 1;
                            if (glm::any(glm::lessThan(other, glm::ivec3(0))) ||
                                glm::any(glm::greaterThanEqual(other, glm::ivec3(n))))
                                continue;
                            const int at = (other.z * n + other.y) * n + other.x;
                            const glm::vec3 d = seeds[size_t(at)] - center;
                            if (glm::dot(d, d) < closest) closest = glm::dot(d, d), nearest = at;
                        }
                        if (nearest == i) writer.set({x, y, z}, kMasonry);
                    }
        }
        pieces.push_back(std::move(grid));
    }
    return pieces;
}

void fill(VoxelGrid& grid, glm::ivec3 low, glm::ivec3 high) {
    GridWriter writer(grid);
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) writer.set({x, y, z}, kMasonry);
}

LevelBody makeBody(std::string name, VoxelGrid grid, const PaletteRef& palette, bool isStatic, const Pose& pose) {
    LevelBody body;
    body.name = name;
    body.isStatic = isStatic;
    body.pose = pose;
    LevelShape shape;
    shape.name = std::move(name);
    shape.grid = std::move(grid);
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// An open box, inside `inner` metres wide, with its inner low corner at the origin: body 0 of the level.
Level emptyPit(int inner) {
    Level level;
    const int side = inner * 10, wall = 8, height = 400, outer = side + 2 * wall;
    VoxelGrid hole({outer, height, outer});
    fill(hole, {0, 0, 0}, {outer, wall, outer});
    fill(hole, {0, wall, 0}, {wall, height, outer});
    fill(hole, {outer - wall, wall, 0}, {outer, height, outer});
    fill(hole, {wall, wall, 0}, {outer - wall, height, wall});
    fill(hole, {wall, wall, outer - wall}, {outer - wall, height, outer});
    const double w = wall * 0.1;
    level.bodies.push_back(makeBody("pit", std::move(hole), palette(), true, {{-w, -w, -w}, {1, 0, 0, 0}}));
    return level;
}

/// Adds a body turned at random with its centre of mass at `center`.
void addTurned(Level& level, VoxelGrid grid, const glm::dvec3& center, Random& random) {
    glm::dvec3 axis;
    for (int k = 0; k < 3; ++k) axis[k] = random.unit() - 0.5;
    const glm::dquat turn = glm::normalize(glm::dquat(random.unit(), axis.x, axis.y, axis.z));
    const MassProperties mass = massProperties(gridMoments(grid, *palette(), level.materials), 0.1);
    level.bodies.push_back(makeBody("piece", std::move(grid), palette(), false, {center - turn * mass.center, turn}));
}

}  // namespace

Level voronoiPit(int pieces, uint64_t seed, int pit) {
    Level level = emptyPit(pit);
    Random random(seed);
    std::vector<VoxelGrid> grids = voronoiPieces(pieces, random);
    const double pitch = double(pit) / 6.0;
    for (int i = 0; i < pieces; ++i)
        addTurned(level, std::move(grids[size_t(i)]),
                  {(i % 6 + 0.5) * pitch, 0.9 + (i / 36) * 1.35, (i / 6 % 6 + 0.5) * pitch}, random);
    return level;
}

Level boxPit(int boxes) {
    constexpr int kPit = 8, kSide = 10;  // metres; boxes along a side of a layer
    Level level = emptyPit(kPit);
    VoxelGrid box(glm::ivec3(5));
    fill(box, {0, 0, 0}, {5, 5, 5});
    Random random(1);
    for (int i = 0; i < boxes; ++i)
        addTurned(level, box,
                  {(i % kSide + 0.5) * kPit / kSide, 0.6 + (i / (kSide * kSide)) * 0.9,
                   (i / kSide % kSide + 0.5) * kPit / kSide},
                  random);
    return level;
}

}  // namespace rubble
