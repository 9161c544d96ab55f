#include "runtime/voxel/mass_properties.h"

#include <bit>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <optional>

#include "runtime/core/hash.h"
#include "runtime/voxel/brick_entries.h"

namespace rubble {
namespace {

/// Three sums over a row of voxels of weight one along x, packed into one word: their number in bits 0 to 15, the sum
/// of the doubled cell centres p = 2 x + 1 from bit 16, the sum of p^2 from bit 32. Words may be added, and multiplied
/// by p or p^2 of y: no sum of a layer needs more bits than it has.
using RowSums = uint64_t;
constexpr std::array<RowSums, 256> kRowSums = [] {
    std::array<RowSums, 256> out{};
    for (size_t row = 0; row < 256; ++row)
        for (uint64_t x = 0; x < 8; ++x)
            if (row >> x & 1) out[row] += 1 | (2 * x + 1) << 16 | (2 * x + 1) * (2 * x + 1) << 32;
    return out;
}();
/// Sums over one layer of voxels of weight one.
struct LayerSums {
    RowSums all = 0, byY = 0, byYY = 0;  ///< sums of rows; of rows times p of y; of rows times p^2 of y
};
LayerSums sumLayer(uint64_t layer) {
    LayerSums out;
    for (uint64_t p = 1; layer; p += 2, layer >>= 8) {
        const RowSums row = kRowSums[layer & 0xff];
        out.all += row, out.byY += row * p, out.byYY += row * (p * p);
    }
    return out;
}

/// The moments of voxels of one density, in the brick's own cells.
MassMoments solidMoments(const BrickBits& voxels, int64_t density) {
    LayerSums layer;  // kept from layer to layer: layers are often equal
    std::array<int64_t, 3> first{};
    std::array<int64_t, 6> second{};
    int64_t count = 0;
    for (size_t z = 0; z < 8; ++z) {
        if (voxels[z] != (z ? voxels[z - 1] : 0)) layer = sumLayer(voxels[z]);
        const auto [sums, byY, byYY] = layer;
        const auto number = [](RowSums of) { return int64_t(of & 0xffff); };
        const auto sumX = [](RowSums of) { return int64_t(of >> 16 & 0xffff); };
        const int64_t p = 2 * int64_t(z) + 1, n = number(sums);
        count += n;
        first[0] += sumX(sums), first[1] += number(byY), first[2] += n * p;
        second[0] += int64_t(sums >> 32), second[1] += number(byYY), second[2] += n * p * p;
        second[3] += sumX(byY), second[4] += number(byY) * p, second[5] += sumX(sums) * p;
    }
    MassMoments out{count, count * density, {}, {}};
    for (size_t i = 0; i < 3; ++i) out.first[i] = first[i] * density;
    for (size_t i = 0; i < 6; ++i) out.second[i] = second[i] * density;
    return out;
}

}  // namespace

void MassMoments::add(glm::ivec3 cell, uint32_t density) {
    const int64_t w = density;
    const int64_t p[3] = {2 * int64_t(cell.x) + 1, 2 * int64_t(cell.y) + 1, 2 * int64_t(cell.z) + 1};
    ++voxels;
    weight += w;
    for (int i = 0; i < 3; ++i) {
        first[size_t(i)] += w * p[i];
        second[size_t(i)] += w * p[i] * p[i];
        second[size_t(i + 3)] += w * p[i] * p[(i + 1) % 3];
    }
}

MassMoments& MassMoments::operator+=(const MassMoments& other) {
    voxels += other.voxels;
    weight += other.weight;
    for (size_t i = 0; i < 3; ++i) first[i] += other.first[i];
    for (size_t i = 0; i < 6; ++i) second[i] += other.second[i];
    return *this;
}

MassMoments& MassMoments::operator-=(const MassMoments& other) {
    voxels -= other.voxels;
    weight -= other.weight;
    for (size_t i = 0; i < 3; ++i) first[i] -= other.first[i];
    for (size_t i = 0; i < 6; ++i) second[i] -= other.second[i];
    return *this;
}

MassMoments MassMoments::shifted(glm::ivec3 offset) const {
    // With p' = p + d: sum w p' = F + W d; sum w p'_i p'_j = S_ij + d_j F_i + d_i F_j + W d_i d_j.
    const int64_t d[3] = {2 * int64_t(offset.x), 2 * int64_t(offset.y), 2 * int64_t(offset.z)};
    MassMoments out = *this;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        out.first[i] += weight * d[i];
        out.second[i] += 2 * Int128(d[i]) * first[i] + Int128(weight) * d[i] * d[i];
        out.second[i + 3] += Int128(d[j]) * first[i] + Int128(d[i]) * first[j] + Int128(weight) * d[i] * d[j];
    }
    return out;
}

Densities::Densities(const Palette& palette, const MaterialTable& materials) {
    for (size_t i = 0; i < 256; ++i) byEntry[i] = materials[palette[i].material].density;
}

uint64_t Densities::hashOf(const UsedEntries& entries) const {
    uint64_t hash = 0;
    entries.forEach([&](size_t entry) { hash = hashValue(byEntry[entry], hash); });
    return hash;
}

MassMoments brickMoments(const Brick& brick, const BrickBits& voxels, glm::ivec3 brickPosition,
                         const Densities& densities) {
    MassMoments sums;
    BrickBits pending{};  // those of `density` that are not in the sums yet
    std::optional<uint32_t> density;
    forEachEntry(brick, voxels, [&](uint8_t entry, size_t z, uint64_t bits) {
        if (density && *density != densities.byEntry[entry]) {
            sums += solidMoments(pending, *density);
            pending = {};
        }
        density = densities.byEntry[entry];
        pending[z] |= bits;
    });
    if (density) sums += solidMoments(pending, *density);
    return sums.shifted(brickPosition * kBrickSize);
}

MassMoments nodeMoments(const BrickNode& node, glm::ivec3 nodePosition, const Densities& densities) {
    const glm::ivec3 offset = nodePosition * kNodeSize;
    if (const NodeMoments* known = node.cachedMoments.find(); known && known->areFor(densities))
        return known->sums.shifted(offset);
    const UsedEntries& entries = usedEntries(node);
    auto found = std::make_unique<NodeMoments>(NodeMoments{entries, densities.hashOf(entries), {}});
    forEachChild(node.mask, [&](int child) {
        const Brick& brick = *node.bricks[size_t(child)];
        found->sums += brickMoments(brick, brick.occupancy, childPosition(child), densities);
    });
    const MassMoments sums = found->sums;
    node.cachedMoments.keep(std::move(found));
    return sums.shifted(offset);
}

MassMoments gridMoments(const VoxelGrid& grid, const Palette& palette, const MaterialTable& materials) {
    MassMoments sum;
    const Densities densities(palette, materials);
    grid.forEachNode(
        [&](glm::ivec3 position, const BrickNode& node) { sum += nodeMoments(node, position, densities); });
    return sum;
}

/// The cyclic Jacobi method. A rotation by the angle phi in the plane of the axes p and q, with t = tan(phi), changes
/// the entry a_pq of the matrix to 0 if t^2 + 2 theta t - 1 = 0, where theta = (a_qq - a_pp) / (2 a_pq). The smaller
/// root is t = sign(theta) / (|theta| + sqrt(theta^2 + 1)); with c = cos(phi) = 1 / sqrt(1 + t^2) and s = t c it is
/// applied to the columns and rows of the matrix, and to the columns of v, which become the eigenvectors. Each sweep
/// over the three planes lowers the sum of squares off the diagonal, in the end quadratically.
void principalAxes(const std::array<double, 6>& tensor, glm::dvec3& values, glm::dquat& axes) {
    double a[3][3] = {
        {tensor[0], tensor[3], tensor[5]}, {tensor[3], tensor[1], tensor[4]}, {tensor[5], tensor[4], tensor[2]}};
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < 32; ++sweep) {
        const double off = a[0][1] * a[0][1] + a[1][2] * a[1][2] + a[0][2] * a[0][2];
        const double diagonal = a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2];
        if (off <= 1e-30 * diagonal) break;
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0.0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                for (int k = 0; k < 3; ++k) {
                    const double akp = a[k][p], akq = a[k][q];
                    a[k][p] = c * akp - s * akq;
                    a[k][q] = s * akp + c * akq;
                }
                for (int k = 0; k < 3; ++k) {
                    const double apk = a[p][k], aqk = a[q][k], vkp = v[k][p], vkq = v[k][q];
                    a[p][k] = c * apk - s * aqk;
                    a[q][k] = s * apk + c * aqk;
                    v[k][p] = c * vkp - s * vkq;
                    v[k][q] = s * vkp + c * vkq;
                }
            }
    }
    values = {a[0][0], a[1][1], a[2][2]};
    glm::dmat3 m(v[0][0], v[1][0], v[2][0], v[0][1], v[1][1], v[2][1], v[0][2], v[1][2], v[2][2]);
    if (glm::dot(glm::cross(m[0], m[1]), m[2]) < 0.0) m[2] = -m[2];
    axes = glm::normalize(glm::quat_cast(m));
}

MassProperties massProperties(const MassMoments& moments, double voxelSize) {
    MassProperties out;
    if (moments.weight <= 0) return out;
    const double weight = double(moments.weight), half = voxelSize * 0.5;
    const double massPerWeight = voxelSize * voxelSize * voxelSize;
    out.mass = weight * massPerWeight;
    double central[6];
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        out.center[int(i)] = double(moments.first[i]) / weight * half;
        // S - F F / W about the centre: W S - F F is exact in integers, so only the division rounds.
        const Int128 squares = Int128(moments.weight) * moments.second[i] - Int128(moments.first[i]) * moments.first[i];
        const Int128 products =
            Int128(moments.weight) * moments.second[i + 3] - Int128(moments.first[i]) * moments.first[j];
        central[i] = double(squares) / weight * half * half * massPerWeight + out.mass * voxelSize * voxelSize / 12.0;
        central[i + 3] = double(products) / weight * half * half * massPerWeight;
    }
    out.inertia = {central[1] + central[2],
                   central[2] + central[0],
                   central[0] + central[1],
                   -central[3],
                   -central[4],
                   -central[5]};
    principalAxes(out.inertia, out.principalInertia, out.principalAxes);
    return out;
}

}  // namespace rubble
