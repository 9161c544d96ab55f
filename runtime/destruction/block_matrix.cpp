#include "runtime/destruction/block_matrix.h"

#include <cmath>

namespace rubble {

Block6 rigidBlock(glm::dvec3 arm) {
    Block6 out;
    for (size_t i = 0; i < 6; ++i) out.at(i, i) = 1.0;
    // rotation x arm
    out.at(0, 4) = arm.z, out.at(0, 5) = -arm.y;
    out.at(1, 3) = -arm.z, out.at(1, 5) = arm.x;
    out.at(2, 3) = arm.y, out.at(2, 4) = -arm.x;
    return out;
}

Block6 transposed(const Block6& a) {
    Block6 out;
    for (size_t r = 0; r < 6; ++r)
        for (size_t c = 0; c < 6; ++c) out.at(c, r) = a.at(r, c);
    return out;
}

Block6 inverted(const Block6& a) {
    double l[6][6] = {};
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double sum = a.at(i, j);
            for (size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            if (i == j)
                l[i][i] = sum > 0.0 ? std::sqrt(sum) : 0.0;
            else
                l[i][j] = l[j][j] > 0.0 ? sum / l[j][j] : 0.0;
        }
    Block6 out;
    for (size_t column = 0; column < 6; ++column) {
        double y[6];
        for (size_t i = 0; i < 6; ++i) {
            double sum = i == column ? 1.0 : 0.0;
            for (size_t k = 0; k < i; ++k) sum -= l[i][k] * y[k];
            y[i] = l[i][i] > 0.0 ? sum / l[i][i] : 0.0;
        }
        for (size_t i = 6; i-- > 0;) {
            double sum = y[i];
            for (size_t k = i + 1; k < 6; ++k) sum -= l[k][i] * out.at(k, column);
            out.at(i, column) = l[i][i] > 0.0 ? sum / l[i][i] : 0.0;
        }
    }
    return out;
}

void addProduct(Block6& c, const Block6& a, const Block6& b) {
    for (size_t column = 0; column < 6; ++column)
        for (size_t k = 0; k < 6; ++k) {
            const double s = b.m[column * 6 + k];
            for (size_t r = 0; r < 6; ++r) c.m[column * 6 + r] += a.m[k * 6 + r] * s;
        }
}

void BlockMatrix::clear() {
    start.assign(1, 0);
    column.clear();
    block.clear();
}

Block6& BlockMatrix::findOrAppend(uint32_t wanted) {
    for (size_t i = start.back(); i < column.size(); ++i)
        if (column[i] == wanted) return block[i];
    column.push_back(wanted);
    return block.emplace_back();
}

const Block6& BlockMatrix::diagonal(size_t row) const {
    uint32_t i = start[row];
    while (column[i] != row) ++i;
    return block[i];
}

void multiply(const BlockMatrix& a, const std::vector<Vector6>& x, std::vector<Vector6>& y) {
    for (size_t row = 0; row < a.rows(); ++row) {
        Vector6 sum{};
        for (uint32_t i = a.start[row]; i < a.start[row + 1]; ++i) addProduct(sum, a.block[i], x[a.column[i]]);
        y[row] = sum;
    }
}

BlockMatrix transposed(const BlockMatrix& a, size_t columns) {
    BlockMatrix out;
    out.start.assign(columns + 1, 0);
    for (const uint32_t column : a.column) ++out.start[column + 1];
    for (size_t i = 0; i < columns; ++i) out.start[i + 1] += out.start[i];
    out.column.resize(a.column.size());
    out.block.resize(a.block.size());
    std::vector<uint32_t> next(out.start.begin(), out.start.end() - 1);
    for (size_t row = 0; row < a.rows(); ++row)
        for (uint32_t i = a.start[row]; i < a.start[row + 1]; ++i) {
            const uint32_t index = next[a.column[i]]++;
            out.column[index] = uint32_t(row);
            out.block[index] = transposed(a.block[i]);
        }
    return out;
}

size_t appendProductRow(BlockMatrix& c, const BlockMatrix& a, const BlockMatrix& b, size_t row) {
    size_t products = 0;
    for (uint32_t i = a.start[row]; i < a.start[row + 1]; ++i) {
        const uint32_t k = a.column[i];
        for (uint32_t j = b.start[k]; j < b.start[k + 1]; ++j)
            addProduct(c.findOrAppend(b.column[j]), a.block[i], b.block[j]);
        products += b.start[k + 1] - b.start[k];
    }
    c.endRow();
    return products;
}

double dot(const std::vector<Vector6>& a, const std::vector<Vector6>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t k = 0; k < 6; ++k) sum += a[i][k] * b[i][k];
    return sum;
}

}  // namespace rubble
