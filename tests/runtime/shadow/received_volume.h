#pragma once
#include <bit>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/shadow/shadow_replica.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/voxel/cell_walk.h"
#include "tests/support/grids.h"

namespace rubble {

/// A shadow volume as its receiver has it: with every patch applied.
class Volume {
public:
    using Key = std::tuple<int, int, int>;
    /// Takes over what the worker published.
    void apply(const ShadowPatches& publication) {
        if (publication.replacesAll) m_bricks.clear();
        for (const ShadowPatch& patch : publication.patches) {
            const Key key(patch.brick.x, patch.brick.y, patch.brick.z);
            if (!patch.content) {
                m_bricks.erase(key);
                continue;
            }
            for (int i = 0; i < 64; ++i) m_bricks[key][size_t(i)] = patch.content->cells(i);
            if (++m_received % 32 == 0) m_wrongBoxes += wrongBoxes(*patch.content);
        }
    }
    /// Whether a shadow cell is solid.
    bool at(glm::ivec3 cell) const {
        const auto brick = m_bricks.find({cell.x >> 4, cell.y >> 4, cell.z >> 4});
        if (brick == m_bricks.end()) return false;
        const glm::ivec3 word = cell >> 2 & 3, bit = cell & 3;
        return brick->second[size_t(word.x + 4 * word.y + 16 * word.z)] >> (bit.x + 4 * bit.y + 16 * bit.z) & 1;
    }
    /// True if a ray from a point in metres meets a cell within `maxDistance` metres (unit direction). Plain walk, cell
    /// by cell.
    bool occluded(glm::dvec3 originWorld, glm::dvec3 direction, double maxDistance) const {
        const double cell = double(kShadowCell);
        const int half = int(maxDistance / cell) + 4;
        const glm::ivec3 low = glm::ivec3(glm::floor(originWorld / cell)) - half;
        CellWalk walk;
        const CellRay ray{originWorld / cell - glm::dvec3(low), direction, maxDistance / cell};
        for (bool inside = walk.start(ray, glm::ivec3(2 * half)); inside; inside = walk.step())
            if (at(low + walk.cell())) return true;
        return false;
    }
    /// How many cells are solid.
    size_t cellCount() const {
        size_t count = 0;
        for (const auto& [key, brick] : m_bricks)
            for (const uint64_t word : brick) count += size_t(std::popcount(word));
        return count;
    }
    bool empty() const { return m_bricks.empty(); }  ///< no brick is there
    /// Of every 32nd brick that came: boxes said to be empty that hold something or reach out of the brick.
    size_t wrongBoxes() const { return m_wrongBoxes; }
    friend bool operator==(const Volume& a, const Volume& b) { return a.m_bricks == b.m_bricks; }

private:
    static size_t wrongBoxes(const ShadowBrick& brick) {
        size_t wrong = 0;
        for (int i = 0; i < 64 * 8; ++i) {
            const int word = i >> 3, octant = i & 7;
            if (brick.cells(word)) continue;
            const glm::ivec3 first(word & 3, word >> 2 & 3, word >> 4), size = emptyBox(brick, word, octant);
            bool good = true;
            for (int k = 0; k < size.x * size.y * size.z; ++k) {
                glm::ivec3 at(k % size.x, k / size.x % size.y, k / size.x / size.y);
                for (int a = 0; a < 3; ++a) at[a] = octant >> a & 1 ? first[a] - at[a] : first[a] + at[a];
                for (int a = 0; a < 3; ++a) good = good && at[a] >= 0 && at[a] < 4;
                good = good && !brick.cells(at.x + 4 * at.y + 16 * at.z);
            }
            wrong += !good;
        }
        return wrong;
    }
    size_t m_received = 0, m_wrongBoxes = 0;
    std::map<Key, ShadowWords> m_bricks;
};

/// The volume of a world, made from nothing.
inline Volume rebuild(const World& world) {
    FrameChanges changes;
    changes.levelReplaced = true;
    changes.step = 1;
    const auto never = [] { return false; };
    ShadowReplica replica;
    replica.apply(makeShadowStep(changes, {}, world), never);
    ShadowPatches publication;
    replica.update(publication, never);
    Volume out;
    out.apply(publication);
    return out;
}

/// Uniform over all rotations: normalised points of the unit ball.
inline glm::dquat drawRotation(Random& random) {
    for (;;) {
        double q[4];
        for (double& part : q) part = 2.0 * double(random.unit()) - 1.0;
        const glm::dquat rotation(q[0], q[1], q[2], q[3]);
        const double square = glm::dot(rotation, rotation);
        if (square > 0.01 && square <= 1.0) return glm::normalize(rotation);
    }
}

/// Uniform in a cube, in the unit of its bounds.
inline glm::dvec3 drawPoint(Random& random, double low, double high) {
    glm::dvec3 p;
    for (int a = 0; a < 3; ++a) p[a] = low + (high - low) * double(random.unit());
    return p;
}

/// A palette of stone, with entry 2 of glass.
inline PaletteRef stoneAndGlass() {
    auto palette = std::make_shared<Palette>();
    for (PaletteEntry& entry : *palette) entry.material = defaultMaterials().find("brick");
    (*palette)[2].material = defaultMaterials().find("glass");
    (*palette)[2].opacity = 60;
    return palette;
}

/// A body with one shape of stone and glass.
inline LevelBody makeBody(VoxelGrid grid, const Pose& pose, bool isStatic, float voxelSize = 0.1f) {
    LevelBody body;
    body.pose = pose;
    body.isStatic = isStatic;
    LevelShape shape;
    shape.name = "shape";
    shape.voxelSize = voxelSize;
    shape.grid = std::move(grid);
    shape.palette = stoneAndGlass();
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A world of these bodies alone.
inline World worldOf(std::vector<LevelBody> bodies) {
    Level level;
    level.bodies = std::move(bodies);
    World world;
    world.load(level);
    return world;
}

}  // namespace rubble
