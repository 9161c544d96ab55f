#include "physics/surface_features.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/type_precision.hpp>
#include <span>

namespace rubble {
namespace {

constexpr int kCluster = 4;  ///< cells on a side

/// Cells of a row whose neighbour towards d is solid: shifted to the cell itself.
uint64_t seen(const SolidRows& rows, int y, int z, glm::ivec3 d) {
    const uint64_t row = rows.row(y + d.y, z + d.z);
    return d.x < 0 ? row << 1 : d.x > 0 ? row >> 1 : row;
}

glm::ivec3 outwardOf(int kind) {
    const glm::vec3 o = featureKinds()[size_t(kind)].outward;
    return {int(o.x), int(o.y), int(o.z)};
}

/// Cells of a row around which everything on a feature's outer side is empty.
uint64_t convex(const SolidRows& rows, int y, int z, glm::ivec3 out) {
    uint64_t solid = 0;
    for (int part = 1; part < 8; ++part) {
        const glm::ivec3 d(part & 1 ? out.x : 0, part & 2 ? out.y : 0, part & 4 ? out.z : 0);
        if (d != glm::ivec3(0)) solid |= seen(rows, y, z, d);
    }
    return ~solid;
}

struct Feature {
    glm::u8vec3 cell;
    uint8_t kind;
};

void addCluster(FeatureList& list, size_t number, std::span<const Feature> features) {
    if (number % 4 == 0) {
        FeatureList::ClusterFour& none = list.clusters.emplace_back();
        for (int axis = 0; axis < 3; ++axis) none.low[size_t(axis)].fill(std::nanf("")), none.high[size_t(axis)].fill(std::nanf(""));
        none.from.fill(0), none.to.fill(0);
    }
    FeatureList::ClusterFour& clusters = list.clusters.back();
    const size_t lane = number % 4;
    glm::vec3 low(1e9f), high(-1e9f);
    clusters.from[lane] = uint32_t(list.fours.size());
    for (size_t i = 0; i < features.size(); ++i) {
        if (i % 4 == 0) {
            FeatureList::Four& none = list.fours.emplace_back();
            none.x.fill(std::nanf("")), none.y.fill(std::nanf("")), none.z.fill(std::nanf(""));
        }
        const glm::vec3 p = glm::vec3(features[i].cell) + featureKinds()[features[i].kind].place;
        FeatureList::Four& four = list.fours.back();
        four.x[i % 4] = p.x, four.y[i % 4] = p.y, four.z[i % 4] = p.z;
        four.cell[i % 4] = {features[i].cell.x, features[i].cell.y, features[i].cell.z};
        four.kind[i % 4] = features[i].kind;
        low = glm::min(low, p), high = glm::max(high, p);
    }
    clusters.to[lane] = uint32_t(list.fours.size());
    for (int axis = 0; axis < 3; ++axis) clusters.low[size_t(axis)][lane] = low[axis], clusters.high[size_t(axis)][lane] = high[axis];
}

/// The features of rows [z, z + kCluster), by clusters.
void findInSlab(const SolidRows& rows, int z0, std::vector<std::vector<Feature>>& found) {
    static const auto outwards = [] {
        std::array<glm::ivec3, kFeatureKinds> all{};
        for (int kind = 0; kind < kFeatureKinds; ++kind) all[size_t(kind)] = outwardOf(kind);
        return all;
    }();
    const glm::ivec3 size = rows.box().high - rows.box().low;
    const int across = (size.x + kCluster - 1) / kCluster;
    const uint64_t inside = ~uint64_t(0) >> (64 - size.x);
    for (int z = z0; z < std::min(z0 + kCluster, size.z); ++z)
        for (int y = 0; y < size.y; ++y) {
            const uint64_t own = rows.row(y, z) >> SolidRows::kAround & inside;
            if (!own) continue;
            std::array<uint64_t, kFeatureKinds> masks{};
            uint64_t any = 0;
            for (size_t kind = 0; kind < kFeatureKinds; ++kind) any |= masks[kind] = convex(rows, y, z, outwards[kind]) >> SolidRows::kAround & own;
            for (; any; any &= any - 1) {
                const int x = std::countr_zero(any);
                for (size_t kind = 0; kind < kFeatureKinds; ++kind)
                    if (masks[kind] >> x & 1) found[size_t(y / kCluster * across + x / kCluster)].push_back({glm::u8vec3(x, y, z), uint8_t(kind)});
            }
        }
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

FeatureList findFeatures(const SolidRows& rows) {
    FeatureList list;
    const glm::ivec3 size = rows.box().high - rows.box().low, clusters = (size + kCluster - 1) / kCluster;
    std::vector<std::vector<Feature>> found(size_t(clusters.x) * size_t(clusters.y));
    size_t number = 0;
    for (int z = 0; z < size.z; z += kCluster) {
        findInSlab(rows, z, found);
        for (std::vector<Feature>& cluster : found) {
            list.count += cluster.size();
            if (!cluster.empty()) addCluster(list, number++, cluster);
            cluster.clear();
        }
    }
    return list;
}

}  // namespace rubble
