#include "runtime/world/state/fire_state.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/hash.h"
#include "runtime/core/random.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

constexpr double kLightCellSize = 1.6;  // metres: fires in the same cube of this size share a light
constexpr int kFlickerSteps = 5;        // between two of the values that a flicker runs through
constexpr float kFlickerDepth = 0.35f;

auto findField(std::vector<HeatField>& fields, ShapeHandle shape) {
    return std::lower_bound(fields.begin(), fields.end(), shape.slot(),
                            [](const HeatField& field, uint32_t slot) { return field.shape.slot() < slot; });
}
auto findBrick(std::vector<HotBrick>& bricks, glm::ivec3 brick) {
    return std::lower_bound(bricks.begin(), bricks.end(), brick,
                            [](const HotBrick& hot, glm::ivec3 at) { return cellBefore(hot.brick, at); });
}

/// The mean of a brick's solid cells, in the shape's cells, and their number.
std::pair<glm::dvec3, int> brickCentroid(const Brick& brick, glm::ivec3 position) {
    glm::ivec3 sum(0);
    int count = 0;
    forEachVoxel(brick.occupancy, [&](int i) { sum += voxelInBrick(i), ++count; });
    return {glm::dvec3(position * kBrickSize) + glm::dvec3(sum) / double(std::max(count, 1)) + 0.5, count};
}

/// 1 - kFlickerDepth to 1, smooth over steps.
float flicker(uint32_t seed, uint64_t step) {
    const auto value = [&](uint64_t n) { return float(hashCell(int(n), 0, 0, seed) & 255) / 255.0f; };
    const uint64_t n = step / kFlickerSteps;
    const float part = float(step % kFlickerSteps) / kFlickerSteps;
    return 1.0f - kFlickerDepth * (value(n) * (1.0f - part) + value(n + 1) * part);
}

}  // namespace

HotBrick* FireState::find(ShapeHandle shape, glm::ivec3 brick) {
    const auto field = findField(fields, shape);
    if (field == fields.end() || field->shape != shape) return nullptr;
    const auto place = findBrick(field->bricks, brick);
    return place != field->bricks.end() && place->brick == brick ? &*place : nullptr;
}
const HotBrick* FireState::find(ShapeHandle shape, glm::ivec3 brick) const {
    return const_cast<FireState*>(this)->find(shape, brick);
}

HotBrick* FireState::findOrAdd(ShapeHandle shape, glm::ivec3 brick, uint32_t limit) {
    if (HotBrick* found = find(shape, brick)) return found;
    if (hotBricks >= limit) return nullptr;
    auto field = findField(fields, shape);
    if (field == fields.end() || field->shape.slot() != shape.slot()) field = fields.insert(field, {shape, {}});
    if (field->shape != shape) *field = {shape, {}};  // of a shape that is gone
    ++hotBricks;
    return &*field->bricks.insert(findBrick(field->bricks, brick), HotBrick{.brick = brick});
}

void FireState::compact() {
    std::erase_if(fields, [](const HeatField& field) { return field.bricks.empty(); });
    hotBricks = burning = 0;
    for (const HeatField& field : fields) {
        hotBricks += uint32_t(field.bricks.size());
        for (const HotBrick& brick : field.bricks) burning += brick.burningFor > 0;
    }
}

uint64_t FireState::hash() const {
    uint64_t hash = 0;
    for (const HeatField& field : fields) {
        hash = hashValue(field.shape.slot(), hash);
        for (const HotBrick& hot : field.bricks) {
            const int64_t values[] = {hot.brick.x, hot.brick.y,    hot.brick.z, hot.heat,
                                      hot.burned,  hot.burningFor, hot.wet,     hot.charred};
            hash = hashBytes(values, sizeof values, hash);
        }
    }
    return hash;
}

std::vector<Fire> World::fires() const {
    std::vector<Fire> out;
    out.reserve(m_fire.burning);
    for (const HeatField& field : m_fire.fields) {
        const Shape* shape = m_shapes.find(field.shape);
        if (!shape) continue;
        const Pose pose = shapeToWorld(field.shape);
        for (const HotBrick& hot : field.bricks) {
            const Brick* brick = hot.burningFor ? shape->grid.brickAt(hot.brick) : nullptr;
            if (!brick) continue;
            const auto [centroid, count] = brickCentroid(*brick, hot.brick);
            const float ramp = std::min(1.0f, float(hot.burningFor) / 20.0f),
                        fuel = std::min(1.0f, float(count) / 64.0f);
            const uint32_t seed = hashCell(hot.brick.x, hot.brick.y, hot.brick.z, field.shape.slot());
            out.push_back({field.shape, hot.brick, pose.transformPoint(centroid * double(shape->voxelSize)),
                           4.0 * shape->voxelSize, ramp * fuel, seed});
        }
    }
    return out;
}

std::optional<Fire> World::closestFire(glm::dvec3 position, double maxDistance) const {
    std::optional<Fire> best;
    double nearest = maxDistance * maxDistance;
    for (const Fire& fire : fires()) {
        const glm::dvec3 away = fire.position - position;
        if (!(glm::dot(away, away) <= nearest)) continue;
        nearest = glm::dot(away, away);
        best = fire;
    }
    return best;
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

double World::remainingStrength(ShapeHandle handle, glm::ivec3 brick) const {
    const HotBrick* hot = m_fire.find(handle, brick);
    if (!hot) return 1.0;
    const Shape& shape = m_shapes.at(handle);
    const HeatTable table =
        makeHeatTable(*shape.palette, m_materials, double(shape.voxelSize), double(m_settings.fire.burnTime));
    return rubble::remainingStrength(*hot, heatSkin(shape.grid, brick, table)) / 256.0;
}

}  // namespace rubble
