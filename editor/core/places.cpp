#include "editor/core/places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "editor/core/joints.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

constexpr double kReach = 1000.0;  ///< metres
constexpr double kMargin = 0.005;  ///< of a voxel, by which a box that is cast is smaller: it touches none beside it
constexpr double kIsAlong = 1e-3;  ///< least part of the way down along an axis of a grid

/// The shape that a light is on; 0: none.
Place baseOf(const rubble::World& world, const rubble_light_settings& light) {
    if (!light.shape) return {};
    const rubble_shape_state shape = world.get_shape_state(light.shape);
    return {vectorOf(shape.position), quaternionOf(shape.rotation)};
}

/// Adds rows of the voxels of a shape that nothing of it is below, as boxes that are cast down.
class Undersides {
public:
    explicit Undersides(const rubble::World& world) : m_world(world) {}

    void add(const rubble_shape_state& shape) {
        const Cells grid = gridOf(m_world, shape.shape);
        const std::vector<uint8_t> voxels = readCells(m_world, shape.shape, grid);
        const glm::dvec3 down = glm::inverse(quaternionOf(shape.rotation)) * glm::dvec3(0, -1, 0);
        const auto isSolid = [&](glm::ivec3 cell) {
            if (!grid.contains(cell)) return false;
            const glm::ivec3 c = cell - grid.low;
            return voxels[(size_t(c.z) * size_t(grid.size.y) + size_t(c.y)) * size_t(grid.size.x) + size_t(c.x)] != 0;
        };
        const auto isUnderside = [&](glm::ivec3 cell) {
            for (int a = 0; a < 3; ++a) {
                glm::ivec3 next = cell;
                next[a] += down[a] > 0.0 ? 1 : -1;
                if (std::abs(down[a]) > kIsAlong && !isSolid(next)) return isSolid(cell);
            }
            return false;
        };
        glm::ivec3 cell;
        for (cell.z = grid.low.z; cell.z < grid.low.z + grid.size.z; ++cell.z)
            for (cell.y = grid.low.y; cell.y < grid.low.y + grid.size.y; ++cell.y)
                for (cell.x = grid.low.x; cell.x < grid.low.x + grid.size.x; ++cell.x) {
                    if (!isUnderside(cell)) continue;
                    const glm::ivec3 from = cell;
                    while (isUnderside(cell + glm::ivec3(1, 0, 0))) ++cell.x;
                    addRow(shape, from, cell.x - from.x + 1);
                }
    }

    std::vector<rubble_shape_cast> casts;
    double lowest = std::numeric_limits<double>::max();  ///< height of all of them
    double voxel = 0.0;                                  ///< metres of the largest

private:
    void addRow(const rubble_shape_state& shape, glm::ivec3 from, int length) {
        const glm::dvec3 size(length, 1, 1);
        const glm::dquat turn = quaternionOf(shape.rotation);
        const auto worldOf = [&](glm::dvec3 at) { return vectorOf(shape.position) + turn * (at * shape.voxel_size); };
        rubble_shape_cast cast{};
        cast.shape.kind = RUBBLE_QUERY_BOX;
        put(cast.shape.position, worldOf(glm::dvec3(from) + size * 0.5));
        put(cast.shape.half_size, (size * 0.5 - kMargin) * shape.voxel_size);
        put(cast.shape.rotation, turn);
        cast.direction[1] = -1.0;
        cast.max_distance = kReach;
        casts.push_back(cast);
        voxel = std::max(voxel, shape.voxel_size);
        for (int i = 0; i < 8; ++i)
            lowest = std::min(lowest, worldOf(glm::dvec3(from) + size * glm::dvec3(i & 1, i >> 1 & 1, i >> 2)).y);
    }

    const rubble::World& m_world;
};

}  // namespace

Place placeOf(const rubble::World& world, uint64_t object) {
    if (kindOf(world, object) == RUBBLE_KIND_BODY) {
        const rubble_body_state body = world.get_body_state(object);
        return {vectorOf(body.position), quaternionOf(body.rotation)};
    }
    if (kindOf(world, object) == RUBBLE_KIND_JOINT) {
        const rubble_joint_settings joint = settingsOf(world, object);
        return {vectorOf(joint.position), quaternionOf(joint.rotation)};
    }
    const rubble_light_settings light = world.get_light_settings(object);
    const Place base = baseOf(world, light);
    return {base.position + base.rotation * vectorOf(light.position), base.rotation * quaternionOf(light.rotation)};
}

uint64_t setPlace(rubble::World& world, uint64_t object, const Place& place) {
    if (kindOf(world, object) == RUBBLE_KIND_BODY) {
        rubble_body_change change{};
        change.body = object;
        change.fields = RUBBLE_SET_POSE;
        put(change.position, place.position);
        put(change.rotation, glm::normalize(place.rotation));
        world.set_body(change);
        return object;
    }
    if (kindOf(world, object) == RUBBLE_KIND_JOINT) {
        rubble_joint_settings joint = settingsOf(world, object);
        put(joint.position, place.position);
        put(joint.rotation, glm::normalize(place.rotation));
        return remakeJoint(world, object, joint);
    }
    rubble_light_settings light = world.get_light_settings(object);
    const Place base = baseOf(world, light);
    const glm::dquat inverse = glm::inverse(base.rotation);
    light.light = object;
    put(light.position, inverse * (place.position - base.position));
    put(light.rotation, glm::normalize(inverse * place.rotation));
    world.set_light(light);
    return object;
}

double depthBelow(const rubble::World& world, const std::vector<rubble_body>& bodies) {
    Undersides all(world);
    for (const rubble_body body : bodies)
        for (const rubble_shape_state& shape : world.get_shape_states(body)) all.add(shape);
    if (all.casts.empty()) return 0.0;
    rubble_query_filter filter{};
    filter.rejected_bodies = bodies.data();
    filter.rejected_body_count = uint32_t(bodies.size());
    double depth = std::numeric_limits<double>::max();
    for (const rubble_hit& hit : world.cast_shapes(all.casts.data(), uint32_t(all.casts.size()), filter))
        if (hit.hit) depth = std::min(depth, hit.distance);
    if (depth > kReach) return all.lowest;
    return std::max(depth - kMargin * all.voxel, 0.0);
}

}  // namespace editor
