#pragma once
#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <array>
#include <vector>

#include "physics/collider.h"

namespace rubble {

/// Where two boxes touch: the point is on the second body, the normal points from it to the first, depth < 0 inside.
struct BoxContact {
    btVector3 normal, point;
    btScalar depth;
};

/// Keeps at most four: the deepest, the one farthest from it, the one farthest from their line, and the one farthest from
/// that on the other side.
void reduceContacts(std::vector<BoxContact>& contacts);

/// Buffers of all pairs of one BulletWorld, kept so that steps do not allocate.
struct BoxCollisionScratch {
    std::vector<int> first, second;                   ///< boxes that may touch
    std::array<std::vector<BoxContact>, 6> contacts;  ///< by direction of the normal
};

/// Collision of two Colliders, box against box. Contacts are sorted by the direction of their normal (six, in the frame of
/// the first body's boxes) and each direction keeps four: Bullet's own compounds keep four for each pair of boxes.
class BoxCollision : public btCollisionAlgorithm {
public:
    BoxCollision(const btCollisionAlgorithmConstructionInfo& info, BoxCollisionScratch& scratch) : btCollisionAlgorithm(info), m_scratch(scratch) {}
    ~BoxCollision() override;
    void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second, const btDispatcherInfo& info,
                          btManifoldResult* result) override;
    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }
    void getAllContactManifolds(btManifoldArray& manifolds) override;

private:
    void findContacts(const Collider& first, const btTransform& firstWorld, const Collider& second, const btTransform& secondWorld);
    void keepContacts(int direction, btManifoldResult& result);

    BoxCollisionScratch& m_scratch;
    std::array<btPersistentManifold*, 6> m_manifolds{};  ///< by direction; none where nothing touches
};

/// Makes BoxCollisions for Bullet's dispatcher.
class BoxCollisionFactory : public btCollisionAlgorithmCreateFunc {
public:
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper*,
                                                   const btCollisionObjectWrapper*) override;

private:
    BoxCollisionScratch m_scratch;
};

}  // namespace rubble
