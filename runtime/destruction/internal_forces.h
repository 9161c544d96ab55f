#pragma once
#include <array>

#include "runtime/destruction/stress_graph.h"

namespace rubble {

/// What acts on a node layer by layer, along each axis: it is in balance, so the sum of what acts above a plane is the
/// force through it, whatever holds the node up.
class InternalForces {
public:
    explicit InternalForces(const StressNode& node) : m_node(node) {}
    /// `load`: of the side above on the side below.
    void addBond(const StressBond& bond, const SectionForce& load, bool nodeIsBelow);
    void addWeight(const Brick& content, const StrengthTable& entries, glm::dvec3 gravity);
    void addForce(glm::ivec3 cell, glm::dvec3 force);
    /// Through the plane between two of the node's layers, about a point.
    SectionForce forceAt(int axis, int plane, glm::dvec3 about) const;

private:
    /// Force and moment about the node's centre.
    void add(int axis, int layer, glm::dvec3 force, glm::dvec3 moment) {
        SectionForce& sum = m_layers[size_t(axis)][size_t(layer)];
        sum.force += force, sum.moment += moment;
    }
    const StressNode& m_node;
    std::array<std::array<SectionForce, 8>, 3> m_layers;
};

}  // namespace rubble
