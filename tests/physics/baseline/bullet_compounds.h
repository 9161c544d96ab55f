#pragma once
#include <memory>
#include <vector>

#include "runtime/core/pose.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// What Rubble's physics is measured against: Bullet as it comes, with every body a compound (with its tree) of the
/// boxes that its voxels merge to. Sleeping is off.
class BulletCompounds {
public:
    enum class Detail { OneBox, MergedBoxes, EveryVoxel };  ///< of what moves; what stands is merged boxes
    struct Settings {
        int substeps = 1;  ///< of 1/60 s
        int iterations = 10;
        int frictionDirections =
            2;  ///< 1, Bullet's default, lets piles slide apart: friction acts along one line a contact
        Detail detail = Detail::MergedBoxes;
    };
    /// Bodies of the level in order; one shape each. Materials' friction and restitution as in Rubble.
    BulletCompounds(const Level& level, const Settings& settings);
    ~BulletCompounds();
    /// 1/60 s.
    void step();
    /// Of the body's frame (its grid's frame in the level), world.
    Pose pose(size_t body) const;
    size_t boxes() const;
    /// Pairs of bodies that touch.
    int pairs() const;

private:
    struct World;
    std::unique_ptr<World> m_world;
};

}  // namespace rubble
