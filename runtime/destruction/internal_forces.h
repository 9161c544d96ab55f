#pragma once
#include <array>

#include "runtime/destruction/stress_graph.h"

namespace rubble {

/// The internal forces of a node of the stress graph, by the method of sections: a node is in equilibrium, so the sum
/// of all loads on the layers above a plane is the force through the plane. Collects the loads layer by layer along
/// each axis.
class InternalForces {
public:
    /// `node` must outlive this.
    explicit InternalForces(const StressNode& node) : m_node(node) {}
    /// The load of a bond: that of the side above on the side below. nodeIsBelow: on which side this node is.
    void addBond(const StressBond& bond, const SectionForce& load, bool nodeIsBelow);
    /// The weight of the node's cells. gravity: m/s2, in the shape's frame.
    void addWeight(const Brick& content, const StrengthTable& entries, glm::dvec3 gravity);
    /// A force on one of the node's cells.
    void addForce(glm::ivec3 cell, glm::dvec3 force);
    /// The force of the layers from `plane` (1 to 7) up on the layers below, with its moment about the point `about`.
    SectionForce forceAt(int axis, int plane, glm::dvec3 about) const;

private:
    /// Adds a force, with its moment about the node's centre, to a layer.
    void add(int axis, int layer, glm::dvec3 force, glm::dvec3 moment) {
        SectionForce& sum = m_layers[size_t(axis)][size_t(layer)];
        sum.force += force, sum.moment += moment;
    }
    const StressNode& m_node;
    std::array<std::array<SectionForce, 8>, 3> m_layers;
};

}  // namespace rubble
