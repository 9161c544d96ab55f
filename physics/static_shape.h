#pragma once
#include <map>
#include <memory>
#include <set>

#include "physics/bullet_world.h"
#include "physics/collider.h"
#include "runtime/world/world.h"

namespace rubble {

/// A shape of a static body in Bullet: one collision object for each region of 32^3 cells, so that a carve rebuilds only
/// the regions it touches.
class StaticShape {
public:
    /// origin: world position of Bullet's zero.
    StaticShape(BulletWorld& bullet, const Shape& shape, const Pose& shapeToWorld, const MaterialTable& materials, glm::dvec3 origin);
    ~StaticShape();
    StaticShape(const StaticShape&) = delete;
    StaticShape& operator=(const StaticShape&) = delete;

    /// Replaces the objects of the regions that hold these bricks by new ones from the shape as it is now.
    void rebuild(const Shape& shape, const MaterialTable& materials, const std::vector<glm::ivec3>& bricks);
    BodyHandle body() const { return m_body; }
    int boxCount() const { return m_boxCount; }
    /// Of a brick's cells, in Bullet's frame.
    void brickBounds(glm::ivec3 brick, btVector3& low, btVector3& high) const;

private:
    struct Region {
        explicit Region(const std::vector<ColliderBox>& boxes) : collider(boxes) {}
        Collider collider;
        btCollisionObject object;
    };
    /// Regions in the order of their coordinates.
    struct Before {
        bool operator()(const glm::ivec3& a, const glm::ivec3& b) const { return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x; }
    };
    using RegionSet = std::set<glm::ivec3, Before>;

    void addRegion(const Shape& shape, const MaterialTable& materials, glm::ivec3 region);
    void removeRegion(glm::ivec3 region);

    BulletWorld& m_bullet;
    glm::dvec3 m_origin;
    BodyHandle m_body;
    Pose m_pose;  ///< grid corner -> world
    double m_voxelSize;
    std::map<glm::ivec3, std::unique_ptr<Region>, Before> m_regions;
    int m_boxCount = 0;
};

}  // namespace rubble
