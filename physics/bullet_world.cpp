#include "physics/bullet_world.h"

namespace rubble {
namespace {

constexpr btScalar kSlop = 0.002f;  ///< metres that contacts may overlap: without it they come and go, and nothing settles

btDefaultCollisionConstructionInfo poolSizes() {
    btDefaultCollisionConstructionInfo info;
    info.m_customCollisionAlgorithmMaxElementSize = int(sizeof(BoxCollision));
    return info;
}

}  // namespace

BulletParts::BulletParts() : configuration(poolSizes()) {
    for (const int first : {BOX_SHAPE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE})
        for (const int second : {BOX_SHAPE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE}) dispatcher.registerCollisionCreateFunc(first, second, &boxCollision);
}

BulletWorld::BulletWorld(int solverIterations)
    : btDiscreteDynamicsWorld(&(BulletParts::dispatcher), &(BulletParts::broadphase), &(BulletParts::solver), &(BulletParts::configuration)) {
    setForceUpdateAllAabbs(false);
    getDispatchInfo().m_useContinuous = false;  // only inflates bounds: compounds get no continuous collision from Bullet
    setGravity({0, 0, 0});
    getSolverInfo().m_linearSlop = kSlop;
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

void BulletWorld::addResting(btCollisionObject& object) {
    btVector3 low, high;
    btCollisionShape& shape = *object.getCollisionShape();
    shape.getAabb(object.getWorldTransform(), low, high);
    object.setIslandTag(-1);  // what the walk over the lists would say
    object.setCompanionId(-2);
    object.setBroadphaseHandle(getBroadphase()->createProxy(low, high, shape.getShapeType(), &object, btBroadphaseProxy::StaticFilter,
                                                            btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter, getDispatcher()));
}

void BulletWorld::removeResting(btCollisionObject& object) {
    btBroadphaseProxy* proxy = object.getBroadphaseHandle();
    getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(proxy, getDispatcher());
    getBroadphase()->destroyProxy(proxy, getDispatcher());
    object.setBroadphaseHandle(nullptr);
}

void BulletWorld::enlist(btCollisionObject& object) {
    object.setWorldArrayIndex(m_collisionObjects.size());
    m_collisionObjects.push_back(&object);
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
