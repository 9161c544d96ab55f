#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/world_rays/world_bits.h"

namespace rubble::rays {

inline constexpr glm::ivec2 kImageSize(640, 360);

/// In cells of the bits.
struct Ray {
    glm::vec3 origin{0.0f};
    float maxDistance = -1.0f;  ///< negative: no ray
    glm::vec3 direction{0.0f};
};
/// One ray a pixel of a picture, and the truth about each.
struct RaySet {
    std::string name;
    std::vector<Ray> rays;
    std::vector<uint8_t> stopped;
    size_t count = 0;
};

struct RayView {
    std::string name;
    glm::dvec3 eye, along;  ///< cells of the bits
};

enum class RayKind { Ambient, Sun, Local };
/// From every surface that a view sees: `maxDistance` cells over the cosine-weighted hemisphere, to the sun, or to the
/// nearest of lamps that hang every 12.8 m. The truth is a plain walk in doubles, cell by cell.
RaySet makeRays(const WorldBits& bits, const RayView& view, RayKind kind, double maxDistance = 240.0);
/// The truth of `set` in another volume, whose cell 0 lies `shift` cells below that of the rays.
void findReference(const WorldBits& bits, RaySet& set, glm::ivec3 shift = glm::ivec3(0));
/// True if the ray's answer in doubles changes when the ray is moved by a thousandth of a cell: it grazes, and floats
/// may differ.
bool isGrazing(const WorldBits& bits, const Ray& ray, glm::ivec3 shift);

}  // namespace rubble::rays
