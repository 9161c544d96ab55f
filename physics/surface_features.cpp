#include "physics/surface_features.h"

#include <cmath>

namespace rubble {
namespace {

/// A brick's occupancy with one cell of its neighbours all around: bit x + 1 of row (y + 1) + 10 (z + 1).
using Rows = std::array<uint16_t, 100>;

Rows collectRows(const VoxelGrid& grid, glm::ivec3 brick) {
    Rows rows{};
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const Brick* b = grid.brickAt(brick + glm::ivec3(dx, dy, dz));
                if (!b) continue;
                const int z0 = dz < 0 ? 7 : 0, z1 = dz > 0 ? 0 : 7, y0 = dy < 0 ? 7 : 0, y1 = dy > 0 ? 0 : 7;
                for (int z = z0; z <= z1; ++z)
                    for (int y = y0; y <= y1; ++y) {
                        const uint32_t bits = uint32_t(b->occupancy[size_t(z)] >> (8 * y)) & 0xff;
                        const uint32_t placed = dx == 0 ? bits << 1 : dx < 0 ? bits >> 7 : (bits & 1) << 9;
                        rows[size_t((y + 8 * dy + 1) + 10 * (z + 8 * dz + 1))] |= uint16_t(placed);
                    }
            }
    return rows;
}

/// Cells of a row whose neighbour towards +-x, +-y, +-z is solid are shifted to the cell itself.
uint32_t seen(const Rows& rows, int y, int z, glm::ivec3 d) {
    const uint32_t row = rows[size_t((y + d.y + 1) + 10 * (z + d.z + 1))];
    return (d.x < 0 ? row << 1 : d.x > 0 ? row >> 1 : row) >> 1;
}

glm::ivec3 outwardOf(int kind) {
    const glm::vec3 o = featureKinds()[size_t(kind)].outward;
    return {int(o.x), int(o.y), int(o.z)};
}

/// Cells of a row around which everything on a feature's outer side is empty.
uint32_t convex(const Rows& rows, int y, int z, glm::ivec3 out) {
    uint32_t around = 0;
    for (int part = 1; part < 8; ++part) {
        const glm::ivec3 d(part & 1 ? out.x : 0, part & 2 ? out.y : 0, part & 4 ? out.z : 0);
        if (d != glm::ivec3(0)) around |= seen(rows, y, z, d);
    }
    return seen(rows, y, z, {0, 0, 0}) & ~around & 0xff;
}

void add(FeatureList& list, glm::ivec3 voxel, int kind) {
    const glm::vec3 place = glm::vec3(voxel) + featureKinds()[size_t(kind)].place;
    list.x.push_back(place.x);
    list.y.push_back(place.y);
    list.z.push_back(place.z);
    list.voxel.push_back(uint16_t(voxelIndex(voxel)));
    list.kind.push_back(uint8_t(kind));
}

}  // namespace

const std::array<FeatureKind, kFeatureKinds>& featureKinds() {
    static const auto kinds = [] {
        std::array<FeatureKind, kFeatureKinds> all{};
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 high(i & 1, i >> 1 & 1, i >> 2);
            all[size_t(i)] = {high, high * 2.0f - 1.0f, -1};
        }
        for (int i = 0; i < 12; ++i) {
            const int axis = i / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
            FeatureKind& kind = all[size_t(8 + i)];
            kind.edgeAxis = axis;
            kind.place[axis] = 0.5f;
            kind.place[u] = float(i & 1);
            kind.place[v] = float(i >> 1 & 1);
            kind.outward[u] = kind.place[u] * 2.0f - 1.0f;
            kind.outward[v] = kind.place[v] * 2.0f - 1.0f;
        }
        return all;
    }();
    return kinds;
}

FeatureList findFeatures(const VoxelGrid& grid, glm::ivec3 brick) {
    FeatureList found;
    if (!grid.brickAt(brick)) return found;
    const Rows rows = collectRows(grid, brick);
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 8; ++y) {
            if (!seen(rows, y, z, {0, 0, 0})) continue;
            std::array<uint32_t, kFeatureKinds> masks{};
            uint32_t any = 0;
            for (int kind = 0; kind < kFeatureKinds; ++kind) any |= masks[size_t(kind)] = convex(rows, y, z, outwardOf(kind));
            for (; any; any &= any - 1) {
                const int x = std::countr_zero(any);
                for (int kind = 0; kind < kFeatureKinds; ++kind)
                    if (masks[size_t(kind)] >> x & 1) add(found, {x, y, z}, kind);
            }
        }
    for (std::vector<float>* row : {&found.x, &found.y, &found.z}) row->resize((found.size() + 3) & ~size_t(3), std::nanf(""));
    return found;
}

BrickBits dilateBrick(const VoxelGrid& grid, glm::ivec3 brick) {
    const Rows rows = collectRows(grid, brick);
    BrickBits out{};
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 8; ++y) {
            uint32_t any = 0;
            for (int i = 0; i < 9; ++i) any |= rows[size_t((y + i % 3) + 10 * (z + i / 3))];
            out[size_t(z)] |= uint64_t((any | any << 1 | any >> 1) >> 1 & 0xff) << (8 * y);
        }
    return out;
}

}  // namespace rubble
