#pragma once
#include <glm/vec3.hpp>

namespace rubble {

/// The place of a brick, as the key of a list: ordered by z, then y, then x.
struct BrickPlace {
    int x, y, z;

    /// Of a brick coordinate.
    explicit BrickPlace(glm::ivec3 brick) : x(brick.x), y(brick.y), z(brick.z) {}
    /// The brick coordinate.
    glm::ivec3 brick() const { return {x, y, z}; }
    friend bool operator==(const BrickPlace&, const BrickPlace&) = default;
    friend bool operator<(const BrickPlace& a, const BrickPlace& b) {
        return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
    }
};

}  // namespace rubble
