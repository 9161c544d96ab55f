#include "runtime/world/level/fit_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "runtime/core/constants.h"
#include "runtime/core/log.h"
#include "runtime/voxel/brick_parts.h"
#include "runtime/voxel/mass_properties.h"

namespace rubble {
namespace {

constexpr double kRodRatio = 2.5;                    ///< longest to middle side from which on a component is a rod
constexpr double kPlateRatio = 2.5;                  ///< middle to thinnest side from which on it is a plate
constexpr double kMinIrradiance = 0.02;              ///< irradiance at which a light's reach ends
constexpr double kMinReach = 1.0, kMaxReach = 15.0;  ///< metres
constexpr float kAreaClearance = 0.07f;              ///< metres that an area's radius is larger than half its thickness

/// The grid with the voxels of one entry alone.
VoxelGrid onlyEntry(const VoxelGrid& grid, size_t entry) {
    VoxelGrid out(grid.size());
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        BrickBits keep{};
        forEachVoxel(brick->occupancy, [&](int i) {
            if (brick->at(i) == entry) setVoxel(keep, i);
        });
        out.setBrick(position, maskBrick(*brick, keep));
    });
    return out;
}

/// Number of faces between voxels of the component and other cells.
uint64_t countFaces(const VoxelGrid& only, const Component& voxels) {
    uint64_t faces = 0;
    forEachSubset(only, voxels, [&](glm::ivec3 position, const Brick&, const BrickBits& bits) {
        forEachVoxel(bits, [&](int i) {
            for (const glm::ivec3 step : kFaceOffsets)
                faces += only.at(position * kBrickSize + voxelInBrick(i) + step) == 0;
        });
    });
    return faces;
}

void recolour(VoxelGrid& grid, const VoxelGrid& only, const Component& voxels, uint8_t entry) {
    forEachSubset(only, voxels, [&](glm::ivec3 position, const Brick&, const BrickBits& bits) {
        const BrickRef brick = grid.shareBrick(position);
        BrickIndices indices;
        expandBrick(brick.get(), indices);
        forEachVoxel(bits, [&](int i) { indices[size_t(i)] = entry; });
        grid.setBrick(position, makeBrick(indices, brick->paint.get()));
    });
}

/// The last entry without a material and without voxels; 0 if there is none.
uint8_t freeEntry(const Palette& palette, const UsedEntries& used) {
    for (size_t i = 255; i > 0; --i)
        if (palette[i].material == 0 && !used.contains(i)) return uint8_t(i);
    return 0;
}

void fitShape(Level& level, LevelShape& shape) {
    Palette palette = *shape.palette;
    const UsedEntries usedBefore = usedEntries(shape.grid);
    for (size_t entry = 1; entry < 256; ++entry) {
        const PaletteEntry glow = palette[entry];
        if (glow.material == 0 || glow.emission <= 0.0f || glow.lightGroup) continue;
        const VoxelGrid only = onlyEntry(shape.grid, entry);
        for (const Component& voxels : findComponents(only)) {
            if (level.lightGroups.size() >= level.autoLightGroups)
                return logWarning(
                           "the level's glowing voxels need more light groups than its auto_light_groups allows; the "
                           "others get none"),
                       void(shape.palette = std::make_shared<const Palette>(palette));
            const uint8_t own = palette[entry].lightGroup ? freeEntry(palette, usedBefore) : uint8_t(entry);
            const size_t used = own ? own : entry;
            if (own && own != entry) palette[own] = glow, recolour(shape.grid, only, voxels, own);
            if (own) {
                level.lightGroups.push_back({.name = shape.name + " glow " + std::to_string(level.lightGroups.size())});
                palette[used].lightGroup = uint32_t(level.lightGroups.size());
            }
            level.lights.push_back({fitLight(shape, only, voxels, glow), shape.name,
                                    level.lightGroups[palette[used].lightGroup - 1].name});
        }
    }
    shape.palette = std::make_shared<const Palette>(palette);
}

}  // namespace

Light fitLight(const LevelShape& shape, const VoxelGrid& only, const Component& voxels, const PaletteEntry& entry) {
    MassMoments moments;
    forEachSubset(only, voxels, [&](glm::ivec3 brick, const Brick&, const BrickBits& bits) {
        forEachVoxel(bits, [&](int i) { moments.add(brick * kBrickSize + voxelInBrick(i), 1); });
    });
    const MassProperties mass = massProperties(moments, shape.voxelSize);
    // A box of these sides has the same principal inertia: I_x = m (y^2 + z^2) / 12.
    const glm::dvec3 inertia = mass.principalInertia * (6.0 / mass.mass);
    const double sum = inertia.x + inertia.y + inertia.z;
    std::array<std::pair<double, int>, 3> sides;
    for (int i = 0; i < 3; ++i) sides[size_t(i)] = {std::sqrt(std::max(sum - 2.0 * inertia[i], 0.0)), i};
    std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first > b.first; });

    const glm::dmat3 axes = glm::mat3_cast(mass.principalAxes);
    const glm::dvec3 x = axes[sides[0].second], z = axes[sides[2].second];
    Light light{.name = shape.name + " glow"};
    light.local = {mass.center, glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)))};
    const double length = sides[0].first, breadth = sides[1].first, thickness = sides[2].first;
    if (length > kRodRatio * breadth)
        light.kind = LightKind::Capsule;
    else if (breadth > kPlateRatio * thickness)
        light.kind = LightKind::Area, light.twoSided = true;
    // The mean projected area of a convex body is a quarter of its surface (Cauchy).
    const double projectedArea =
        0.25 * double(countFaces(only, voxels)) * double(shape.voxelSize) * double(shape.voxelSize);
    light.radius = float(std::sqrt(projectedArea / kPi));
    const glm::vec3 color(srgbToLinear(entry.red), srgbToLinear(entry.green), srgbToLinear(entry.blue));
    light.color = color * (entry.emission * float(projectedArea));
    if (light.kind == LightKind::Capsule) {
        light.radius = float(std::sqrt(breadth * thickness / kPi));
        light.width = std::max(float(length) - 2.0f * light.radius, 0.0f);
    }
    if (light.kind == LightKind::Area) {
        light.width = float(length), light.height = float(breadth);
        light.radius = float(0.5 * thickness) + kAreaClearance;  // clear of its own voxels
        light.color *= 2.0f;                                     // along -z it shows twice its mean over all directions
    }
    const double brightest = std::max({light.color.x, light.color.y, light.color.z});
    light.reach = float(std::clamp(std::sqrt(brightest / kMinIrradiance), kMinReach, kMaxReach));
    clampToRanges(light);
    return light;
}

void fitLights(Level& level) {
    for (LevelBody& body : level.bodies)
        for (LevelShape& shape : body.shapes) {
            const auto glows = [](const PaletteEntry& entry) {
                return entry.material && entry.emission > 0.0f && !entry.lightGroup;
            };
            if (!shape.hidden && !shape.grid.empty() && shape.palette &&
                std::any_of(shape.palette->begin(), shape.palette->end(), glows))
                fitShape(level, shape);
        }
}

}  // namespace rubble
