#include "runtime/destruction/internal_forces.h"

#include <bit>
#include <glm/geometric.hpp>

namespace rubble {

void InternalForces::addBond(const StressBond& bond, const SectionForce& load, bool nodeIsBelow) {
    const Section& section = bond.section;
    const double sign = nodeIsBelow ? 1.0 : -1.0;
    const glm::dvec3 arm = bond.shape.centroid - m_node.center;
    add(section.axis, nodeIsBelow ? section.plane - 1 : cellInBrick(section.plane), sign * load.force,
        sign * (load.moment + glm::cross(arm, load.force)));
    // Along the other two axes, each face loads its own layer. The part of the moment that the faces' forces do not
    // produce is spread over the faces.
    glm::dvec3 rest = load.moment;
    std::array<glm::dvec3, 64> forces;
    const auto faceCenter = [&](int bit) {
        glm::dvec3 center = glm::dvec3(section.cellBelow(bit)) + 0.5;
        center[section.axis] += 0.5;
        return center;
    };
    for (uint64_t left = section.cells; left; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const glm::dvec3 center = faceCenter(bit);
        forces[size_t(bit)] = faceForce(section, bond.shape, load, center);
        rest -= glm::cross(center - bond.shape.centroid, forces[size_t(bit)]);
    }
    rest /= bond.shape.area;
    for (uint64_t left = section.cells; left; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const glm::dvec3 force = sign * forces[size_t(bit)];
        const glm::dvec3 moment = sign * rest + glm::cross(faceCenter(bit) - m_node.center, force);
        const glm::ivec3 cell = cellInBrick(section.cellBelow(bit));
        for (int axis = 0; axis < 3; ++axis)
            if (axis != section.axis) add(axis, cell[axis], force, moment);
    }
}

void InternalForces::addWeight(const Brick& content, const StrengthTable& entries, glm::dvec3 gravity) {
    struct Sum {
        int64_t weight = 0;
        glm::i64vec3 first{0};  ///< sum of density times twice the cell centre
    };
    std::array<std::array<Sum, 8>, 3> sums{};
    forEachVoxel(m_node.cells, [&](int i) {
        const glm::ivec3 cell = voxelInBrick(i);
        const int64_t density = int64_t(entries[content.at(i)].density);
        for (int axis = 0; axis < 3; ++axis) {
            Sum& sum = sums[size_t(axis)][size_t(cell[axis])];
            sum.weight += density, sum.first += density * glm::i64vec3(2 * cell + 1);
        }
    });
    const glm::dvec3 base = glm::dvec3(m_node.brick * kBrickSize) - m_node.center;
    for (int axis = 0; axis < 3; ++axis)
        for (int layer = 0; layer < 8; ++layer) {
            const Sum& sum = sums[size_t(axis)][size_t(layer)];
            if (!sum.weight) continue;
            const glm::dvec3 arm = base + glm::dvec3(sum.first) / double(2 * sum.weight);
            add(axis, layer, double(sum.weight) * gravity, glm::cross(arm, double(sum.weight) * gravity));
        }
}

void InternalForces::addForce(glm::ivec3 cell, glm::dvec3 force) {
    const glm::dvec3 moment = glm::cross(glm::dvec3(cell) + 0.5 - m_node.center, force);
    for (int axis = 0; axis < 3; ++axis) add(axis, cellInBrick(cell[axis]), force, moment);
}

SectionForce InternalForces::forceAt(int axis, int plane, glm::dvec3 about) const {
    SectionForce sum;
    for (int layer = plane; layer < 8; ++layer) {
        sum.force += m_layers[size_t(axis)][size_t(layer)].force;
        sum.moment += m_layers[size_t(axis)][size_t(layer)].moment;
    }
    sum.moment += glm::cross(m_node.center - about, sum.force);
    return sum;
}

}  // namespace rubble
