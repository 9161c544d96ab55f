#pragma once
#include "physics/collision/occupancy.h"
#include "physics/shapes/surface_features.h"

namespace rubble {

inline constexpr float kMaxSideCosine = 0.1f;  ///< how far a normal may point along a side that a feature sticks out on
inline constexpr float kMaxEdgeCosine = 0.6f;  ///< how far a normal may point along an edge

/// A feature of one shape in the cells of the other.
struct FeatureQuery {
    const FeatureKind* kind;
    glm::vec3 point;     ///< where it is
    glm::vec3 sides[3];  ///< unit vectors that it sticks out along
    int sideCount;
    glm::vec3 along;  ///< of an edge, unit
    float length;     ///< of an edge, cells
    bool isEdge() const { return kind->edgeAxis >= 0; }

    bool accepts(const glm::vec3& normal) const {
        for (int i = 0; i < sideCount; ++i)
            if (glm::dot(normal, sides[i]) > kMaxSideCosine) return false;
        return !isEdge() || std::abs(glm::dot(normal, along)) < kMaxEdgeCosine;
    }
    bool accepts(int axis, float sign) const {
        for (int i = 0; i < sideCount; ++i)
            if (sides[i][axis] * sign > kMaxSideCosine) return false;
        return !isEdge() || std::abs(along[axis]) < kMaxEdgeCosine;
    }
};

/// A face that a feature may rest on.
struct Face {
    int axis = -1;  ///< none
    float sign = 0.0f;
    float separation = 0.0f;  ///< cells
    Cell cell{0};             ///< that it belongs to
};

/// How far a point is from the side of its cell.
inline float distanceToSide(Cell cell, const glm::vec3& p, int axis, int sign) {
    return sign > 0 ? float(cell[axis] + 1) - p[axis] : p[axis] - float(cell[axis]);
}

/// The face through which a point inside the solid gets out the shortestExit: of its own cell, else of a notch that it
/// is in, else straight on. None if it would get out much sooner through a face that the feature does not stick out
/// against: then another feature is in the displacement.
Face nearestExitFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const FeatureQuery& query);
/// How deep a point of a solid cell is behind the nearest exposed side of it; 1.5: none is.
float depthBelowSurface(Occupancy& occupancy, Cell cell, const glm::vec3& p);
/// The closest face within the margin of a point outside the solid.
Face closestFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, float margin, const FeatureQuery& query);
/// The first face through which a point on its displacement comes into the solid: seams inside of it are none.
Face sweepToFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const glm::vec3& displacement,
                 const FeatureQuery& query);
/// The stretch of an edge that is in the solid, in shares of its length from its middle. False: it is outside, or
/// inside as a whole.
bool findSolidInterval(Occupancy& occupancy, const FeatureQuery& query, float& from, float& to);

}  // namespace rubble
