#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <functional>
#include <vector>

#include "physics/box_collision.h"

namespace rubble {

/// The parts that Bullet's world points to: made before it, gone after it.
struct BulletParts {
    BulletParts();
    BoxCollisionFactory boxCollision;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
};

/// Bullet's world with our order of a substep and hooks around its solver. Bullet's own sleeping is off.
class BulletWorld : private BulletParts, public btDiscreteDynamicsWorld {
public:
    explicit BulletWorld(int solverIterations);

    /// One fixed substep: forces, collision, solve, integration. No clock, no motion states.
    void substep(btScalar seconds);
    /// Resting objects are in the broadphase and in none of the lists that Bullet walks each substep: they cost nothing
    /// until something comes near. What stands still for good rests too.
    void addResting(btCollisionObject& object);
    void removeResting(btCollisionObject& object);
    /// Lets a resting object that has become dynamic take part in the substep that is under way; from then on it is
    /// removed as a body.
    void enlist(btCollisionObject& object);
    /// Collision objects whose bounds in the broadphase overlap these.
    void overlapping(const btVector3& low, const btVector3& high, std::vector<btCollisionObject*>& out);

    std::function<void()> beforeSolve;  ///< contacts are known, impulses are not
    std::function<void()> afterSolve;   ///< contacts carry their impulses, poses are still old

protected:
    void calculateSimulationIslands() override;
    void solveConstraints(btContactSolverInfo& info) override;
    void updateActivationState(btScalar) override {}
};

}  // namespace rubble
