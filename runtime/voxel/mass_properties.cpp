#include "runtime/voxel/mass_properties.h"

#include <bit>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "runtime/core/hash.h"

namespace rubble {
namespace {

/// Sums over one row of a brick along x, in doubled cell centres.
struct RowSums {
    int64_t weight = 0, first = 0, second = 0;
};

/// The sums of every possible row of voxels of weight one.
constexpr std::array<RowSums, 256> kRowSums = [] {
    std::array<RowSums, 256> out{};
    for (size_t row = 0; row < 256; ++row)
        for (int64_t x = 0; x < 8; ++x)
            if (row >> x & 1) out[row].weight += 1, out[row].first += 2 * x + 1, out[row].second += (2 * x + 1) * (2 * x + 1);
    return out;
}();

/// Moments inside one brick, where 64 bits hold everything.
struct LocalMoments {
    int64_t voxels = 0, weight = 0;
    std::array<int64_t, 3> first{};
    std::array<int64_t, 6> second{};

    void add(const RowSums& row, int64_t count, int64_t y, int64_t z) {
        const int64_t py = 2 * y + 1, pz = 2 * z + 1;
        voxels += count;
        weight += row.weight;
        first[0] += row.first, first[1] += row.weight * py, first[2] += row.weight * pz;
        second[0] += row.second, second[1] += row.weight * py * py, second[2] += row.weight * pz * pz;
        second[3] += row.first * py, second[4] += row.weight * py * pz, second[5] += row.first * pz;
    }
    /// From voxels of weight one to voxels of this density.
    void weigh(int64_t density) {
        weight *= density;
        for (int64_t& sum : first) sum *= density;
        for (int64_t& sum : second) sum *= density;
    }
    MassMoments moments() const {
        MassMoments out{voxels, weight, first, {}};
        for (size_t i = 0; i < 6; ++i) out.second[i] = second[i];
        return out;
    }
};

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
    for (size_t i = 0; i < 256; ++i) of[i] = materials[palette[i].material].density;
    hash = hashBytes(of.data(), sizeof of);
}

MassMoments brickMoments(const Brick& brick, const BrickBits& of, glm::ivec3 brickPosition, const Densities& densities) {
    LocalMoments local;
    for (size_t z = 0; z < 8; ++z) {
        uint64_t rows = of[z] & brick.occupancy[z];
        for (size_t y = 0; y < 8; ++y, rows >>= 8) {
            const uint8_t row = uint8_t(rows);
            if (!brick.indices) {
                local.add(kRowSums[row], kRowSums[row].weight, int64_t(y), int64_t(z));
                continue;
            }
            RowSums sums;
            for (unsigned left = row; left; left &= left - 1) {
                const int x = std::countr_zero(left);
                const int64_t density = densities.of[(*brick.indices)[size_t(x) + 8 * y + 64 * z]], p = 2 * x + 1;
                sums.weight += density, sums.first += density * p, sums.second += density * p * p;
            }
            local.add(sums, kRowSums[row].weight, int64_t(y), int64_t(z));
        }
    }
    if (!brick.indices) local.weigh(densities.of[brick.uniform]);
    return local.moments().shifted(brickPosition * kBrickSize);
}

MassMoments nodeMoments(const BrickNode& node, glm::ivec3 nodePosition, const Densities& densities) {
    const glm::ivec3 offset = nodePosition * kNodeSize;
    if (const NodeMoments* known = node.knownMoments.find(); known && known->densities == densities.hash) return known->sums.shifted(offset);
    auto found = std::make_unique<NodeMoments>(NodeMoments{densities.hash, {}});
    forEachChild(node.mask, [&](int child) {
        const Brick& brick = *node.bricks[size_t(child)];
        found->sums += brickMoments(brick, brick.occupancy, childPosition(child), densities);
    });
    const MassMoments sums = found->sums;
    node.knownMoments.keep(std::move(found));
    return sums.shifted(offset);
}

MassMoments gridMoments(const VoxelGrid& grid, const Palette& palette, const MaterialTable& materials) {
    MassMoments sum;
    const Densities densities(palette, materials);
    grid.forEachNode([&](glm::ivec3 position, const BrickNode& node) { sum += nodeMoments(node, position, densities); });
    return sum;
}

void principalAxes(const std::array<double, 6>& tensor, glm::dvec3& values, glm::dquat& axes) {
    double a[3][3] = {{tensor[0], tensor[3], tensor[5]}, {tensor[3], tensor[1], tensor[4]}, {tensor[5], tensor[4], tensor[2]}};
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
        // S - F F / W in integers where it matters: W S - F F is exact, then one division.
        const Int128 squares = Int128(moments.weight) * moments.second[i] - Int128(moments.first[i]) * moments.first[i];
        const Int128 products = Int128(moments.weight) * moments.second[i + 3] - Int128(moments.first[i]) * moments.first[j];
        central[i] = double(squares) / weight * half * half * massPerWeight + out.mass * voxelSize * voxelSize / 12.0;
        central[i + 3] = double(products) / weight * half * half * massPerWeight;
    }
    out.inertia = {central[1] + central[2], central[2] + central[0], central[0] + central[1], -central[3], -central[4], -central[5]};
    principalAxes(out.inertia, out.principalInertia, out.principalAxes);
    return out;
}

}  // namespace rubble
