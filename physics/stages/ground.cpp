#include "physics/stages/ground.h"

namespace rubble {
namespace {

constexpr uint32_t kFirstNumber = 0xffffff00u;  ///< of the objects: above those of all shapes

/// A slab as a shape of World would be, of dirt whatever the level's materials are.
Shape shapeOf(const GroundSlab& slab) {
    Palette palette{};
    palette[1].material = defaultMaterials().find("dirt");
    Shape shape;
    shape.voxelSize = float(slab.side);
    shape.palette = std::make_shared<const Palette>(palette);
    shape.grid = VoxelGrid({slab.cubes.x, 1, slab.cubes.y});
    GridWriter cubes(shape.grid);
    for (int z = 0; z < slab.cubes.y; ++z)
        for (int x = 0; x < slab.cubes.x; ++x) cubes.set({x, 0, z}, 1);
    cubes.flush();
    return shape;
}

}  // namespace

void Ground::update(const World& world, PhysicsBodies& bodies, bool wakes) {
    const GroundSlabs slabs = groundSlabs(world.data());
    if (slabs == m_slabs) return;
    for (const auto& object : m_objects) {
        bodies.broadphase().remove(*object);
        if (wakes) bodies.wakeTouching(object->low, object->high);
    }
    m_objects.clear();
    m_slabs = slabs;
    for (const GroundSlab& slab : m_slabs) {
        auto object = std::make_unique<CollisionObject>();
        object->collider.parts.push_back(std::make_unique<ColliderPart>(shapeOf(slab), Pose{}, defaultMaterials()));
        object->setPose({slab.low});
        object->body = kNoBody;
        object->number = kFirstNumber + uint32_t(m_objects.size());
        bodies.broadphase().add(*object, false);
        if (wakes) bodies.wakeTouching(object->low, object->high);
        m_objects.push_back(std::move(object));
    }
}

}  // namespace rubble
