#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/joints/rope_path.h"
#include "physics/solver/joint_rows.h"

namespace rubble {

/// A joint of World as physics holds it.
struct JointProxy {
    JointHandle handle;
    Joint joint;
    std::array<BodyHandle, 2> bodies;                     ///< dynamic ones; empty: something static
    std::array<Pose, 2> frames;                           ///< in the bodies' frames, or in the world
    std::array<uint32_t, 2> objects{kNothing, kNothing};  ///< numbers of the collision objects that it joins
    int restSteps = 0;                                    ///< steps in which a rope went nowhere
    std::vector<glm::dvec3> restPoints, restSums;         ///< where its points were then, and sums of where they are
    std::vector<RopeBend> bends;                          ///< of a rope between its bodies, as of its last motion
    /// Where a rope leaves the body at its end, in the frame of that body's centre of mass; none: at the end.
    std::array<std::optional<glm::dvec3>, 2> leaves;
    double wound = 0.0;   ///< metres by which a winch has changed a rope's length since the last step
    double excess = 0.0;  ///< metres by which a rope is still longer than it was made: see PhysicsJoints::findPath()
    JointConstraint constraint;  ///< with the impulses of the last step

    /// Whether a speed motor or a hand drives it: then nothing that it joins may sleep.
    bool isMotorDriven() const {
        if (joint.drives) return joint.velocity != glm::dvec3(0.0) || joint.angularVelocity != glm::dvec3(0.0);
        return joint.motor.mode == MotorMode::Speed && joint.motor.target != 0.0 && joint.motor.maxForce > 0.0;
    }

    static constexpr uint32_t kNothing = ~0u;
};

/// All joints by slot, and those of each body. It allocates nothing while there are no joints.
class JointTable {
public:
    /// Whether there is no joint.
    bool empty() const { return m_count == 0; }
    /// The joint in a slot; null: there is none.
    JointProxy* at(uint32_t slot) const { return slot < m_joints.size() ? m_joints[slot].get() : nullptr; }
    /// Slots of the joints of a body, ascending.
    std::span<const uint32_t> of(uint32_t body) const {
        return body < m_ofBody.size() ? std::span<const uint32_t>(m_ofBody[body]) : std::span<const uint32_t>();
    }
    /// Puts a joint into its slot, which must be empty.
    JointProxy& add(std::unique_ptr<JointProxy> joint);
    /// Takes a joint out; null: there was none.
    std::unique_ptr<JointProxy> remove(uint32_t slot);
    /// Slots of the joints that are ropes, ascending.
    std::span<const uint32_t> ropes() const { return m_ropes; }
    /// Removes the pairs of objects that a joint keeps from colliding.
    void removeNonColliding(std::vector<ObjectPair>& pairs) const;

private:
    std::vector<std::unique_ptr<JointProxy>> m_joints;
    std::vector<std::vector<uint32_t>> m_ofBody;
    std::vector<std::pair<uint32_t, uint32_t>> m_nonColliding;  ///< sorted object numbers; once for each joint
    std::vector<uint32_t> m_ropes;
    size_t m_count = 0;
};

}  // namespace rubble
