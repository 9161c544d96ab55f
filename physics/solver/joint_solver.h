#pragma once
#include <array>
#include <span>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "runtime/world/objects/joint.h"

namespace rubble {

/// A joint between two of the solver's bodies, with the impulses (N s of a substep) that it isLoadBearing: where the
/// next step starts.
struct JointConstraint {
    const Joint* joint = nullptr;
    JointHandle handle;
    std::array<int, 2> bodies{};            ///< of the solver; 0: the world
    std::array<Pose, 2> frames;             ///< in the bodies, or in the world
    std::array<double, 6> lockedImpulse{};  ///< in the directions that the joint holds
    std::array<double, 2> limitImpulse{};   ///< low and high
    double spring = 0.0, motor = 0.0, friction = 0.0;
    std::vector<glm::dvec3> bendPoints;  ///< places at which a rope lies on something, in order, world
    glm::dvec3 ballFriction{0.0};        ///< friction of a ball
    glm::dvec3 force{0.0}, torque{0.0};  ///< N and N m that it lockedImpulse in the last step, on average
};

/// Joints within the substeps of ContactSolver. What rigid joints hold is solved at once, by a direct method (L D L^T
/// over a skyline): a chain isLoadBearing any weight; limits, motors, springs and friction are directions of their own.
/// What is rigid is a soft constraint as stiff as contacts, relaxed like them.
class JointSolver {
public:
    /// Begins a step.
    void begin(std::span<JointConstraint* const> joints, std::span<SolverState> states);
    /// Begins a substep: directions and masses where the bodies are now, and the impulses of the substep before.
    void prepare(std::span<const SolverBody> bodies, std::span<SolverState> states, double seconds);
    /// Some passes over all joints. useBias: errors of places are worked off; else only velocities count.
    void solve(std::span<const SolverBody> bodies, std::span<SolverState> states, bool useBias);
    /// Ends a substep: adds what was lockedImpulse to the joints' forces.
    void note(double stepSeconds);
    /// Whether there is a largest value of the free motion: of a cone's angle, or a rope's displacement.
    static bool hasOnlyUpperLimit(const Joint& joint) {
        return joint.kind == JointKind::Rope || joint.kind == JointKind::Cone ||
               (joint.kind == JointKind::Ball && joint.limits.on);
    }
    bool empty() const { return m_joints.empty(); }

private:
    static constexpr int kPasses = 4;        ///< over joints that are solved one after the other
    static constexpr int kSystemPasses = 2;  ///< where a system holds them
    /// A direction: its speed is linearB vB + angularB wB - linearA vA - angularA wA.
    struct Row {
        glm::dvec3 linearA{0.0}, angularA{0.0}, linearB{0.0}, angularB{0.0};
    };
    struct Softness {
        double biasRate = 0.0, massScale = 1.0, impulseScale = 0.0;
    };
    /// A direction in which the bodies are free but for limits, springs, motors and friction.
    struct Free {
        Row row;
        double value = 0.0, mass = 0.0;
    };
    struct Entry {
        JointConstraint* c = nullptr;
        int rows = 0;
        std::array<Row, 6> row;
        std::array<double, 6> error{};
        std::array<std::array<double, 6>, 6> lower{};  ///< L of the block's mass matrix
        std::array<double, 6> diagonal{};              ///< and D; 0: nothing moves that displacement
        Softness soft, stop, spring;
        Free freeAxis, motorAxis;          ///< the same but for wheels, which travel and spin
        glm::dmat3 ballFrictionMass{0.0};  ///< mass of a ball's friction
        bool isInSystem = false;           ///< its lockedImpulse directions are solved with all others at once
        bool isSoft = false, springs = false, hasBallFriction = false;
    };
    static Softness makeSoft(double hertz, double dampingRatio, double seconds);
    void computeRows(Entry& e, std::span<const SolverBody> bodies) const;
    static void factorize(Entry& e, const SolverState& A, const SolverState& B);
    static void solveBlock(const Entry& e, std::array<double, 6>& x);
    static double rowVelocity(const Row& row, const SolverState& A, const SolverState& B);
    static void push(const Row& row, SolverState& A, SolverState& B, double impulse);
    static double effectiveMass(const Row& row, const SolverState& A, const SolverState& B);
    void solveFreeAxis(Entry& e, SolverState& A, SolverState& B, bool useBias) const;
    void solveBallFriction(Entry& e, SolverState& A, SolverState& B) const;
    void solveLockedAxes(Entry& e, SolverState& A, SolverState& B, bool useBias) const;

    /// How much the speed in a direction must change.
    static double velocityError(const Entry& e, int row, const SolverState& A, const SolverState& B, bool useBias);

    // joint_system.cpp: all rigid joints at once
    void buildSystem();
    void factorizeSystem(std::span<const SolverState> states);
    void solveSystem(std::span<SolverState> states, bool useBias);

    std::vector<Entry> m_joints;
    std::vector<int> m_order;                  ///< of the joints in the system; empty: each is solved by itself
    std::vector<int> m_offset;                 ///< of their first rows
    std::vector<std::pair<int, int>> m_pairs;  ///< of places in the order that share a body, the later first
    std::vector<int> m_rowFirst;               ///< the first column of each row
    std::vector<size_t> m_rowStart;
    std::vector<double> m_matrix, m_solution;
    double m_seconds = 0.0;
    bool m_isNew = true;  ///< nothing is laid out for these joints yet
};

}  // namespace rubble
