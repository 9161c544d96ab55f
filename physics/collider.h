#pragma once
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <memory>
#include <optional>
#include <vector>

#include "physics/box_merge.h"
#include "runtime/core/pose.h"

namespace rubble {

/// A box in its body's frame, metres.
struct ColliderBox {
    Pose place;  ///< of its centre
    glm::dvec3 halfSize;
};

/// Boxes as one Bullet shape: made once, never edited. One box at the frame's origin is a plain btBoxShape, anything else a compound.
class Collider {
public:
    explicit Collider(const std::vector<ColliderBox>& boxes);
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;

    btCollisionShape* shape() { return m_compound ? static_cast<btCollisionShape*>(&*m_compound) : &m_boxes.front(); }
    int boxCount() const { return int(m_boxes.size()); }

private:
    std::vector<btBoxShape> m_boxes;
    std::optional<btCompoundShape> m_compound;
};

/// Boxes of a shape's cells in the frame that `frame` (grid corner -> that frame) leads to.
void appendBoxes(const std::vector<CellBox>& cells, double voxelSize, const Pose& frame, std::vector<ColliderBox>& out);

/// What rubs and bounces: that of the material which makes up most of a body's mass.
class SurfaceSum {
public:
    void add(const Brick& brick, const Palette& palette, const MaterialTable& materials);
    const Material& dominant(const MaterialTable& materials) const;

private:
    std::array<uint64_t, 256> m_weight{};  ///< by material
};

}  // namespace rubble
