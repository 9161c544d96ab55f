#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// A force and a moment, or a shift and a turn.
using Vector6 = std::array<double, 6>;

/// 6x6, column after column.
struct Block6 {
    std::array<double, 36> m{};
    double& at(size_t row, size_t column) { return m[column * 6 + row]; }
    double at(size_t row, size_t column) const { return m[column * 6 + row]; }
};

/// The shift and turn at a point, of a rigid body with a shift and a turn at `arm` before it: u - arm x turn.
Block6 rigidBlock(glm::dvec3 arm);
Block6 transposed(const Block6& a);
/// The inverse of a symmetric positive definite block, by Cholesky; zero pivots are taken as fixed.
Block6 inverted(const Block6& a);

inline void addProduct(Vector6& y, const Block6& a, const Vector6& x) {
    for (size_t c = 0; c < 6; ++c)
        for (size_t r = 0; r < 6; ++r) y[r] += a.m[c * 6 + r] * x[c];
}
inline void subtractProduct(Vector6& y, const Block6& a, const Vector6& x) {
    for (size_t c = 0; c < 6; ++c)
        for (size_t r = 0; r < 6; ++r) y[r] -= a.m[c * 6 + r] * x[c];
}
inline Vector6 product(const Block6& a, const Vector6& x) {
    Vector6 y{};
    addProduct(y, a, x);
    return y;
}
/// c += a b
void addProduct(Block6& c, const Block6& a, const Block6& b);

/// Rows of 6x6 blocks, only those that are not zero; rows are appended in order.
struct BlockMatrix {
    std::vector<uint32_t> start{0};
    std::vector<uint32_t> column;
    std::vector<Block6> block;

    size_t rows() const { return start.size() - 1; }
    void clear();
    void endRow() { start.push_back(uint32_t(column.size())); }
    /// The block of the row being appended, zero if it is new.
    Block6& open(uint32_t column);
    /// The block on the diagonal.
    const Block6& diagonal(size_t row) const;
};

/// y = a x
void multiply(const BlockMatrix& a, const std::vector<Vector6>& x, std::vector<Vector6>& y);
BlockMatrix transposed(const BlockMatrix& a, size_t columns);
/// Appends row `row` of a b to c. Returns the blocks multiplied.
size_t appendProductRow(BlockMatrix& c, const BlockMatrix& a, const BlockMatrix& b, size_t row);
double dot(const std::vector<Vector6>& a, const std::vector<Vector6>& b);

}  // namespace rubble
