#include "runtime/destruction/cross_section.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/byte_bits.h"

namespace rubble {
namespace {

/// Normal stress at (du, dv) from the centroid: mean + u du + v dv.
struct LinearStress {
    double mean, u, v;
};

LinearStress normalStress(const Section& section, const SectionShape& shape, const SectionForce& load) {
    // A stress s along the normal n at du u + dv v has the moment s (du u x n + dv v x n). The moments of mean + a du +
    // b dv over the section are mu = a uu + b uv and mv = a uv + b vv: solved for a and b.
    const glm::dvec3& m = load.moment;
    const double mu = section.axis == 0 ? -m.z : section.axis == 1 ? m.z : -m.y;
    const double mv = section.axis == 0 ? m.y : section.axis == 1 ? -m.x : m.x;
    const double det = shape.uu * shape.vv - shape.uv * shape.uv;
    return {load.force[section.axis] / shape.area, (mu * shape.vv - mv * shape.uv) / det,
            (mv * shape.uu - mu * shape.uv) / det};
}

}  // namespace

glm::ivec3 Section::cellBelow(int bit) const {
    glm::ivec3 cell = brick * kBrickSize;
    cell[axis] += plane - 1;
    cell[kSectionU[size_t(axis)]] += bit % kBrickSize;
    cell[kSectionV[size_t(axis)]] += bit / kBrickSize;
    return cell;
}

uint64_t brickLayer(const BrickBits& bits, int axis, int layer) {
    if (axis == 2) return bits[size_t(layer)];
    uint64_t out = 0;
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t row = axis == 1 ? bits[z] >> 8 * layer & 0xff : gatherBits(bits[z] >> layer & kFirstColumn);
        out |= row << 8 * z;
    }
    return out;
}

BrickBits bitsFrom(const BrickBits& bits, int axis, int layer) {
    BrickBits out{};
    const uint64_t row = 0xffull << layer & 0xff;
    const uint64_t keep = axis == 0 ? row * kFirstColumn : ~uint64_t(0) << 8 * layer;
    for (size_t z = 0; z < 8; ++z) out[z] = axis == 2 ? (int(z) >= layer ? bits[z] : 0) : bits[z] & keep;
    return out;
}

SectionShape sectionShape(const Section& section) {
    const SectionTile tile{section.cells};
    return sectionShape(section, {&tile, 1});
}

SectionShape sectionShape(const Section& section, std::span<const SectionTile> tiles) {
    int64_t n = 0, u = 0, v = 0, uu = 0, vv = 0, uv = 0;
    for (const SectionTile& tile : tiles)
        for (uint64_t left = tile.cells; left; left &= left - 1) {
            const int bit = std::countr_zero(left);
            const int cu = bit % kBrickSize + kBrickSize * tile.u, cv = bit / kBrickSize + kBrickSize * tile.v;
            ++n, u += cu, v += cv, uu += cu * cu, vv += cv * cv, uv += cu * cv;
        }
    SectionShape shape;
    const double area = double(n);
    shape.area = area;
    shape.centroid = glm::dvec3(section.brick * kBrickSize);
    shape.centroid[section.axis] += section.plane;
    shape.centroid[kSectionU[size_t(section.axis)]] += double(u) / area + 0.5;
    shape.centroid[kSectionV[size_t(section.axis)]] += double(v) / area + 0.5;
    // n S - F F is exact in integers; the second moment of one cell about its own centre is 1/12.
    shape.uu = double(n * uu - u * u) / area + area / 12.0;
    shape.vv = double(n * vv - v * v) / area + area / 12.0;
    shape.uv = double(n * uv - u * v) / area;
    return shape;
}

SectionUtilization sectionUtilization(const Section& section, const SectionShape& shape, const SectionForce& load,
                                      const SectionStrength& strength) {
    const LinearStress stress = normalStress(section, shape, load);
    const glm::dvec3 corner = glm::dvec3(section.brick * kBrickSize) - shape.centroid;
    const double u0 = corner[kSectionU[size_t(section.axis)]], v0 = corner[kSectionV[size_t(section.axis)]];
    double high = -1e300, low = 1e300, maxRadius2 = 0.0;
    for (int row = 0; row < 8; ++row) {
        const unsigned bits = unsigned(section.cells >> 8 * row) & 0xff;
        if (!bits) continue;
        for (const double du : {u0 + std::countr_zero(bits), u0 + std::bit_width(bits)})
            for (const double dv : {v0 + row, v0 + row + 1}) {
                const double s = stress.mean + stress.u * du + stress.v * dv;
                high = std::max(high, s), low = std::min(low, s), maxRadius2 = std::max(maxRadius2, du * du + dv * dv);
            }
    }
    glm::dvec3 across = load.force;
    across[section.axis] = 0.0;
    const double torsion = std::fabs(load.moment[section.axis]) * std::sqrt(maxRadius2) / (shape.uu + shape.vv);
    const double shear = std::sqrt(glm::dot(across, across)) / shape.area + torsion;
    SectionUtilization result{high / strength.tensile, FailureMode::Tension};
    if (-low / strength.compressive > result.utilization)
        result = {-low / strength.compressive, FailureMode::Compression};
    if (shear / strength.shear > result.utilization) result = {shear / strength.shear, FailureMode::Shear};
    return result;
}

glm::dvec3 faceForce(const Section& section, const SectionShape& shape, const SectionForce& load,
                     glm::dvec3 faceCenter) {
    const glm::dvec3 r = faceCenter - shape.centroid;
    glm::dvec3 out = load.force / shape.area;
    glm::dvec3 twist(0.0);
    twist[section.axis] = load.moment[section.axis] / (shape.uu + shape.vv);
    out += glm::cross(twist, r);
    const LinearStress stress = normalStress(section, shape, load);
    out[section.axis] =
        stress.mean + stress.u * r[kSectionU[size_t(section.axis)]] + stress.v * r[kSectionV[size_t(section.axis)]];
    return out;
}

}  // namespace rubble
