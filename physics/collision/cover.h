#pragma once
#include <array>
#include <optional>
#include <vector>

#include "physics/collision/occupancy.h"
#include "physics/shapes/cell_transform.h"

namespace rubble {

/// The solids around a part, in its cells. What they lie against is inside of the whole that they make with it: an
/// internal face, or an internal edge. One per thread and part.
class Cover {
public:
    /// Adds a solid to what lies around a part. Both cell transforms are about one origin; the solid must outlive it.
    void add(const ColliderPart& solid, const CellTransform& solidCells, const CellTransform& partCells);
    /// Whether nothing was added.
    bool empty() const { return m_count == 0; }
    /// Whether a point in cells of the part is inside one of the solids.
    bool contains(const glm::vec3& point);
    /// Whether something lies against the side (sign * axis) of a cell of the part, beside the point p.
    bool covers(Cell cell, const glm::vec3& p, int axis, int sign);

private:
    struct Solid {
        Occupancy occupancy;
        glm::mat3 axes;    ///< of the part's cells, in cells of the solid
        glm::vec3 corner;  ///< of the part's cell (0, 0, 0), in cells of the solid
    };
    std::array<std::optional<Solid>, 8> m_first;  ///< so few take no memory; a cover lives for one pair and step
    std::vector<Solid> m_more;
    size_t m_count = 0;
};

/// A part, where it is and what lies around it.
struct CoveredPart {
    const ColliderPart& part;
    const CellTransform& cells;  ///< about the first body's frame origin
    Cover* cover = nullptr;      ///< null: nothing lies around it
};

/// Distance in cells from a surface to where it is asked whether something lies against it; smaller gaps and steps
/// count as none.
inline constexpr float kSeam = 0.05f;

}  // namespace rubble
