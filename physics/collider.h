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

struct Bounds {
    btVector3 low{0, 0, 0}, high{0, 0, 0};
    /// Without branches: most answers are no, in no pattern.
    bool meets(const Bounds& o) const {
        return (int(low.x() <= o.high.x()) & int(high.x() >= o.low.x()) & int(low.y() <= o.high.y()) & int(high.y() >= o.low.y()) &
                int(low.z() <= o.high.z()) & int(high.z() >= o.low.z())) != 0;
    }
    void include(const Bounds& o) {
        low.setMin(o.low);
        high.setMax(o.high);
    }
    /// Bounds of these bounds after a transform.
    Bounds seenThrough(const btTransform& transform) const;
};

/// Boxes as one Bullet shape: made once, never edited. One box at the frame's origin is a plain btBoxShape, anything else a
/// compound (without Bullet's tree: BoxCollision reads the parts).
class Collider {
public:
    struct Part {
        btTransform place;
        const btBoxShape* box;
    };

    explicit Collider(const std::vector<ColliderBox>& boxes);
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;

    btCollisionShape* shape() { return m_compound ? static_cast<btCollisionShape*>(&*m_compound) : &m_boxes.front(); }
    /// The collider that a shape belongs to.
    static const Collider& of(const btCollisionShape& shape) { return *static_cast<const Collider*>(shape.getUserPointer()); }
    int boxCount() const { return int(m_boxes.size()); }
    const Part& part(int i) const { return m_parts[size_t(i)]; }
    /// Of a part and of all parts, in the collider's frame.
    const Bounds& bounds(int i) const { return m_bounds[size_t(i)]; }
    const Bounds& bounds() const { return m_all; }

private:
    std::vector<btBoxShape> m_boxes;
    std::vector<Part> m_parts;
    std::vector<Bounds> m_bounds;
    Bounds m_all;
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
