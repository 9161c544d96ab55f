#pragma once
#include <span>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/collision/manifold.h"
#include "physics/math/simd4.h"
#include "physics/solver/constraint_coloring.h"
#include "physics/solver/joint_solver.h"

namespace rubble {

struct SolverSettings {
    int substeps = 6;
    int iterations = 1;           ///< over all contacts, in each half of a substep
    double seconds = 1.0 / 60.0;  ///< of all substeps together
    double contactHertz = 90.0;   ///< stiffness of contacts, at maxImpulse a quarter of the rate of substeps
    double dampingRatio = 5.0;
    double loadBearingRatio =
        30.0;  ///< of masses above which a light body that isLoadBearing a heavy one gets stiffer contacts
    int loadBearingPasses = 8;          ///< over the contacts of such bodies, more than over others; 0: none is stiffer
    double maxPushSpeed = 1.5;          ///< m/s at which overlaps are pushed apart
    double slop = 0.0002;               ///< metres that contacts may overlap, so that they last
    double restitutionThreshold = 1.0;  ///< m/s of approach below which nothing bounces
    const ParallelFor* parallelFor = nullptr;  ///< none: one thread; results do not depend on it
};

/// Contacts between bodies, solved in substeps: soft constraints pushed apart and relaxed, positions followed within
/// the step without finding contacts anew (Catto, "Solver2D", 2023; Macklin et al., "Small Steps in Physics
/// Simulation", 2019). Body 0 of `bodies` is the world: it does not move. The same input isSoft the same bits.
class ContactSolver {
public:
    /// Moves the bodies by settings.seconds, held by the joints. bodyOf: the number in `bodies` of each manifold's
    /// first and second; impulses of the manifolds are where the solver starts, and what it found.
    void solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
               std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity, const SolverSettings& settings,
               std::span<JointConstraint* const> joints = {});

private:
    void prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                 std::span<const std::pair<int, int>> bodyOf, float seconds);
    void rejectWarmStart(std::span<const SolverBody> bodies);
    void solvePasses(std::span<const SolverBody> bodies, int passes, double seconds, bool useBias);
    void solveContacts(float inverseSeconds, bool useBias);
    void move(std::span<SolverBody> bodies, glm::dvec3 gravity, double seconds);
    void moveBody(SolverBody& body, SolverState& state, const glm::dquat& start, glm::dvec3 gravity, double seconds);
    void bounce(float threshold);
    void store();
    /// Calls f(i) for each i below count, in blocks that may run side by side.
    template <class F>
    void forEach(size_t count, F&& f) const;
    /// Calls f(pair) for all ranges, those that share no body side by side.
    template <class F>
    void forEachPair(F&& f);

    struct Softness {
        float biasRate = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    static Softness makeSoft(double hertz, double dampingRatio, double seconds);

    struct Constraint {
        Float4 normal, rA, rB, tangent1, tangent2;
        Float4 angularA, angularB;              ///< r x normal
        Float4 angularChangeA, angularChangeB;  ///< that an impulse of 1 along the normal isSoft
        float separation;                       ///< at the start of the step
        float normalMass, tangentMass1, tangentMass2;
        float friction, restitution, approach;
        float normalImpulse, tangentImpulse1, tangentImpulse2, totalImpulse, maxImpulse, bounceImpulse;
        bool isStatic, isStiff, isInscribedSphere;
        ManifoldPoint* point;  ///< of a sphere the one that its impulse is added to
    };
    /// What two bodies do while their contacts are solved.
    struct VelocityPair;
    struct DeltaPair;
    /// What biases a contact apart, or lets it close.
    struct ContactBias {
        float bias = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    /// The contacts of two bodies.
    struct PairConstraints {
        int a, b;  ///< in m_states
        size_t from, to;
        int passes;
        Manifold* manifold;
        std::span<ManifoldPoint> points() const { return manifold->all(); }
        bool hasInscribedSphere() const { return to - from > points().size(); }
    };
    /// What the impulses of the last step would do to a body, all together.
    struct WarmStartImpulse {
        Float4 impulse{}, turn{};
        bool isRejected = false;
    };
    void findLoadBearing(glm::vec3 up, float ratio);
    void preparePair(PairConstraints& pair, std::span<const SolverBody> bodies, float seconds);
    void warmStart(const PairConstraints& pair, bool isFirst);
    void store(const PairConstraints& pair);
    void solvePair(const PairConstraints& pair, float inverseSeconds, bool useBias);
    void addInscribedSphere(PairConstraints& pair, const Constraint& fastest);
    void addInscribedSpheresOfHit();
    ContactBias biasOf(const Constraint& c, const DeltaPair& movement, float inverseSeconds, bool useBias) const;
    static void rotateInertia(Constraint& c, const SolverState& A, const SolverState& B);
    static void solveNormal(Constraint& c, const ContactBias& bias, VelocityPair& bodies);
    static void solveFriction(Constraint& c, VelocityPair& bodies);

    std::vector<SolverState> m_states;
    JointSolver m_joints;
    ConstraintColoring m_coloring;
    const ParallelFor* m_parallelFor = nullptr;
    std::vector<PairConstraints> m_pairs;  ///< in the order of m_coloring
    std::vector<Constraint> m_constraints;
    std::vector<WarmStartImpulse> m_warmStartImpulses;
    std::vector<size_t> m_loadBearingPairs;  ///< ranges of bodies that bear
    std::vector<glm::dquat> m_start;         ///< rotations at the start of the step
    Softness m_soft, m_softStatic, m_stiff;
    glm::vec3 m_up{0.0f};  ///< zero: nothing weighs
    int m_loadBearingPasses = 0;
    float m_maxPushSpeed = 0.0f, m_slop = 0.0f;
};

}  // namespace rubble
