#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/shadow/shadow_lattice.h"

namespace rubble {

/// Cuts rows of samples along the world's x axis to a box of a shape's voxels, which leaves one interval of each.
/// In doubles, which hold the lattice's fixed-point numbers exactly.
class RowClip {
public:
    RowClip(const CellBox& box, const FixedPoint& step, int count) : m_end(count - 0.5) {
        for (size_t k = 0; k < 3; ++k) {
            m_low[k] = double(int64_t(box.low[int(k)]) << 32);
            m_high[k] = double(int64_t(box.high[int(k)]) << 32);
            m_step[k] = double(step[k]);
            m_enter[k] = step[k] < 0 ? m_high[k] : m_low[k];
            m_leave[k] = step[k] < 0 ? m_low[k] : m_high[k];
            m_inverse[k] = step[k] ? 1.0 / m_step[k] : 1e100;  // from outside it never enters
        }
    }
    struct Interval {
        int low, high;
    };
    /// The samples of [0, count) that lie inside, of the row whose first sample is given.
    Interval operator()(double x, double y, double z) const {
        constexpr double kDoubt = 1e-6;  // more than the estimate errs; where that matters the exact place decides
        const double from = std::max(std::max(enters(x, 0), 0.0), std::max(enters(y, 1), enters(z, 2)));
        const double to = std::min(std::min(leaves(x, 0), m_end), std::min(leaves(y, 1), leaves(z, 2)));
        if (!(from <= to + kDoubt)) return {0, 0};
        const Interval estimate{int(from + (1.0 - kDoubt)), int(to + (1.0 + kDoubt))};
        if (estimate.low >= from + kDoubt && estimate.high <= to + (1.0 - kDoubt)) return estimate;
        return trim(estimate, {x, y, z});
    }

private:
    using Exact = std::array<double, 3>;
    double enters(double first, size_t k) const { return (m_enter[k] - first) * m_inverse[k]; }
    double leaves(double first, size_t k) const { return (m_leave[k] - first) * m_inverse[k]; }
    Interval trim(Interval row, const Exact& first) const {
        while (row.low < row.high && !isInside(first, row.low)) ++row.low;
        while (row.low < row.high && !isInside(first, row.high - 1)) --row.high;
        return row;
    }
    bool isInside(const Exact& first, int i) const {
        bool inside = true;
        for (size_t k = 0; k < 3; ++k) {
            const double at = first[k] + i * m_step[k];
            inside &= at >= m_low[k] && at < m_high[k];
        }
        return inside;
    }
    Exact m_low, m_high, m_step, m_enter, m_leave, m_inverse;
    double m_end;
};

}  // namespace rubble
