#include "physics/bullet_world.h"

namespace rubble {

BulletWorld::BulletWorld(int solverIterations)
    : btDiscreteDynamicsWorld(&(BulletParts::dispatcher), &(BulletParts::broadphase), &(BulletParts::solver), &(BulletParts::configuration)) {
    setForceUpdateAllAabbs(false);
    getDispatchInfo().m_useContinuous = false;  // only inflates bounds: compounds get no continuous collision from Bullet
    setGravity({0, 0, 0});
    getSolverInfo().m_numIterations = solverIterations;
}

void BulletWorld::substep(btScalar seconds) {
    BulletParts::solver.setRandSeed(0);
    applyGravity();
    internalSingleStepSimulation(seconds);
    clearForces();
}

void BulletWorld::calculateSimulationIslands() {
    if (beforeSolve) beforeSolve();
    btDiscreteDynamicsWorld::calculateSimulationIslands();
}

void BulletWorld::solveConstraints(btContactSolverInfo& info) {
    btDiscreteDynamicsWorld::solveConstraints(info);
    if (afterSolve) afterSolve();
}

void BulletWorld::overlapping(const btVector3& low, const btVector3& high, std::vector<btCollisionObject*>& out) {
    struct Collect : btBroadphaseAabbCallback {
        explicit Collect(std::vector<btCollisionObject*>& found) : objects(found) {}
        bool process(const btBroadphaseProxy* proxy) override {
            objects.push_back(static_cast<btCollisionObject*>(proxy->m_clientObject));
            return true;
        }
        std::vector<btCollisionObject*>& objects;
    } collect(out);
    getBroadphase()->aabbTest(low, high, collect);
}

}  // namespace rubble
