#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// A force and a moment, or a translation and a rotation.
using Vector6 = std::array<double, 6>;

/// A 6x6 matrix, column by column.
struct Block6 {
    std::array<double, 36> m{};
    /// The element in a row and a column.
    double& at(size_t row, size_t column) { return m[column * 6 + row]; }
    /// The element in a row and a column.
    double at(size_t row, size_t column) const { return m[column * 6 + row]; }
};

/// Maps the translation and rotation (u, r) of a rigid body at a point to those at the point `arm` away: (u + r x arm,
/// r).
Block6 rigidBlock(glm::dvec3 arm);
/// The transpose of a.
Block6 transposed(const Block6& a);
/// The inverse of a symmetric positive definite block, by Cholesky factorisation. Zero pivots give zero rows.
Block6 inverted(const Block6& a);

/// y += a x
inline void addProduct(Vector6& y, const Block6& a, const Vector6& x) {
    for (size_t c = 0; c < 6; ++c)
        for (size_t r = 0; r < 6; ++r) y[r] += a.m[c * 6 + r] * x[c];
}
/// y -= a x
inline void subtractProduct(Vector6& y, const Block6& a, const Vector6& x) {
    for (size_t c = 0; c < 6; ++c)
        for (size_t r = 0; r < 6; ++r) y[r] -= a.m[c * 6 + r] * x[c];
}
/// a x
inline Vector6 product(const Block6& a, const Vector6& x) {
    Vector6 y{};
    addProduct(y, a, x);
    return y;
}
/// c += a b
void addProduct(Block6& c, const Block6& a, const Block6& b);

/// A sparse matrix of 6x6 blocks in block compressed row storage. Rows are appended in order.
struct BlockMatrix {
    std::vector<uint32_t> start{0};  ///< by row: where its blocks begin; one more entry at the end
    std::vector<uint32_t> column;    ///< by block
    std::vector<Block6> block;

    /// The number of complete rows.
    size_t rows() const { return start.size() - 1; }
    /// Removes all rows.
    void clear();
    /// Completes the row that is being appended.
    void endRow() { start.push_back(uint32_t(column.size())); }
    /// The block in a column of the row that is being appended; a new one, of zeros, if there is none.
    Block6& findOrAppend(uint32_t column);
    /// The block on the diagonal, which must exist.
    const Block6& diagonal(size_t row) const;
};

/// y = a x
void multiply(const BlockMatrix& a, const std::vector<Vector6>& x, std::vector<Vector6>& y);
/// The transpose of a matrix with this many columns.
BlockMatrix transposed(const BlockMatrix& a, size_t columns);
/// Appends row `row` of the product a b to c. Returns the number of block products.
size_t appendProductRow(BlockMatrix& c, const BlockMatrix& a, const BlockMatrix& b, size_t row);
/// The scalar product.
double dot(const std::vector<Vector6>& a, const std::vector<Vector6>& b);

}  // namespace rubble
