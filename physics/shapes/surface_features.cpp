#include "physics/shapes/surface_features.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr int kClusterSize = 4;  ///< cells on a side

/// For each kind of feature, the cells of a row that have it: all cells on its outer side are empty. Bits as in the
/// row.
std::array<uint64_t, kFeatureKinds> featuresInRow(const SolidRows& rows, int y, int z) {
    std::array<uint64_t, kFeatureKinds> found{};
    const uint64_t own = rows.row(y, z);
    // At the bit of each cell, its neighbour on the high or low side.
    const auto neighbour = [](uint64_t row, size_t high) { return high ? row >> 1 : row << 1; };
    for (size_t hz = 0; hz < 2; ++hz)
        for (size_t hy = 0; hy < 2; ++hy) {
            const int dy = hy ? 1 : -1, dz = hz ? 1 : -1;
            const uint64_t byY = rows.row(y + dy, z), byZ = rows.row(y, z + dz),
                           all = byY | byZ | rows.row(y + dy, z + dz);
            found[8 + hy + 2 * hz] = own & ~all;
            for (size_t hx = 0; hx < 2; ++hx) {
                found[hx + 2 * hy + 4 * hz] = own & ~(all | neighbour(own | all, hx));
                found[12 + hz + 2 * hx] = own & ~(byZ | neighbour(own | byZ, hx));
                found[16 + hx + 2 * hy] = own & ~(byY | neighbour(own | byY, hx));
            }
        }
    return found;
}

struct Feature {
    glm::u8vec3 cell;
    uint8_t kind;
};

glm::ivec3 halfCellOffset(uint8_t kind) {
    return glm::ivec3(featureKinds()[kind].offset * 2.0f);
}

/// Appends a cluster; number: of clusters before it.
void addCluster(FeatureList& list, size_t number, std::span<const Feature> features) {
    if (number % 4 == 0) {
        FeatureList::ClusterPack& none = list.clusters.emplace_back();
        for (size_t axis = 0; axis < 3; ++axis) none.low[axis].fill(255), none.high[axis].fill(0);
        none.from.fill(0), none.to.fill(0);
    }
    FeatureList::ClusterPack& clusters = list.clusters.back();
    const size_t lane = number % 4;
    glm::ivec3 low(255), high(0);
    clusters.from[lane] = uint32_t(list.packs.size());
    for (size_t i = 0; i < features.size(); ++i) {
        if (i % 4 == 0) list.packs.emplace_back().kind.fill(FeatureList::kNoFeature);
        const glm::ivec3 p = glm::ivec3(features[i].cell) * 2 + halfCellOffset(features[i].kind);
        FeatureList::Pack& pack = list.packs.back();
        pack.x[i % 4] = uint8_t(p.x), pack.y[i % 4] = uint8_t(p.y), pack.z[i % 4] = uint8_t(p.z);
        pack.kind[i % 4] = features[i].kind;
        low = glm::min(low, p), high = glm::max(high, p);
    }
    clusters.to[lane] = uint32_t(list.packs.size());
    for (int axis = 0; axis < 3; ++axis)
        clusters.low[size_t(axis)][lane] = uint8_t(low[axis]), clusters.high[size_t(axis)][lane] = uint8_t(high[axis]);
}

/// The features of layers z0 to z0 + kClusterSize, by cluster.
void findInSlab(const SolidRows& rows, int z0, std::vector<std::vector<Feature>>& found) {
    const glm::ivec3 size = rows.box().high - rows.box().low;
    const int across = (size.x + kClusterSize - 1) / kClusterSize;
    const uint64_t inside = ~uint64_t(0) >> (64 - size.x);
    for (int z = z0; z < std::min(z0 + kClusterSize, size.z); ++z)
        for (int y = 0; y < size.y; ++y) {
            if (!(rows.row(y, z) >> SolidRows::kPadding & inside)) continue;
            const std::array<uint64_t, kFeatureKinds> masks = featuresInRow(rows, y, z);
            uint64_t any = 0;
            for (const uint64_t mask : masks) any |= mask;
            any = any >> SolidRows::kPadding & inside;
            for (; any; any &= any - 1) {
                const int x = std::countr_zero(any);
                std::vector<Feature>& cluster = found[size_t(y / kClusterSize * across + x / kClusterSize)];
                for (size_t kind = 0; kind < kFeatureKinds; ++kind)
                    if (masks[kind] >> (x + SolidRows::kPadding) & 1)
                        cluster.push_back({glm::u8vec3(x, y, z), uint8_t(kind)});
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
            kind.offset[axis] = 0.5f;
            kind.offset[u] = float(i & 1);
            kind.offset[v] = float(i >> 1 & 1);
            kind.outward[u] = kind.offset[u] * 2.0f - 1.0f;
            kind.outward[v] = kind.offset[v] * 2.0f - 1.0f;
        }
        return all;
    }();
    return kinds;
}

glm::ivec3 FeatureList::cellOf(const Pack& pack, size_t i) {
    return (glm::ivec3(pack.x[i], pack.y[i], pack.z[i]) - halfCellOffset(pack.kind[i])) / 2;
}

namespace {

/// Bricks by the thousand are searched one after the other: what they need on the way keeps its memory.
struct Scratch {
    std::vector<std::vector<Feature>> found;
    FeatureList features;
};

/// Not thread_local: a thread that has something to destroy keeps the library in memory after dlclose().
class ScratchPool {
public:
    std::unique_ptr<Scratch> take() {
        const std::lock_guard lock(m_mutex);
        if (m_free.empty()) return std::make_unique<Scratch>();
        std::unique_ptr<Scratch> out = std::move(m_free.back());
        m_free.pop_back();
        return out;
    }
    void give(std::unique_ptr<Scratch> scratch) {
        const std::lock_guard lock(m_mutex);
        m_free.push_back(std::move(scratch));
    }

private:
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Scratch>> m_free;
};

}  // namespace

FeatureList findFeatures(const SolidRows& rows) {
    const glm::ivec3 size = rows.box().high - rows.box().low, clusters = (size + kClusterSize - 1) / kClusterSize;
    static ScratchPool pool;
    std::unique_ptr<Scratch> lent = pool.take();
    auto& [found, scratch] = *lent;
    if (const size_t needed = size_t(clusters.x) * size_t(clusters.y); found.size() < needed) found.resize(needed);
    scratch.packs.clear(), scratch.clusters.clear(), scratch.count = 0;
    size_t number = 0;
    for (int z = 0; z < size.z; z += kClusterSize) {
        findInSlab(rows, z, found);
        for (std::vector<Feature>& cluster : found) {
            scratch.count += cluster.size();
            if (!cluster.empty()) addCluster(scratch, number++, cluster);
            cluster.clear();
        }
    }
    FeatureList out = scratch;
    pool.give(std::move(lent));
    return out;
}

}  // namespace rubble
