#pragma once
#include <memory>
#include <vector>

#include "physics/stages/physics_bodies.h"
#include "runtime/world/state/level_ground.h"

namespace rubble {

/// The solid ground around a level, where World has some: static objects that belong to no body. Bodies, ropes, wheels
/// and characters meet it as they meet static voxels. [main-thread]
class Ground {
public:
    /// Takes over World's ground. wakes: where it has changed, what touches the old or the new one wakes.
    void update(const World& world, PhysicsBodies& bodies, bool wakes);

private:
    GroundSlabs m_slabs;
    std::vector<std::unique_ptr<CollisionObject>> m_objects;  ///< one a slab
};

}  // namespace rubble
