#include "physics/static_shape.h"

#include <LinearMath/btAabbUtil2.h>

#include <cmath>

#include "physics/bullet_math.h"

namespace rubble {

StaticShape::StaticShape(BulletWorld& bullet, const Shape& shape, const Pose& shapeToWorld, const MaterialTable& materials, glm::dvec3 origin)
    : m_bullet(bullet), m_origin(origin), m_body(shape.body), m_pose(shapeToWorld), m_voxelSize(shape.voxelSize) {
    RegionSet regions;
    shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { regions.insert(brick / 4); });
    for (const glm::ivec3& region : regions) addRegion(shape, materials, region);
}

StaticShape::~StaticShape() {
    while (!m_regions.empty()) removeRegion(m_regions.begin()->first);
}

void StaticShape::rebuild(const Shape& shape, const MaterialTable& materials, const std::vector<glm::ivec3>& bricks) {
    RegionSet regions;
    for (const glm::ivec3& brick : bricks) regions.insert(brick / 4);
    for (const glm::ivec3& region : regions) {
        removeRegion(region);
        addRegion(shape, materials, region);
    }
}

void StaticShape::addRegion(const Shape& shape, const MaterialTable& materials, glm::ivec3 region) {
    std::vector<CellBox> cells;
    mergeRegion(shape.grid, region, solidEntries(*shape.palette, materials), cells);
    if (cells.empty()) return;
    SurfaceSum surface;
    for (int i = 0; i < 64; ++i)
        if (const Brick* brick = shape.grid.brickAt(region * 4 + glm::ivec3(i & 3, i >> 2 & 3, i >> 4)))
            surface.add(*brick, *shape.palette, materials);

    // A lone box is its own frame: a plain box collides faster than a compound.
    const glm::dvec3 frameCells = cells.size() == 1 ? glm::dvec3(cells[0].low + cells[0].high) * 0.5 : glm::dvec3(region * kRegionSize);
    const glm::dvec3 frame = frameCells * m_voxelSize;
    std::vector<ColliderBox> boxes;
    appendBoxes(cells, m_voxelSize, {-frame, glm::dquat(1, 0, 0, 0)}, boxes);
    auto made = std::make_unique<Region>(boxes);
    btCollisionObject& object = made->object;
    object.setCollisionShape(made->collider.shape());
    object.setWorldTransform(toBullet(Pose{m_pose.transformPoint(frame), m_pose.rotation}, m_origin));
    object.setUserIndex(int(m_body.slot()));
    const Material& material = surface.dominant(materials);
    object.setFriction(std::sqrt(material.friction));  // Bullet multiplies: a pair gets the geometric mean
    object.setRestitution(std::sqrt(material.restitution));
    m_bullet.addResting(object);
    m_boxCount += made->collider.boxCount();
    m_regions.emplace(region, std::move(made));
}

void StaticShape::removeRegion(glm::ivec3 region) {
    const auto found = m_regions.find(region);
    if (found == m_regions.end()) return;
    m_bullet.removeResting(found->second->object);
    m_boxCount -= found->second->collider.boxCount();
    m_regions.erase(found);
}

void StaticShape::brickBounds(glm::ivec3 brick, btVector3& low, btVector3& high) const {
    const double half = 0.5 * kBrickSize * m_voxelSize;
    const glm::dvec3 center = (glm::dvec3(brick) + 0.5) * (kBrickSize * m_voxelSize);
    btTransformAabb(toBullet(glm::dvec3(half)), btScalar(0), toBullet(Pose{m_pose.transformPoint(center), m_pose.rotation}, m_origin), low, high);
}

}  // namespace rubble
