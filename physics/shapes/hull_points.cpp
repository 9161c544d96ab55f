#include "physics/shapes/hull_points.h"

#include <algorithm>
#include <bit>

#include "physics/math/simd4.h"

namespace rubble {
namespace {

/// For each line of cell corners along x (one for each y and z): the first or last corner of a solid cell on it.
struct RowEnds {
    RowEnds(const SolidRows& rows, bool last)
        : ny(rows.box().high.y - rows.box().low.y + 1), nz(rows.box().high.z - rows.box().low.z + 1) {
        ends.reserve(size_t(ny) * size_t(nz));
        for (int z = 0; z < nz; ++z)
            for (int y = 0; y < ny; ++y) {
                const uint64_t row = rows.row(y, z) | rows.row(y - 1, z) | rows.row(y, z - 1) | rows.row(y - 1, z - 1);
                ends.push_back(
                    !row ? kNone : (last ? 64 - std::countl_zero(row) : std::countr_zero(row)) - SolidRows::kPadding);
            }
    }
    static constexpr int kNone = -100;  ///< no cell around the line is solid
    int& at(int y, int z) { return ends[size_t(z * ny + y)]; }
    int ny, nz;
    std::vector<int> ends;
};

/// Keeps of the points (at(t), t), t = 0 .. count - 1, the corners of their convex hull on the side of sign * x, and
/// sets the others to kNone. This is Andrew's monotone chain (1979).
template <class At>
void keepHullCorners(int count, int sign, At&& at) {
    std::array<int, SolidRows::kMaxLength + 1> kept{};
    size_t n = 0;
    const auto isBetween = [&](int a, int b, int c) {
        return sign * ((at(b) - at(a)) * (c - a) - (at(c) - at(a)) * (b - a)) <= 0;
    };
    for (int t = 0; t < count; ++t) {
        if (at(t) == RowEnds::kNone) continue;
        for (; n >= 2 && isBetween(kept[n - 2], kept[n - 1], t); --n) at(kept[n - 1]) = RowEnds::kNone;
        kept[n++] = t;
    }
}

}  // namespace

HullPoints::HullPoints(const CellBox& bounds) {
    for (int i = 0; i < 8; ++i)
        add({i & 1 ? bounds.high.x : bounds.low.x, i & 2 ? bounds.high.y : bounds.low.y,
             i & 4 ? bounds.high.z : bounds.low.z});
}

/// A corner of the hull is a corner of every planar section through it. So points that are no corners of their section
/// of constant z are dropped, then those that are none of their section of constant y; few others are left.
HullPoints::HullPoints(const SolidRows& rows) {
    for (const int sign : {-1, 1}) {
        RowEnds ends(rows, sign > 0);
        for (int z = 0; z < ends.nz; ++z) keepHullCorners(ends.ny, sign, [&](int y) -> int& { return ends.at(y, z); });
        for (int y = 0; y < ends.ny; ++y) keepHullCorners(ends.nz, sign, [&](int z) -> int& { return ends.at(y, z); });
        for (int z = 0; z < ends.nz; ++z)
            for (int y = 0; y < ends.ny; ++y)
                if (ends.at(y, z) != RowEnds::kNone) add(rows.box().low + glm::ivec3(ends.at(y, z), y, z));
    }
}

void HullPoints::add(glm::ivec3 corner) {
    const glm::vec3 p(corner);
    if (m_count % 4 == 0) m_points.push_back({});
    for (size_t i = m_count % 4; i < 4; ++i)
        m_points.back().x[i] = p.x, m_points.back().y[i] = p.y, m_points.back().z[i] = p.z;
    ++m_count;
}

float HullPoints::support(const glm::vec3& direction) const {
    const Float4 dx = float4(direction.x), dy = float4(direction.y), dz = float4(direction.z);
    Float4 best = float4(-1e30f);
    for (const Points& p : m_points)
        best = max4(best, load(p.x.data()) * dx + load(p.y.data()) * dy + load(p.z.data()) * dz);
    return std::max(std::max(best[0], best[1]), std::max(best[2], best[3]));
}

glm::vec3 HullPoints::supportPoint(const glm::vec3& direction, float far) const {
    for (const Points& p : m_points) {
        const Float4 along =
            load(p.x.data()) * direction.x + load(p.y.data()) * direction.y + load(p.z.data()) * direction.z;
        if (const uint32_t lanes = bitsOf(along >= far)) {
            const auto i = size_t(std::countr_zero(lanes));
            return {p.x[i], p.y[i], p.z[i]};
        }
    }
    return glm::vec3(0.0f);
}

void HullPoints::bounds(const glm::mat3& axes, glm::vec3& low, glm::vec3& high) const {
    for (int k = 0; k < 3; ++k) {
        const Float4 x = float4(axes[0][k]), y = float4(axes[1][k]), z = float4(axes[2][k]);
        Float4 least = float4(1e30f), most = float4(-1e30f);
        for (const Points& p : m_points) {
            const Float4 along = load(p.x.data()) * x + load(p.y.data()) * y + load(p.z.data()) * z;
            least = min4(least, along), most = max4(most, along);
        }
        low[k] = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
        high[k] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
    }
}

}  // namespace rubble
