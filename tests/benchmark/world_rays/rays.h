#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/world_rays/world_bits.h"

namespace rubble::rays {

inline constexpr glm::ivec2 kImageSize(640, 360);  ///< pixels: one ray each

/// A ray in cells of a WorldBits.
struct Ray {
    glm::vec3 origin{0.0f};
    float maxDistance = -1.0f;  ///< negative: no ray
    glm::vec3 direction{0.0f};
};
/// One ray for each pixel of an image, and the reference answers.
struct RaySet {
    std::string name;
    std::vector<Ray> rays;
    std::vector<uint8_t> stopped;
    size_t count = 0;
};

struct RayView {
    std::string name;
    glm::dvec3 eye, along;  ///< in cells of a WorldBits
};

enum class RayKind { Ambient, Sun, Local };
/// Rays from every surface in a view: `maxDistance` cells over the cosine-weighted hemisphere, to the sun, or to the
/// nearest of lights that hang every 12.8 m. The reference is a plain walk in double, cell by cell.
RaySet makeRays(const WorldBits& bits, const RayView& view, RayKind kind, double maxDistance = 240.0);
/// Computes the reference answers of `set` in another volume, whose cell 0 lies `shift` cells below that of the rays.
void findReference(const WorldBits& bits, RaySet& set, glm::ivec3 shift = glm::ivec3(0));
/// True if the answer in double changes when the ray is moved by a thousandth of a cell. It grazes an edge then, and a
/// walk in float may differ.
bool isGrazing(const WorldBits& bits, const Ray& ray, glm::ivec3 shift);

}  // namespace rubble::rays
