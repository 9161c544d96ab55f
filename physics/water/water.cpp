#include "physics/water/water.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rubble {
namespace {

/// Number of voxels and the sums of their places, in whole cells: exact.
struct CellSums {
    int64_t count = 0, x = 0, y = 0, z = 0;

    /// Voxels of a layer of a brick whose cell (0, 0) is at `base`.
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

/// One part against one surface.
class PartSubmersion {
public:
    PartSubmersion(const CellTransform& cells, glm::dvec3 origin, const Water& water)
        : m_cells(cells),
          m_rise(cells.axes[0].y, cells.axes[1].y, cells.axes[2].y),
          m_cornerHeight(origin.y + cells.corner.y - water.surface),
          m_half(0.5 * (std::abs(m_rise.x) + std::abs(m_rise.y) + std::abs(m_rise.z))) {}

    /// How far the lowest and highest points of a box of cells are above the surface.
    std::pair<double, double> heights(glm::dvec3 low, glm::dvec3 size) const {
        const double base = m_cornerHeight + glm::dot(m_rise, low);
        const glm::dvec3 span = m_rise * size;
        return {base + std::min(span.x, 0.0) + std::min(span.y, 0.0) + std::min(span.z, 0.0),
                base + std::max(span.x, 0.0) + std::max(span.y, 0.0) + std::max(span.z, 0.0)};
    }
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
        const glm::dvec3 middle = glm::dvec3(cell) + 0.5;
        const double height = m_cornerHeight + glm::dot(m_rise, middle);
        const double share = std::clamp(0.5 - 0.5 * height / m_half, 0.0, 1.0);
        m_cut += share;
        m_cutCells += middle * share;
        m_sunk += share * (1.0 - share) * m_half;  // from its middle to the middle of what is under
        m_cutVoxels += share > 0.0 && share < 1.0 ? 1.0 : 0.0;
    }

    const CellTransform& m_cells;
    glm::dvec3 m_rise;      ///< of each cell axis
    double m_cornerHeight;  ///< height of the cells's corner above the surface
    double m_half;          ///< of a voxel's height
    CellSums m_whole;
    double m_cut = 0.0, m_sunk = 0.0, m_cutVoxels = 0.0;
    glm::dvec3 m_cutCells{0.0};
};

}  // namespace

void addSubmersion(const VoxelPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum) {
    PartSubmersion wetting(cells, origin, water);
    const double size = part.voxelSize();
    const auto [low, high] =
        wetting.heights(glm::dvec3(part.bounds().low), glm::dvec3(part.bounds().high - part.bounds().low));
    sum.total += double(part.grid().voxelCount()) * size * size * size;
    if (low >= 0.0 || high < -water.depth) return;
    part.grid().forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 base = position * kBrickSize;
        const glm::dvec3 middle = origin + cells.corner + cells.axes * (glm::dvec3(base) + 0.5 * kBrickSize);
        if (middle.y >= water.surface - water.depth && contains(water.outline, middle.x, middle.z))
            wetting.addBrick(base, *brick);
    });
    wetting.addTo(size * size * size, sum);
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

bool WaterVolumes::act(DynamicBody& body, glm::dvec3 gravity, double seconds) const {
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
        const double displaced = sum.volume * water.density * motion.inverseMass;  // of the body's own mass
        body.applyImpulse(gravity * (-sum.volume * water.density * seconds), motion.position + sum.moment / sum.volume);
        // What is so light that it would be thrown farther than it is under in a step is held back.
        const double stiffness =
            sum.waterline * water.density * glm::length(gravity) * motion.inverseMass * seconds * seconds;
        const double held = 1.0 + std::max(0.0, stiffness - 1.0);
        const glm::dvec3 falls = gravity * seconds;
        const double kept = 1.0 / (held + seconds * water.linearDrag * displaced);
        motion.velocity = water.flow + (motion.velocity + falls - water.flow) * kept - falls;
        motion.angularVelocity *= 1.0 / (held + seconds * water.angularDrag * displaced);
    }
    return isWet;
}

}  // namespace rubble
