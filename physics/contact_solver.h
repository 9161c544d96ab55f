#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "physics/four.h"
#include "physics/manifold.h"

namespace rubble {

/// A body as the solver moves it. Its frame is its principal axes about the centre of mass.
struct SolverBody {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    glm::dvec3 inertia{1.0};  ///< kg m2
    double inverseMass = 0.0;
    double reach = 0.0;      ///< metres: half its smallest side
    bool conserves = false;  ///< its rotation keeps angular momentum: for uneven bodies that spin fast
};

struct SolverSettings {
    int substeps = 4;
    int iterations = 1;           ///< over all contacts, in each half of a substep
    double seconds = 1.0 / 60.0;  ///< of all substeps together
    double contactHertz = 60.0;   ///< stiffness of contacts, at most a quarter of the rate of substeps
    double dampingRatio = 5.0;
    double heavyRatio = 30.0;  ///< of masses above which a light body that bears a heavy one gets stiffer contacts
    int heavyPasses = 8;       ///< over the contacts of such bodies, more than over others; 0: none is stiffer
    double pushSpeed = 3.0;    ///< m/s at which overlaps are pushed apart
    double slop = 0.0002;      ///< metres that contacts may overlap, so that they last
    double bounceSpeed = 1.0;  ///< m/s of approach below which nothing bounces
};

/// Contacts between bodies, solved in substeps: soft constraints pushed apart and relaxed, positions followed within the
/// step without finding contacts anew (Catto, "Solver2D", 2023; Macklin et al., "Small Steps in Physics Simulation", 2019).
/// Body 0 of `bodies` is the world: it does not move. The same input gives the same bits.
class ContactSolver {
public:
    /// Moves the bodies by settings.seconds. bodyOf: the number in `bodies` of each manifold's first and second; impulses of
    /// the manifolds are where the solver starts, and what it found.
    void solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity,
               const SolverSettings& settings);

private:
    void prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf, float seconds);
    void warmStart();
    void solveContacts(float inverseSeconds, bool pushApart);
    void move(std::span<SolverBody> bodies, glm::dvec3 gravity, double seconds);
    void bounce(float threshold);
    void store();

    struct Softness {
        float biasRate = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    static Softness soften(double hertz, double dampingRatio, double seconds);

    /// A body within the step.
    struct State {
        glm::vec3 v{0.0f}, w{0.0f};
        float inverseMass = 0.0f, reach = 0.0f;
        glm::vec3 moved{0.0f};           ///< since the step began
        glm::mat3 turned{0.0f};          ///< rotation since the step began, less the identity
        glm::mat3 inverseInertia{0.0f};  ///< world
        bool touches = false, bears = false;
        bool inertiaTurns = false;  ///< within the step
    };
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
    /// What pushes a contact apart, or lets it close.
    struct Push {
        float bias = 0.0f, massScale = 1.0f, impulseScale = 0.0f;
    };
    /// The contacts of two bodies.
    struct Range {
        int a, b;  ///< in m_states
        size_t from, to;
        int passes;
    };
    void findBearers(glm::vec3 up, float ratio);
    void solveRange(const Range& range, float inverseSeconds, bool pushApart);
    void addCore(const Range& range, const Constraint& fastest);
    Push pushOf(const Constraint& c, const State& A, const State& B, float inverseSeconds, bool pushApart) const;
    static void solveNormal(Constraint& c, const Push& push, Moving& bodies);
    static void solveFriction(Constraint& c, Moving& bodies);

    std::vector<State> m_states;
    std::vector<Range> m_ranges;
    std::vector<Constraint> m_constraints;
    std::vector<size_t> m_bearing;    ///< ranges of bodies that bear
    std::vector<glm::dquat> m_start;  ///< rotations at the start of the step
    Softness m_soft, m_softStatic, m_stiff;
    int m_heavyPasses = 0;
    float m_pushSpeed = 0.0f, m_slop = 0.0f;
};

/// One substep of a body's rotation. Bodies that conserve hold their angular momentum (see rotation.cpp for how); the others
/// keep their angular velocity.
void rotateBody(SolverBody& body, double seconds);
/// World tensor of a body's inverse inertia.
glm::dmat3 worldInverseInertia(const SolverBody& body);

}  // namespace rubble
