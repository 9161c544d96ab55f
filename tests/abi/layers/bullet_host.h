#pragma once
#include <btBulletDynamicsCommon.h>
#include <rubble/rubble.h>

#include <map>
#include <memory>
#include <vector>

namespace rubble {

/// A host with Bullet's stock world, which knows Rubble by rubble.h alone: bodies are compounds of the boxes that
/// Rubble gives, hits are reported back. The floor is its own.
class BulletHost {
public:
    /// Of a world with RUBBLE_WORLD_HOST_PHYSICS.
    BulletHost(const rubble_api& api, rubble_world world);
    ~BulletHost();

    /// A frame: Rubble's step, then Bullet's, as rubble_rigid_body describes.
    void frame();
    /// Shoots a ball of its own.
    void shoot(btVector3 from, btVector3 velocity, btScalar radius, btScalar mass);

    /// The fastest of Rubble's bodies that are awake, m/s.
    double highestSpeed() const;
    /// Bodies that move.
    int dynamicBodies() const;
    /// The lowest point of Rubble's bodies.
    double lowestPoint() const;
    /// Hits that were reported so far, and those of them that were with the floor.
    int impacts = 0, floorImpacts = 0;

private:
    /// A body of Rubble's in Bullet's world.
    struct Rigid {
        std::vector<std::unique_ptr<btBoxShape>> boxes;
        std::unique_ptr<btCompoundShape> compound;
        std::unique_ptr<btRigidBody> body;
        btTransform centerInBody;  ///< Bullet's frame is at the centre of mass, along the principal axes
        btVector3 velocity, spin;  ///< before Bullet's step
    };
    /// Makes what is new, removes what is gone, and rebuilds what has other voxels or was moved by an edit.
    void follow();
    void make(const rubble_rigid_body& row);
    void remove(rubble_body body);
    void pushBodies();
    void handBack();
    void reportImpacts();

    const rubble_api& m_api;
    rubble_world m_world;
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_bullet{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    btStaticPlaneShape m_plane{btVector3(0, 1, 0), 0};
    btRigidBody m_floor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &m_plane)};
    std::unique_ptr<btSphereShape> m_ballShape;
    std::unique_ptr<btRigidBody> m_ball;
    btVector3 m_ballVelocity{0, 0, 0};
    std::map<rubble_body, Rigid> m_bodies;
};

}  // namespace rubble
