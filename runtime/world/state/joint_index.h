#pragma once
#include <map>
#include <span>
#include <vector>

#include "runtime/world/objects/joint.h"

namespace rubble {

/// Finds the joints of a shape, the ropes, the wheels and the grabs: a split costs its own joints, not all of the
/// world.
class JointIndex {
public:
    /// Adds a joint under the shapes of its ends.
    void add(JointHandle handle, const Joint& joint);
    /// Removes a joint; its ends, kind and hand must be as when it was added.
    void remove(JointHandle handle, const Joint& joint);
    /// Removes all joints.
    void clear();
    /// Joints with an end on a shape, in slot order.
    std::span<const JointHandle> of(ShapeHandle shape) const;
    /// All ropes, in slot order.
    std::span<const JointHandle> ropes() const { return m_ropes; }
    /// All wheels, in slot order.
    std::span<const JointHandle> wheels() const { return m_wheels; }
    /// All grabs, in slot order.
    std::span<const JointHandle> grabs() const { return m_grabs; }

private:
    std::map<uint32_t, std::vector<JointHandle>> m_byShape;
    std::vector<JointHandle> m_ropes, m_wheels, m_grabs;
};

}  // namespace rubble
