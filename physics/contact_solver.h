#pragma once
#include <span>
#include <vector>

#include "physics/four.h"
#include "physics/joint_solver.h"
#include "physics/manifold.h"
#include "physics/solver_state.h"
#include "physics/solver_strips.h"

namespace rubble {

struct SolverSettings {
    int substeps = 6;
    int iterations = 1;           ///< over all contacts, in each half of a substep
    double seconds = 1.0 / 60.0;  ///< of all substeps together
    double contactHertz = 90.0;   ///< stiffness of contacts, at most a quarter of the rate of substeps
    double dampingRatio = 5.0;
    double heavyRatio = 30.0;                  ///< of masses above which a light body that bears a heavy one gets stiffer contacts
    int heavyPasses = 8;                       ///< over the contacts of such bodies, more than over others; 0: none is stiffer
    double pushSpeed = 1.5;                    ///< m/s at which overlaps are pushed apart
    double slop = 0.0002;                      ///< metres that contacts may overlap, so that they last
    double bounceSpeed = 1.0;                  ///< m/s of approach below which nothing bounces
    const ParallelFor* parallelFor = nullptr;  ///< none: one thread; results do not depend on it
};

/// Contacts between bodies, solved in substeps: soft constraints pushed apart and relaxed, positions followed within the
/// step without finding contacts anew (Catto, "Solver2D", 2023; Macklin et al., "Small Steps in Physics Simulation", 2019).
/// Body 0 of `bodies` is the world: it does not move. The same input gives the same bits.
class ContactSolver {
public:
    /// Moves the bodies by settings.seconds, held by the joints. bodyOf: the number in `bodies` of each manifold's first and second; impulses of
    /// the manifolds are where the solver starts, and what it found.
    void solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity,
               const SolverSettings& settings, std::span<JointConstraint* const> joints = {});

private:
    void prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf, float seconds);
    void dropUnbalanced(std::span<const SolverBody> bodies);
    void solvePasses(std::span<const SolverBody> bodies, int passes, double seconds, bool pushApart);
    void solveContacts(float inverseSeconds, bool pushApart);
    void move(std::span<SolverBody> bodies, glm::dvec3 gravity, double seconds);
    void moveBody(SolverBody& body, SolverState& state, const glm::dquat& start, glm::dvec3 gravity, double seconds);
    void bounce(float threshold);
    void store();
    /// Calls f(i) for each i below count, in blocks that may run side by side.
    template <class F>
    void forEach(size_t count, F&& f) const;
    /// Calls f(range) for all ranges, those that share no body side by side.
    template <class F>
    void forRanges(F&& f);

    struct Softness {
        float biasRate = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    static Softness soften(double hertz, double dampingRatio, double seconds);

    struct Constraint {
        Four normal, rA, rB, tangent1, tangent2;
        Four leverA, leverB;  ///< r x normal
        Four spinA, spinB;    ///< that an impulse of 1 along the normal gives
        float separation;     ///< at the start of the step
        float normalMass, tangentMass1, tangentMass2;
        float friction, restitution, approach;
        float normalImpulse, tangentImpulse1, tangentImpulse2, total, most, bounceImpulse;
        bool isStatic, isStiff, isCore;
        ManifoldPoint* point;  ///< of a core the one that its impulse is added to
    };
    /// What two bodies do while their contacts are solved.
    struct Moving;
    struct Moved;
    /// What pushes a contact apart, or lets it close.
    struct Push {
        float bias = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    /// The contacts of two bodies.
    struct Range {
        int a, b;  ///< in m_states
        size_t from, to;
        int passes;
        Manifold* manifold;
        std::span<ManifoldPoint> points() const { return manifold->all(); }
        bool hasCore() const { return to - from > points().size(); }
    };
    /// What the impulses of the last step would do to a body, all together.
    struct Jolt {
        Four impulse{}, turn{};
        bool isTooHard = false;
    };
    void findBearers(glm::vec3 up, float ratio);
    void prepareRange(Range& range, std::span<const SolverBody> bodies, float seconds);
    void warmStart(const Range& range, bool isFirst);
    void store(const Range& range);
    void solveRange(const Range& range, float inverseSeconds, bool pushApart);
    void addCore(Range& range, const Constraint& fastest);
    void addCoresOfHit();
    Push pushOf(const Constraint& c, const Moved& moved, float inverseSeconds, bool pushApart) const;
    static void turnInertia(Constraint& c, const SolverState& A, const SolverState& B);
    static void solveNormal(Constraint& c, const Push& push, Moving& bodies);
    static void solveFriction(Constraint& c, Moving& bodies);

    std::vector<SolverState> m_states;
    JointSolver m_joints;
    SolverStrips m_strips;
    const ParallelFor* m_parallelFor = nullptr;
    std::vector<Range> m_ranges;  ///< in the order of m_strips
    std::vector<Constraint> m_constraints;
    std::vector<Jolt> m_jolts;
    std::vector<size_t> m_bearing;    ///< ranges of bodies that bear
    std::vector<glm::dquat> m_start;  ///< rotations at the start of the step
    Softness m_soft, m_softStatic, m_stiff;
    glm::vec3 m_up{0.0f};  ///< zero: nothing weighs
    int m_heavyPasses = 0;
    float m_pushSpeed = 0.0f, m_slop = 0.0f;
};

}  // namespace rubble
