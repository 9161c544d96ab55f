#pragma once
#include "physics/collision/occupancy.h"
#include "physics/shapes/surface_features.h"

namespace rubble {

/// Cosine up to which a normal may point along a direction in which a feature sticks out.
inline constexpr float kMaxSideCosine = 0.1f;
/// Cosine up to which a normal may point along an edge.
inline constexpr float kMaxEdgeCosine = 0.6f;

/// A feature (corner or edge) of one shape, in the cells of the other.
struct FeatureQuery {
    const FeatureKind* kind;
    glm::vec3 point;     ///< the corner, or the middle of the edge
    glm::vec3 sides[3];  ///< unit vectors along which it sticks out
    int sideCount;
    glm::vec3 along;       ///< unit vector along an edge
    float length;          ///< of an edge, cells
    uint32_t covered = 0;  ///< bit i: something lies against the shape on side i
    /// Whether it is an edge; if not, it is a corner.
    bool isEdge() const { return kind->edgeAxis >= 0; }

    /// Whether the feature can rest on a surface of this normal: it must stick out against the normal, an edge must
    /// lie roughly across it, and the normal must not come from a side that is covered.
    bool accepts(const glm::vec3& normal) const {
        for (int i = 0; i < sideCount; ++i)
            if (isBarred(i, glm::dot(normal, sides[i]))) return false;
        return !isEdge() || std::abs(glm::dot(normal, along)) < kMaxEdgeCosine;
    }
    /// The same for the normal sign * (unit vector of the axis).
    bool accepts(int axis, float sign) const {
        for (int i = 0; i < sideCount; ++i)
            if (isBarred(i, sides[i][axis] * sign)) return false;
        return !isEdge() || std::abs(along[axis]) < kMaxEdgeCosine;
    }

private:
    /// Whether a normal of this cosine with side i is out of the question.
    bool isBarred(int i, float cosine) const {
        return cosine > kMaxSideCosine || (cosine < -kMaxSideCosine && covered >> i & 1);
    }
};

/// A face of a cell that a feature may rest on.
struct Face {
    int axis = -1;            ///< of the normal; -1: there is none
    float sign = 0.0f;        ///< of the normal
    float separation = 0.0f;  ///< of the queried point along the normal, cells; negative inside the solid
    Cell cell{0};             ///< that it belongs to
};

/// The distance of a point from the side (sign * axis) of its cell, in cells, 0 to 1.
inline float distanceToSide(Cell cell, const glm::vec3& p, int axis, int sign) {
    return sign > 0 ? float(cell[axis] + 1) - p[axis] : p[axis] - float(cell[axis]);
}

/// The face through which a point p in a solid cell gets out the soonest: a face of its cell, else one of a notch that
/// it is in, else one straight on within a few cells. None if the point is much closer to a face that the feature does
/// not accept: then the contact belongs to another feature.
Face nearestExitFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const FeatureQuery& query);
/// The depth of a point in a solid cell below the nearest exposed side of the cell, in cells; 1.5 if none is exposed.
float depthBelowSurface(Occupancy& occupancy, Cell cell, const glm::vec3& p);
/// The closest face within `margin` cells of a point p in an empty cell.
Face closestFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, float margin, const FeatureQuery& query);
/// The first face through which a point that moves from p by `displacement` (cells) goes from an empty cell into a
/// solid one. None if it meets none, or one that the feature does not accept.
Face sweepToFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const glm::vec3& displacement,
                 const FeatureQuery& query);
/// The fraction of the displacement (cells) at which a point that moves from p, in an empty cell, enters a solid one;
/// above 1: it enters none.
float timeOfEntry(Occupancy& occupancy, const glm::vec3& p, const glm::vec3& displacement);
/// The first interval of an edge that is inside the solid, in fractions of its length from its middle, -0.5 to 0.5.
/// False: the edge is all outside or all inside.
bool findSolidInterval(Occupancy& occupancy, const FeatureQuery& query, float& from, float& to);

}  // namespace rubble
