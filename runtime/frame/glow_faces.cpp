#include "runtime/frame/glow_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "runtime/voxel/brick_parts.h"

namespace rubble {
namespace {

constexpr int kPlaneGap = 3;                  ///< voxels between planes of faces from which on each has a rectangle
constexpr double kMinGlowIrradiance = 0.002;  ///< at which a light's reach ends
constexpr double kMaxGlowReach = 40.0;        ///< metres
constexpr float kOwnShadow = 0.15f;           ///< metres that cells of the shadow volume may stand out of the faces

/// The cells of faces that no opaque voxel covers, by direction in the order of kFaceOffsets.
using OpenFaces = std::array<std::vector<glm::ivec3>, 6>;
OpenFaces openFaces(const GlowingVoxels& glow) {
    OpenFaces faces;
    forEachSubset(glow.only, glow.voxels, [&](glm::ivec3 position, const Brick&, const BrickBits& bits) {
        forEachVoxel(bits, [&](int i) {
            const glm::ivec3 cell = glow.corner + position * kBrickSize + voxelInBrick(i);
            for (size_t side = 0; side < faces.size(); ++side) {
                const uint8_t beyond = glow.grid.at(cell + kFaceOffsets[side]);
                if (beyond == 0 || (beyond != glow.entry && glow.palette[beyond].opacity < 255))
                    faces[side].push_back(cell);
            }
        });
    });
    return faces;
}

/// The rectangle of some faces of one direction. Its -z is that direction.
Light rectangleOf(std::span<const glm::ivec3> cells, size_t side, const GlowingVoxels& glow) {
    const int across = int(side / 2), u = (across + 1) % 3, v = (across + 2) % 3;
    const bool isPositive = side % 2 == 1;
    const double count = double(cells.size());
    glm::dvec2 sum(0.0), squares(0.0);
    int plane = cells.front()[across];
    for (const glm::ivec3 cell : cells) {
        const glm::dvec2 at(cell[u] + 0.5, cell[v] + 0.5);
        sum += at, squares += at * at;
        plane = isPositive ? std::max(plane, cell[across]) : std::min(plane, cell[across]);
    }
    const glm::dvec2 middle = sum / count;
    // The variance of a rectangle's points along a side of length s is s^2 / 12; each face adds that of its own.
    glm::dvec2 sides = glm::sqrt(12.0 * glm::max(squares / count - middle * middle, 0.0) + 1.0);
    sides *= std::sqrt(count / (sides.x * sides.y));

    Light light{.kind = LightKind::Area};
    light.local.position[across] = (plane + isPositive) * glow.voxelSize;
    light.local.position[u] = middle.x * glow.voxelSize, light.local.position[v] = middle.y * glow.voxelSize;
    glm::dmat3 axes(0.0);
    axes[2][across] = isPositive ? -1.0 : 1.0;
    axes[0][u] = 1.0;
    axes[1] = glm::cross(axes[2], axes[0]);
    light.local.rotation = glm::normalize(glm::quat_cast(axes));
    light.width = float(sides.x * glow.voxelSize), light.height = float(sides.y * glow.voxelSize);
    light.radius = kOwnShadow;
    const PaletteEntry& entry = glow.palette[glow.entry];
    const glm::vec3 color(srgbToLinear(entry.red), srgbToLinear(entry.green), srgbToLinear(entry.blue));
    light.color = color * entry.emission * float(count * glow.voxelSize * glow.voxelSize);
    const double brightest = std::max({light.color.x, light.color.y, light.color.z});
    light.reach = float(std::min(std::sqrt(brightest / kMinGlowIrradiance), kMaxGlowReach));
    clampToRanges(light);
    return light;
}

}  // namespace

std::vector<Light> glowingFaces(const GlowingVoxels& glow, float minIntensity) {
    std::vector<Light> lights;
    OpenFaces faces = openFaces(glow);
    for (size_t side = 0; side < faces.size(); ++side) {
        std::vector<glm::ivec3>& cells = faces[side];
        const int across = int(side / 2);
        std::stable_sort(cells.begin(), cells.end(), [&](glm::ivec3 a, glm::ivec3 b) { return a[across] < b[across]; });
        for (size_t first = 0, next = 0; first < cells.size(); first = next) {
            while (++next < cells.size() && cells[next][across] - cells[next - 1][across] < kPlaneGap) {
            }
            lights.push_back(rectangleOf(std::span(cells).subspan(first, next - first), side, glow));
            const glm::vec3 color = lights.back().color;
            if (std::max({color.x, color.y, color.z}) < minIntensity) lights.pop_back();
        }
    }
    return lights;
}

}  // namespace rubble
