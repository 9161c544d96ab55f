#pragma once
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "physics/collision/broadphase.h"
#include "physics/solver/joint_solver.h"

namespace rubble {

/// A joint of World as physics holds it.
struct JointProxy {
    JointHandle handle;
    Joint joint;
    std::array<BodyHandle, 2> bodies;                     ///< empty: what stands still
    std::array<Pose, 2> frames;                           ///< in the bodies' frames, or in the world
    std::array<uint32_t, 2> objects{kNothing, kNothing};  ///< numbers of the collision objects that it joins
    int restSteps = 0;                                    ///< steps in which a rope has hardly moved
    JointConstraint constraint;                           ///< with the impulses of the last step

    /// A motor that is to turn does not let anything sleep.
    bool isMotorDriven() const {
        return joint.motor.mode == MotorMode::Speed && joint.motor.target != 0.0 && joint.motor.maxForce > 0.0;
    }

    static constexpr uint32_t kNothing = ~0u;
};

/// All joints by slot, and those of each body. Without joints it holds nothing.
class JointTable {
public:
    bool empty() const { return m_count == 0; }
    JointProxy* at(uint32_t slot) const { return slot < m_joints.size() ? m_joints[slot].get() : nullptr; }
    /// Slots of the joints of a body, ascending.
    std::span<const uint32_t> of(uint32_t body) const {
        return body < m_ofBody.size() ? std::span<const uint32_t>(m_ofBody[body]) : std::span<const uint32_t>();
    }
    JointProxy& add(std::unique_ptr<JointProxy> joint);
    std::unique_ptr<JointProxy> remove(uint32_t slot);
    std::span<const uint32_t> ropes() const { return m_ropes; }
    /// Leaves out the pairs that joints keep from touching.
    void removeNonColliding(std::vector<ObjectPair>& pairs) const;

private:
    std::vector<std::unique_ptr<JointProxy>> m_joints;
    std::vector<std::vector<uint32_t>> m_ofBody;
    std::vector<std::pair<uint32_t, uint32_t>> m_nonColliding;  ///< sorted; once for each joint
    std::vector<uint32_t> m_ropes;                              ///< slots, ascending
    size_t m_count = 0;
};

}  // namespace rubble
