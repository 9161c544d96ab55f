#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/shadow/shadow_cell_transform.h"

namespace rubble {

/// Clips rows of samples along the world's x axis to a box of a shape's cells: the slab test (Kay and Kajiya 1986). It
/// computes in doubles, which hold the fixed-point coordinates exactly. An estimated end of an interval may be off by a
/// rounding error; where it is that close to a sample, the sample's exact position decides.
class RowClip {
public:
    using Exact = std::array<double, 3>;
    static constexpr int kBatch = 32;  ///< rows at a time
    /// For rows of `count` samples and a box of voxels, high end excluded.
    RowClip(const CellBox& box, const ShadowCellTransform& cellTransform, int count) : m_end(count - 0.5) {
        const FixedPoint& step = cellTransform.step[0];
        for (size_t k = 0; k < 3; ++k) {
            m_low[k] = double(int64_t(box.low[int(k)]) << 32);
            m_high[k] = double(int64_t(box.high[int(k)]) << 32);
            m_step[k] = double(step[k]);
            m_rowStep[k] = double(cellTransform.step[1][k]);
            m_enter[k] = step[k] < 0 ? m_high[k] : m_low[k];
            m_leave[k] = step[k] < 0 ? m_low[k] : m_high[k];
            m_inverse[k] = step[k] ? 1.0 / m_step[k] : 1e100;  // a row outside the slab never enters
        }
        findSlopes(cellTransform.step[1]);
    }
    struct Interval {
        int low, high;  ///< high excluded
    };
    /// The samples that lie in the box, for `rows` rows (at most kBatch) from row `row` on. plane: the first sample of
    /// row 0.
    void intervals(const Exact& plane, int row, int rows, Interval* out) const {
        constexpr double kTolerance = 1e-6;  // samples: more than the rounding errors of from and to
        std::array<double, kBatch> from, to;
        for (int i = 0; i < rows; ++i) {  // without a branch, so that the compiler vectorizes it
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
    /// Calls f(row, interval) for all rows of [0, count) that have samples in the box.
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
    /// The rows of [0, count) that can have samples in the box. In such a row the entry into each slab lies before the
    /// exit from every other one; both are linear in the row, so each pair bounds the rows on one side.
    Interval rows(const Exact& plane, int count) const {
        constexpr double kMargin = 0.01;  // rows: more than the rounding errors of low and high
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
    /// A pair of slabs, and the inverse of the change of (entry into one - exit from the other) from row to row. Slab 3
    /// is the row itself.
    struct Slope {
        uint8_t enter, leave;
        double inverse;
    };
    void findSlopes(const FixedPoint& rowStep) {
        // Slabs nearly parallel to the rows, and pairs that hardly change from row to row, give no useful bound.
        constexpr double kMinStep = 0x1p20, kMinSlope = 1e-4;
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
