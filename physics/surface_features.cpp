#include "physics/surface_features.h"

#include <cmath>

namespace rubble {
namespace {

/// Cells of a row whose neighbour towards +-x, +-y, +-z is solid are shifted to the cell itself.
uint32_t seen(const BrickSurroundings& around, int y, int z, glm::ivec3 d) {
    const uint32_t row = around.rows[size_t((y + d.y + 2) + BrickSurroundings::kSize * (z + d.z + 2))];
    return (d.x < 0 ? row << 1 : d.x > 0 ? row >> 1 : row) >> 2 & 0xff;
}

glm::ivec3 outwardOf(int kind) {
    const glm::vec3 o = featureKinds()[size_t(kind)].outward;
    return {int(o.x), int(o.y), int(o.z)};
}

/// Cells of a row around which everything on a feature's outer side is empty.
uint32_t convex(const BrickSurroundings& around, int y, int z, glm::ivec3 out) {
    uint32_t solid = 0;
    for (int part = 1; part < 8; ++part) {
        const glm::ivec3 d(part & 1 ? out.x : 0, part & 2 ? out.y : 0, part & 4 ? out.z : 0);
        if (d != glm::ivec3(0)) solid |= seen(around, y, z, d);
    }
    return seen(around, y, z, {0, 0, 0}) & ~solid;
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
    const BrickSurroundings around = surroundBrick(grid, brick);
    for (int z = 0; z < 8; ++z, found.layers[size_t(z)] = uint32_t(found.size()))
        for (int y = 0; y < 8; ++y) {
            if (!seen(around, y, z, {0, 0, 0})) continue;
            std::array<uint32_t, kFeatureKinds> masks{};
            uint32_t any = 0;
            for (int kind = 0; kind < kFeatureKinds; ++kind) any |= masks[size_t(kind)] = convex(around, y, z, outwardOf(kind));
            for (; any; any &= any - 1) {
                const int x = std::countr_zero(any);
                for (int kind = 0; kind < kFeatureKinds; ++kind)
                    if (masks[size_t(kind)] >> x & 1) add(found, {x, y, z}, kind);
            }
        }
    for (std::vector<float>* row : {&found.x, &found.y, &found.z}) row->resize((found.size() + 3) & ~size_t(3), std::nanf(""));
    return found;
}

BrickSurroundings surroundBrick(const VoxelGrid& grid, glm::ivec3 brick) {
    BrickSurroundings out;
    constexpr int kAround = BrickSurroundings::kAround, kSize = BrickSurroundings::kSize;
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const Brick* b = grid.brickAt(brick + d);
        if (!b) continue;
        const int z0 = d.z < 0 ? 8 - kAround : 0, z1 = d.z > 0 ? kAround : 8, y0 = d.y < 0 ? 8 - kAround : 0, y1 = d.y > 0 ? kAround : 8;
        for (int z = z0; z < z1; ++z)
            for (int y = y0; y < y1; ++y) {
                const uint32_t bits = uint32_t(b->occupancy[size_t(z)] >> (8 * y)) & 0xff;
                const uint32_t placed = d.x == 0 ? bits << kAround : d.x < 0 ? bits >> (8 - kAround) : (bits & 3) << (8 + kAround);
                out.rows[size_t((y + 8 * d.y + kAround) + kSize * (z + 8 * d.z + kAround))] |= uint16_t(placed);
            }
    }
    return out;
}

}  // namespace rubble
