#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/world_box.h"
#include "runtime/world/objects/ground_polygon.h"

namespace rubble {

/// How waves look. Buoyancy knows a flat surface only.
struct WaterWaves {
    float height = 0.03f;    ///< metres, crest above the flat surface
    float length = 2.0f;     ///< metres
    float speed = 0.6f;      ///< m/s
    float direction = 0.0f;  ///< radians from +x toward +z
    friend bool operator==(const WaterWaves&, const WaterWaves&) = default;
};

/// A body of water under a flat surface: bodies in it float or sink, and fires go out. World space, metres.
struct Water {
    std::string name;
    GroundPolygon outline;
    double surface = 0.0;      ///< height of the surface
    double depth = 1.0;        ///< below the surface
    double density = 1000.0;   ///< kg/m3
    double linearDrag = 1.5;   ///< 1/s, at which a body takes up the flow, for the mass of the water that it displaces
    double angularDrag = 1.5;  ///< 1/s, the same for its spin
    glm::dvec3 flow{0.0};      ///< m/s
    glm::vec3 color{0.1f, 0.35f, 0.4f};  ///< linear: share of light that is left after `clarity` metres
    float clarity = 3.0f;                ///< metres
    WaterWaves waves;

    /// Whether a world position is under water.
    bool contains(glm::dvec3 point) const {
        return point.y <= surface && point.y >= surface - depth && rubble::contains(outline, point.x, point.z);
    }
    /// A hash of all that decides what happens; how the water looks is not in it.
    uint64_t hash() const;
    /// The smallest world box around it.
    WorldBox bounds() const {
        WorldBox box{{1e30, surface - depth, 1e30}, {-1e30, surface, -1e30}};
        for (const GroundPoint& p : outline) {
            box.low = glm::min(box.low, {p.x, box.low.y, p.z});
            box.high = glm::max(box.high, {p.x, box.high.y, p.z});
        }
        return box;
    }
};

}  // namespace rubble
