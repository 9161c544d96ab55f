#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/shadow/shadow_cell_transform.h"

namespace rubble {

/// Cuts rows of samples along the world's x axis to a box of a shape's voxels, which leaves one interval of each.
/// In doubles, which hold the fixed-point numbers of the cell transform exactly.
class RowClip {
public:
    using Exact = std::array<double, 3>;
    static constexpr int kBatch = 32;  ///< rows at a time
    /// Rows of `count` samples, cut to `box` (voxels, high end excluded).
    RowClip(const CellBox& box, const ShadowCellTransform& cellTransform, int count) : m_end(count - 0.5) {
        const FixedPoint& step = cellTransform.step[0];
        for (size_t k = 0; k < 3; ++k) {
            m_low[k] = double(int64_t(box.low[int(k)]) << 32);
            m_high[k] = double(int64_t(box.high[int(k)]) << 32);
            m_step[k] = double(step[k]);
            m_rowStep[k] = double(cellTransform.step[1][k]);
            m_enter[k] = step[k] < 0 ? m_high[k] : m_low[k];
            m_leave[k] = step[k] < 0 ? m_low[k] : m_high[k];
            m_inverse[k] = step[k] ? 1.0 / m_step[k] : 1e100;  // from outside it never enters
        }
        findSlopes(cellTransform.step[1]);
    }
    struct Interval {
        int low, high;
    };
    /// The samples of [0, count) that lie inside, of `rows` rows (kBatch at most) from row `row` on of the plane whose
    /// first sample is given.
    void intervals(const Exact& plane, int row, int rows, Interval* out) const {
        constexpr double kTolerance = 1e-6;  // more than the estimate errs; where that matters the exact place decides
        std::array<double, kBatch> from, to;
        for (int i = 0; i < rows; ++i) {  // without a branch: for several rows at once
            const Exact first = rowAt(plane, row + i);
            from[size_t(i)] = std::max(std::max(enters(first, 0), 0.0), std::max(enters(first, 1), enters(first, 2)));
            to[size_t(i)] = std::min(std::min(leaves(first, 0), m_end), std::min(leaves(first, 1), leaves(first, 2)));
        }
        for (int i = 0; i < rows; ++i) {
            const double low = from[size_t(i)], high = to[size_t(i)];
            out[i] = {0, 0};
            if (!(low <= high + kTolerance)) continue;
            out[i] = {int(low + (1.0 - kTolerance)), int(high + (1.0 + kTolerance))};
            if (out[i].low < low + kTolerance || out[i].high > high + (1.0 - kTolerance))
                out[i] = trim(out[i], rowAt(plane, row + i));
        }
    }
    /// f(row, interval) for all rows of [0, count) that have samples inside.
    template <class F>
    void forEachRow(const Exact& plane, int count, F&& f) const {
        const auto [low, high] = rows(plane, count);
        std::array<Interval, kBatch> batch;
        for (int row = low; row < high; row += kBatch) {
            const int some = std::min(kBatch, high - row);
            intervals(plane, row, some, batch.data());
            for (int i = 0; i < some; ++i)
                if (batch[size_t(i)].low < batch[size_t(i)].high) f(row + i, batch[size_t(i)]);
        }
    }
    /// All rows of [0, count) that have samples inside, and perhaps a few more, of the plane whose first sample is
    /// given: a row enters by each face before it leaves by any other, and both move steadily from row to row.
    Interval rows(const Exact& plane, int count) const {
        constexpr double kMargin = 0.01;  // more than the estimate errs
        const std::array<double, 4> enter = {enters(plane, 0), enters(plane, 1), enters(plane, 2), 0.0};
        const std::array<double, 4> leave = {leaves(plane, 0), leaves(plane, 1), leaves(plane, 2), m_end};
        double low = 0.0, high = count - 1.0;
        for (size_t n = 0; n < m_slopes; ++n) {
            const Slope& slope = m_slope[n];
            const double row = (leave[slope.leave] - enter[slope.enter]) * slope.inverse;
            if (slope.inverse > 0.0)
                high = std::min(high, row);
            else
                low = std::max(low, row);
        }
        return low <= high + 2.0 * kMargin ? Interval{int(low + (1.0 - kMargin)), int(high + (1.0 + kMargin))}
                                           : Interval{0, 0};
    }

private:
    /// By how much a row enters later than it leaves grows from row to row; 3 is the row's own ends.
    struct Slope {
        uint8_t enter, leave;
        double inverse;
    };
    void findSlopes(const FixedPoint& rowStep) {
        constexpr double kMinStep = 0x1p20,
                         kMinSlope = 1e-4;  // what hardly changes along a row, or from row to row, says little
        std::array<double, 4> change{};
        for (size_t k = 0; k < 3; ++k) change[k] = -double(rowStep[k]) * m_inverse[k];
        const auto counts = [&](size_t k) { return k == 3 || std::abs(m_step[k]) >= kMinStep; };
        for (size_t i = 0; i < 4; ++i)
            for (size_t j = 0; j < 4; ++j) {
                const double slope = change[i] - change[j];
                if (i == j || !counts(i) || !counts(j) || std::abs(slope) < kMinSlope) continue;
                m_slope[m_slopes++] = {uint8_t(i), uint8_t(j), 1.0 / slope};
            }
    }
    Exact rowAt(const Exact& plane, int row) const {
        return {plane[0] + row * m_rowStep[0], plane[1] + row * m_rowStep[1], plane[2] + row * m_rowStep[2]};
    }
    double enters(const Exact& first, size_t k) const { return (m_enter[k] - first[k]) * m_inverse[k]; }
    double leaves(const Exact& first, size_t k) const { return (m_leave[k] - first[k]) * m_inverse[k]; }
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
    Exact m_low, m_high, m_step, m_rowStep, m_enter, m_leave, m_inverse;
    double m_end;
    std::array<Slope, 12> m_slope;
    size_t m_slopes = 0;
};

}  // namespace rubble
