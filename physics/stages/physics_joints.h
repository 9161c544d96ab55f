#pragma once
#include <memory>
#include <span>
#include <vector>

#include "physics/joints/joint_table.h"
#include "physics/joints/rope.h"
#include "physics/stages/body_constraints.h"
#include "physics/stages/physics_bodies.h"

namespace rubble {

/// The joints of a World as physics has them, and ropes. [main-thread]
class PhysicsJoints {
public:
    /// All joints.
    const JointTable& table() const { return m_table; }
    /// Whether a body has joints.
    bool isJointed(uint32_t body) const { return !m_table.of(body).empty(); }
    /// Creates a joint as World has it, without a warm start.
    void create(const World& world, JointHandle handle, PhysicsBodies& bodies);
    /// Takes over the joints that were created, changed or broken, and wakes what they join.
    void apply(const FrameChanges& changes, const World& world, PhysicsBodies& bodies);
    /// Takes over the constraints of the step that follows, and wakes their bodies.
    void constrain(const FrameChanges& changes, const World& world, PhysicsBodies& bodies) {
        m_constraints.set(changes, world, bodies);
    }
    /// Begins a step: clears what the last one reported.
    void begin();
    /// Wakes whatever is jointed to an awake body.
    void wakeJointed(PhysicsBodies& bodies) const;
    /// The joints of awake bodies in a step, in the order of slots, and the constraints of bodies, in that of their
    /// edits; valid until the next call. Bodies must know their solver index.
    std::span<JointConstraint* const> gather(PhysicsBodies& bodies, double seconds);
    /// Joules that the joints of the last gather() gave their bodies in the solve: see JointConstraint::work.
    double work() const;
    /// Notes the joints whose force or torque in the last solve was more than they can stand.
    void findBroken();
    /// Puts groups of jointed bodies to sleep, each when all its bodies want to sleep and no motor runs. solverBodies:
    /// the number of bodies in the solver.
    void putToSleep(PhysicsBodies& bodies, size_t solverBodies) const;
    /// Moves the points of ropes, after the bodies.
    void moveRopes(PhysicsBodies& bodies, glm::dvec3 gravity, double seconds);
    /// The joints that findBroken() found in this step, in the order of slots.
    std::span<const JointHandle> broken() const { return m_broken; }
    /// The ropes that moved in this step, in the order of slots.
    std::span<const RopeMotion> ropeMotions() const { return m_ropeMotions; }

private:
    void findActive(PhysicsBodies& bodies, double seconds);
    std::unique_ptr<JointProxy> destroy(uint32_t slot, PhysicsBodies& bodies);
    void recreate(const World& world, JointHandle handle, PhysicsBodies& bodies);
    void forgetMotion(const FrameChanges& changes, const PhysicsBodies& bodies);
    static RopeStep ropeStep(const JointProxy& rope, PhysicsBodies& bodies, double seconds);
    static void findPath(JointProxy& rope, PhysicsBodies& bodies);

    JointTable m_table;
    BodyConstraints m_constraints;
    std::vector<JointConstraint*> m_active;  ///< joints of the last gather()
    std::vector<JointConstraint*> m_solved;  ///< all of the last gather()
    std::vector<JointHandle> m_broken;
    std::vector<RopeMotion> m_ropeMotions;
};

}  // namespace rubble
