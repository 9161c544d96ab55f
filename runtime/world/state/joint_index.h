#pragma once
#include <map>
#include <span>
#include <vector>

#include "runtime/world/objects/joint.h"

namespace rubble {

/// Finds the joints of a shape, the ropes, the grabs, and what winds or turns: a split costs its own joints and a step
/// those that change, not all of the world.
class JointIndex {
public:
    /// Adds a joint under the shapes of its ends.
    void add(JointHandle handle, const Joint& joint);
    /// Removes a joint; its ends, kind and hand must be as when it was added.
    void remove(JointHandle handle, const Joint& joint);
    /// To be called when the motor or the steering of a joint has changed.
    void updateDrive(JointHandle handle, const Joint& joint);
    /// Removes all joints.
    void clear();
    /// Joints with an end on a shape, in slot order.
    std::span<const JointHandle> of(ShapeHandle shape) const;
    /// All ropes, in slot order.
    std::span<const JointHandle> ropes() const { return m_ropes; }
    /// Ropes whose winch is on, in slot order.
    std::span<const JointHandle> winding() const { return m_winding; }
    /// Wheels that are not yet where they steer to, in slot order.
    std::span<const JointHandle> turning() const { return m_turning; }
    /// All grabs, in slot order.
    std::span<const JointHandle> grabs() const { return m_grabs; }

private:
    std::map<uint32_t, std::vector<JointHandle>> m_byShape;
    std::vector<JointHandle> m_ropes, m_winding, m_turning, m_grabs;
};

}  // namespace rubble
