#include "runtime/world/state/fires.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/random.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {
namespace {

constexpr double kLightCellSize = 1.6;  ///< metres: fires in the same cube of a grid share a light
constexpr int kFlickerSteps = 5;        ///< between two random values of a flicker
constexpr float kFlickerDepth = 0.35f;  ///< share of the intensity
constexpr float kRampUpdates = 20.0f;   ///< heat updates of a brick until its fire has its full intensity
constexpr float kFullFuel = 64.0f;      ///< voxels of a brick from which on its fire has its full intensity

/// The centroid of a brick's solid cells, in the shape's cells, and their number.
std::pair<glm::dvec3, int> brickCentroid(const Brick& brick, glm::ivec3 position) {
    glm::ivec3 sum(0);
    int count = 0;
    forEachVoxel(brick.occupancy, [&](int i) { sum += voxelInBrick(i), ++count; });
    return {glm::dvec3(position * kBrickSize) + glm::dvec3(sum) / double(std::max(count, 1)) + 0.5, count};
}

/// 1 - kFlickerDepth to 1: random values at intervals, interpolated between.
float flicker(uint32_t seed, uint64_t step) {
    const auto value = [&](uint64_t n) { return float(hashCell(int(n), 0, 0, seed) & 255) / 255.0f; };
    const uint64_t n = step / kFlickerSteps;
    const float part = float(step % kFlickerSteps) / kFlickerSteps;
    return 1.0f - kFlickerDepth * (value(n) * (1.0f - part) + value(n + 1) * part);
}

}  // namespace

std::vector<Fire> findFires(const WorldState& world) {
    std::vector<Fire> out;
    out.reserve(world.fire.burning);
    for (const HeatField& field : world.fire.fields) {
        const Shape* shape = world.shapes.find(field.shape);
        if (!shape) continue;
        const Pose pose = shapeToWorld(world, field.shape);
        for (const HotBrick& hot : field.bricks) {
            const Brick* brick = hot.burningFor ? shape->grid.brickAt(hot.brick) : nullptr;
            if (!brick) continue;
            const auto [centroid, count] = brickCentroid(*brick, hot.brick);
            const float ramp = std::min(1.0f, float(hot.burningFor) / kRampUpdates),
                        fuel = std::min(1.0f, float(count) / kFullFuel);
            const uint32_t seed = hashCell(hot.brick.x, hot.brick.y, hot.brick.z, field.shape.slot());
            out.push_back({field.shape, hot.brick, pose.transformPoint(centroid * double(shape->voxelSize)),
                           4.0 * shape->voxelSize, ramp * fuel, seed});
        }
    }
    return out;
}

std::vector<FireLight> fireLights(const std::vector<Fire>& fires, uint64_t step, size_t limit) {
    struct Group {
        glm::dvec3 cube;
        glm::dvec3 sum{0.0};
        double intensity = 0.0, radius = 0.0;
    };
    const auto before = [](const Group& group, glm::dvec3 at) {
        return group.cube.x != at.x   ? group.cube.x < at.x
               : group.cube.y != at.y ? group.cube.y < at.y
                                      : group.cube.z < at.z;
    };
    std::vector<Group> groups;
    for (const Fire& fire : fires) {
        const glm::dvec3 cube = glm::floor(fire.position / kLightCellSize);
        auto group = std::lower_bound(groups.begin(), groups.end(), cube, before);
        if (group == groups.end() || group->cube != cube) group = groups.insert(group, {cube});
        group->sum += fire.position * double(fire.intensity);
        group->intensity += double(fire.intensity);
        group->radius = std::max(group->radius, fire.radius);
    }
    std::erase_if(groups, [](const Group& group) { return group.intensity <= 0.0; });
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.intensity > b.intensity; });
    if (groups.size() > limit) groups.resize(limit);
    std::vector<FireLight> out;
    for (const Group& group : groups) {
        const uint32_t seed = hashCell(int(group.cube.x), int(group.cube.y), int(group.cube.z));
        out.push_back({group.sum / group.intensity, float(group.intensity) * flicker(seed, step), group.radius});
    }
    return out;
}

double remainingStrength(const WorldState& world, ShapeHandle handle, glm::ivec3 brick) {
    const HotBrick* hot = world.fire.find(handle, brick);
    if (!hot) return 1.0;
    const Shape& shape = world.shapes.at(handle);
    const HeatTable table =
        makeHeatTable(*shape.palette, world.materials, double(shape.voxelSize), double(world.settings.fire.burnTime));
    return remainingStrength(*hot, heatSkin(shape.grid, brick, table)) / 256.0;
}

}  // namespace rubble
