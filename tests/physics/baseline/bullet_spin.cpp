#include "tests/physics/baseline/bullet_spin.h"

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace rubble {
namespace {

struct SpinWorld {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btEmptyShape shape;
    std::unique_ptr<btRigidBody> body;
    bool started = false;

    SpinWorld(BulletGyroscopy mode, glm::dvec3 inertia) {
        world.setGravity({0, 0, 0});
        const btVector3 moments{btScalar(inertia.x), btScalar(inertia.y), btScalar(inertia.z)};
        body = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, moments));
        body->setDamping(0, 0);
        body->setFlags(mode == BulletGyroscopy::None       ? 0
                       : mode == BulletGyroscopy::Explicit ? BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT
                                                           : BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
        body->setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(body.get());
    }
    ~SpinWorld() { world.removeRigidBody(body.get()); }
};

}  // namespace

std::function<void(glm::dquat&, glm::dvec3&)> bulletSpin(BulletGyroscopy mode, glm::dvec3 inertia, int substeps) {
    const auto spin = std::make_shared<SpinWorld>(mode, inertia);
    return [spin, substeps](glm::dquat& rotation, glm::dvec3& w) {
        if (!spin->started) {
            const glm::dvec3 world = rotation * w;
            spin->body->setAngularVelocity({btScalar(world.x), btScalar(world.y), btScalar(world.z)});
        }
        spin->started = true;
        const btScalar h = btScalar(1.0 / 60.0 / substeps);
        for (int i = 0; i < substeps; ++i) spin->world.stepSimulation(h, 0, h);
        const btQuaternion q = spin->body->getOrientation();
        const btVector3& v = spin->body->getAngularVelocity();
        rotation = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
        w = glm::conjugate(rotation) * glm::dvec3(v.x(), v.y(), v.z());
    };
}

}  // namespace rubble
