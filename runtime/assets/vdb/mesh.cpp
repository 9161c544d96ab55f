#include "runtime/assets/vdb/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "runtime/voxel/palette.h"

namespace rubble {

glm::vec3 MeshTexture::at(glm::vec2 place, bool isSmooth) const {
    const auto pixel = [&](int x, int y) {
        const auto wrap = [](int value, int count) { return (value % count + count) % count; };
        const auto& bytes = pixels[size_t(wrap(y, size.y)) * size_t(size.x) + size_t(wrap(x, size.x))];
        return glm::vec3(srgbToLinear(bytes[0]), srgbToLinear(bytes[1]), srgbToLinear(bytes[2]));
    };
    const glm::vec2 at = glm::fract(place) * glm::vec2(size);
    if (!isSmooth) return pixel(int(at.x), int(at.y));
    const glm::vec2 low = glm::floor(at - 0.5f), part = at - 0.5f - low;
    const int x = int(low.x), y = int(low.y);
    return glm::mix(glm::mix(pixel(x, y), pixel(x + 1, y), part.x),
                    glm::mix(pixel(x, y + 1), pixel(x + 1, y + 1), part.x), part.y);
}

glm::vec3 Mesh::colorOf(const MeshTriangle& triangle, glm::dvec3 weights, bool isSmooth) const {
    const MeshMaterial& material = materials[triangle.material];
    glm::vec3 color(0.0f);
    glm::vec2 place(0.0f);
    for (int c = 0; c < 3; ++c) {
        color += triangle.colors[size_t(c)] * float(weights[c]);
        place += triangle.places[size_t(c)] * float(weights[c]);
    }
    if (material.texture >= 0) color *= textures[size_t(material.texture)].at(place, isSmooth);
    return color * material.color;
}

std::string Mesh::lossNote(double length) const {
    double distance = 0.0;
    for (const glm::dvec3& each : points)
        for (int a = 0; a < 3; ++a) distance = std::max(distance, std::abs(each[a]));
    const double apart = std::nextafter(float(distance), std::numeric_limits<float>::max()) - distance;
    if (!(apart > length)) return "";
    return fmt::format(
        "coordinates are read as numbers of 32 bits, which are {:g} m apart at the {:.3g} m that the mesh lies away: "
        "move it nearer to the origin",
        apart, distance);
}

}  // namespace rubble
