#include "physics/surface_features.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/type_precision.hpp>
#include <span>

namespace rubble {
namespace {

constexpr int kCluster = 4;  ///< cells on a side

/// Which cells of a row have a feature of each kind: those around which everything on its outer side is empty.
std::array<uint64_t, kFeatureKinds> findInRow(const SolidRows& rows, int y, int z) {
    std::array<uint64_t, kFeatureKinds> found{};
    const uint64_t own = rows.row(y, z);
    const auto beside = [](uint64_t row, size_t high) { return high ? row >> 1 : row << 1; };  // seen from the cell itself
    for (size_t hz = 0; hz < 2; ++hz)
        for (size_t hy = 0; hy < 2; ++hy) {
            const int dy = hy ? 1 : -1, dz = hz ? 1 : -1;
            const uint64_t byY = rows.row(y + dy, z), byZ = rows.row(y, z + dz), all = byY | byZ | rows.row(y + dy, z + dz);
            found[8 + hy + 2 * hz] = own & ~all;
            for (size_t hx = 0; hx < 2; ++hx) {
                found[hx + 2 * hy + 4 * hz] = own & ~(all | beside(own | all, hx));
                found[12 + hz + 2 * hx] = own & ~(byZ | beside(own | byZ, hx));
                found[16 + hx + 2 * hy] = own & ~(byY | beside(own | byY, hx));
            }
        }
    return found;
}

struct Feature {
    glm::u8vec3 cell;
    uint8_t kind;
};

glm::ivec3 halfCellsOf(uint8_t kind) {
    return glm::ivec3(featureKinds()[kind].place * 2.0f);
}

void addCluster(FeatureList& list, size_t number, std::span<const Feature> features) {
    if (number % 4 == 0) {
        FeatureList::ClusterFour& none = list.clusters.emplace_back();
        for (size_t axis = 0; axis < 3; ++axis) none.low[axis].fill(255), none.high[axis].fill(0);
        none.from.fill(0), none.to.fill(0);
    }
    FeatureList::ClusterFour& clusters = list.clusters.back();
    const size_t lane = number % 4;
    glm::ivec3 low(255), high(0);
    clusters.from[lane] = uint32_t(list.fours.size());
    for (size_t i = 0; i < features.size(); ++i) {
        if (i % 4 == 0) list.fours.emplace_back().kind.fill(FeatureList::kNoFeature);
        const glm::ivec3 p = glm::ivec3(features[i].cell) * 2 + halfCellsOf(features[i].kind);
        FeatureList::Four& four = list.fours.back();
        four.x[i % 4] = uint8_t(p.x), four.y[i % 4] = uint8_t(p.y), four.z[i % 4] = uint8_t(p.z);
        four.kind[i % 4] = features[i].kind;
        low = glm::min(low, p), high = glm::max(high, p);
    }
    clusters.to[lane] = uint32_t(list.fours.size());
    for (int axis = 0; axis < 3; ++axis)
        clusters.low[size_t(axis)][lane] = uint8_t(low[axis]), clusters.high[size_t(axis)][lane] = uint8_t(high[axis]);
}

/// The features of rows [z, z + kCluster), by clusters.
void findInSlab(const SolidRows& rows, int z0, std::vector<std::vector<Feature>>& found) {
    const glm::ivec3 size = rows.box().high - rows.box().low;
    const int across = (size.x + kCluster - 1) / kCluster;
    const uint64_t inside = ~uint64_t(0) >> (64 - size.x);
    for (int z = z0; z < std::min(z0 + kCluster, size.z); ++z)
        for (int y = 0; y < size.y; ++y) {
            if (!(rows.row(y, z) >> SolidRows::kAround & inside)) continue;
            const std::array<uint64_t, kFeatureKinds> masks = findInRow(rows, y, z);
            uint64_t any = 0;
            for (const uint64_t mask : masks) any |= mask;
            any = any >> SolidRows::kAround & inside;
            for (; any; any &= any - 1) {
                const int x = std::countr_zero(any);
                for (size_t kind = 0; kind < kFeatureKinds; ++kind)
                    if (masks[kind] >> (x + SolidRows::kAround) & 1)
                        found[size_t(y / kCluster * across + x / kCluster)].push_back({glm::u8vec3(x, y, z), uint8_t(kind)});
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

glm::ivec3 FeatureList::cellOf(const Four& four, size_t i) {
    return (glm::ivec3(four.x[i], four.y[i], four.z[i]) - halfCellsOf(four.kind[i])) / 2;
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
