#include "physics/water/water.h"

#include <algorithm>
#include <bit>
#include <cmath>

// Buoyancy and drag from the voxels themselves.
//
// Archimedes: a body that displaces the volume V of water of density rho is lifted by -rho V g at the centroid of V.
// The volume is exact: bricks, layers and rows that are wholly under the surface are counted with popcount in integers;
// a voxel that the surface cuts counts by how far it is under, as if it stood upright (exact for aligned voxels, and
// over many for rotated ones). Drag is -c rho V (v - u) with the flow u, linear in the velocity (Stokes) and in V. It
// is integrated implicitly together with gravity, which acts after it: with d = rho V / m,
//     v' = u + (v + h g - u) / (1 + h c d) - h g,
// so that drag never adds energy, however strong it is, and a sinking body ends at the terminal velocity.
// A light body bobs on a stiff spring: the waterline area A gives rho A |g| / m. Where h^2 times that exceeds 1,
// explicit integration would throw the body out, and the excess is added to the denominator as damping.

namespace rubble {
namespace {

/// The number of voxels and the sums of their coordinates, in cells: exact in integers.
struct CellSums {
    int64_t count = 0, x = 0, y = 0, z = 0;

    /// Adds the voxels of one layer of a brick; base: of the layer's cell (0, 0).
    void add(uint64_t layer, glm::ivec3 base) {
        const int64_t n = std::popcount(layer);
        count += n;
        x += n * base.x + std::popcount(layer & 0xaaaaaaaaaaaaaaaaull) +
             2 * std::popcount(layer & 0xccccccccccccccccull) + 4 * std::popcount(layer & 0xf0f0f0f0f0f0f0f0ull);
        y += n * base.y + std::popcount(layer & 0xff00ff00ff00ff00ull) +
             2 * std::popcount(layer & 0xffff0000ffff0000ull) + 4 * std::popcount(layer & 0xffffffff00000000ull);
        z += n * base.z;
    }
};

/// Sums up what of one part is under one surface.
class PartSubmersion {
public:
    PartSubmersion(const CellTransform& cells, glm::dvec3 origin, const Water& water)
        : m_cells(cells),
          m_rise(cells.axes[0].y, cells.axes[1].y, cells.axes[2].y),
          m_cornerHeight(origin.y + cells.corner.y - water.surface),
          m_half(0.5 * (std::abs(m_rise.x) + std::abs(m_rise.y) + std::abs(m_rise.z))) {}

    /// The heights of the lowest and highest points of a box of cells above the surface, metres.
    std::pair<double, double> heights(glm::dvec3 low, glm::dvec3 size) const {
        const double base = m_cornerHeight + glm::dot(m_rise, low);
        const glm::dvec3 span = m_rise * size;
        return {base + std::min(span.x, 0.0) + std::min(span.y, 0.0) + std::min(span.z, 0.0),
                base + std::max(span.x, 0.0) + std::max(span.y, 0.0) + std::max(span.z, 0.0)};
    }
    /// base: the brick's first cell.
    void addBrick(glm::ivec3 base, const Brick& brick) {
        const auto [low, high] = heights(glm::dvec3(base), glm::dvec3(8.0));
        if (low >= 0.0) return;
        for (int z = 0; z < 8; ++z) {
            const uint64_t layer = brick.occupancy[size_t(z)];
            if (!layer) continue;
            const glm::ivec3 at = base + glm::ivec3(0, 0, z);
            if (high <= 0.0)
                m_whole.add(layer, at);
            else
                addLayer(at, layer);
        }
    }
    /// Adds the sums in world units.
    void addTo(double voxelVolume, Submersion& sum) const {
        const double n = double(m_whole.count);
        const glm::dvec3 cells =
            glm::dvec3(double(m_whole.x), double(m_whole.y), double(m_whole.z)) + 0.5 * n + m_cutCells;
        sum.volume += (n + m_cut) * voxelVolume;
        sum.waterline += m_cutVoxels * voxelVolume / (2.0 * m_half);
        sum.moment +=
            (m_cells.axes * cells + m_cells.corner * (n + m_cut) - glm::dvec3(0.0, m_sunk, 0.0)) * voxelVolume;
    }

private:
    void addLayer(glm::ivec3 base, uint64_t layer) {
        const auto [low, high] = heights(glm::dvec3(base), glm::dvec3(8.0, 8.0, 1.0));
        if (low >= 0.0) return;
        if (high <= 0.0) return m_whole.add(layer, base);
        for (int y = 0; y < 8; ++y) {
            const uint64_t row = layer & 0xffull << (8 * y);
            if (!row) continue;
            const auto [first, last] = heights(glm::dvec3(base + glm::ivec3(0, y, 0)), glm::dvec3(8.0, 1.0, 1.0));
            if (last <= 0.0) m_whole.add(row, base);
            if (first >= 0.0 || last <= 0.0) continue;
            for (uint64_t bits = row; bits; bits &= bits - 1)
                addVoxel(base + glm::ivec3(std::countr_zero(bits) & 7, y, 0));
        }
    }
    void addVoxel(glm::ivec3 cell) {
        const glm::dvec3 center = glm::dvec3(cell) + 0.5;
        const double height = m_cornerHeight + glm::dot(m_rise, center);
        const double share = std::clamp(0.5 - 0.5 * height / m_half, 0.0, 1.0);
        m_cut += share;
        m_cutCells += center * share;
        m_sunk += share * (1.0 - share) * m_half;  // from the voxel's centre down to that of its part under water
        m_cutVoxels += share > 0.0 && share < 1.0 ? 1.0 : 0.0;
    }

    const CellTransform& m_cells;
    glm::dvec3 m_rise;           ///< metres by which each cell axis rises
    double m_cornerHeight;       ///< of cell (0, 0, 0) above the surface, metres
    double m_half;               ///< half the height of a rotated voxel, metres
    CellSums m_whole;            ///< voxels wholly under water
    double m_cut = 0.0;          ///< volume of the cut voxels under water, in voxels
    double m_sunk = 0.0;         ///< sum over cut voxels of share * depth of its centroid, metres
    double m_cutVoxels = 0.0;    ///< their number
    glm::dvec3 m_cutCells{0.0};  ///< sum of their centres, weighted by share
};

}  // namespace

void addSubmersion(const ColliderPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum) {
    PartSubmersion submersion(cells, origin, water);
    const double size = part.voxelSize();
    const auto [low, high] =
        submersion.heights(glm::dvec3(part.bounds().low), glm::dvec3(part.bounds().high - part.bounds().low));
    if (low >= 0.0 || high < -water.depth) return;
    part.grid().forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 base = position * kBrickSize;
        const glm::dvec3 middle = origin + cells.corner + cells.axes * (glm::dvec3(base) + 0.5 * kBrickSize);
        if (middle.y >= water.surface - water.depth && contains(water.outline, middle.x, middle.z))
            submersion.addBrick(base, *brick);
    });
    submersion.addTo(size * size * size, sum);
}

std::optional<WorldBox> WaterVolumes::set(uint32_t slot, const Water* water) {
    if (m_waters.size() <= slot) m_waters.resize(slot + 1);
    std::optional<WorldBox> touched;
    if (m_waters[slot]) touched = m_waters[slot]->bounds();
    m_count += size_t(water != nullptr) - size_t(m_waters[slot].has_value());
    m_waters[slot].reset();
    m_tree.remove(slot);
    if (!water) return touched;
    m_waters[slot] = *water;
    m_tree.update(slot, water->bounds());
    return touched ? touched->merged(water->bounds()) : water->bounds();
}

const Water* WaterVolumes::at(glm::dvec3 point) const {
    const WorldBox here{point, point};
    uint32_t found = ~0u;
    m_tree.find([&](const WorldBox& box) { return box.overlaps(here); },
                [&](uint32_t slot) {
                    if (slot < found && m_waters[slot]->contains(point)) found = slot;
                });
    return found == ~0u ? nullptr : &*m_waters[found];
}

bool WaterVolumes::applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds) const {
    std::vector<uint32_t> near;
    const WorldBox bounds{body.object.low, body.object.high};
    m_tree.find([&](const WorldBox& box) { return box.overlaps(bounds); },
                [&](uint32_t slot) { near.push_back(slot); });
    std::sort(near.begin(), near.end());
    bool isWet = false;
    for (const uint32_t slot : near) {
        const Water& water = *m_waters[slot];
        Submersion sum;
        for (size_t i = 0; i < body.object.collider.parts.size(); ++i)
            addSubmersion(*body.object.collider.parts[i], body.object.cellTransforms()[i], body.object.pose.position,
                          water, sum);
        if (!(sum.volume > 0.0)) continue;
        isWet = true;
        SolverBody& motion = body.motion;
        const double displaced = sum.volume * water.density * motion.inverseMass;  // d
        body.applyImpulse(gravity * (-sum.volume * water.density * seconds), motion.position + sum.moment / sum.volume);
        // h^2 rho A |g| / m
        const double stiffness =
            sum.waterline * water.density * glm::length(gravity) * motion.inverseMass * seconds * seconds;
        const double damping = 1.0 + std::max(0.0, stiffness - 1.0);
        const glm::dvec3 fall = gravity * seconds;
        const double kept = 1.0 / (damping + seconds * water.linearDrag * displaced);
        motion.velocity = water.flow + (motion.velocity + fall - water.flow) * kept - fall;
        motion.angularVelocity *= 1.0 / (damping + seconds * water.angularDrag * displaced);
    }
    return isWet;
}

}  // namespace rubble
