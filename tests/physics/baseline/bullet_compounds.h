#pragma once
#include <memory>
#include <vector>

#include "runtime/core/pose.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// The baseline that Rubble's physics is compared with: Bullet, with every body a compound shape (with its tree) of the
/// boxes that its voxels merge to. Sleeping is off.
class BulletCompounds {
public:
    /// The shape of dynamic bodies; static ones are always merged boxes.
    enum class Detail { OneBox, MergedBoxes, EveryVoxel };
    struct Settings {
        int substeps = 1;  ///< of 1/60 s
        int iterations = 10;
        /// 1, Bullet's default, lets piles slide apart: friction acts along one line at each contact.
        int frictionDirections = 2;
        Detail detail = Detail::MergedBoxes;
    };
    /// The level's bodies must have one shape each. Friction and restitution are those of Rubble.
    BulletCompounds(const Level& level, const Settings& settings);
    ~BulletCompounds();
    /// Moves everything by 1/60 s.
    void step();
    /// Of the body with this index in the level, world.
    Pose pose(size_t body) const;
    /// The number of boxes of all bodies.
    size_t boxes() const;
    /// The number of pairs of bodies that touch.
    int pairs() const;

private:
    struct World;
    std::unique_ptr<World> m_world;
};

}  // namespace rubble
