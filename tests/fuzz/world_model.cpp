#include "tests/fuzz/world_model.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

void require(bool holds, const char* what, const rubble_api& api) {
    if (holds) return;
    std::fprintf(stderr, "the model of a world differs: %s; the last error was: %s\n", what, api.get_last_error());
    std::abort();
}

void apply(std::set<uint64_t>& handles, const uint64_t* destroyed, uint32_t destroyedCount, const uint64_t* created,
           uint32_t createdCount) {
    for (uint32_t i = 0; i < destroyedCount; ++i) handles.erase(destroyed[i]);
    handles.insert(created, created + createdCount);
}

}  // namespace

uint64_t WorldModel::hash() const {
    uint64_t out = 0;
    require(m_api.get_state_hash(m_world, &out) == RUBBLE_OK, "no hash", m_api);
    return out;
}

std::vector<rubble_shape_state> WorldModel::shapeRows() const {
    uint32_t count = 0;
    m_api.get_shape_states(m_world, 0, nullptr, 0, &count);
    std::vector<rubble_shape_state> rows(count);
    if (count) require(m_api.get_shape_states(m_world, 0, rows.data(), count, &count) == RUBBLE_OK, "no shapes", m_api);
    return rows;
}

WorldModel::Handles WorldModel::shapes() const {
    Handles out;
    for (const rubble_shape_state& row : shapeRows()) out.insert(row.shape);
    return out;
}

WorldModel::Handles WorldModel::bodies() const {
    uint32_t count = 0;
    m_api.get_body_states(m_world, nullptr, 0, &count);
    std::vector<rubble_body_state> rows(count);
    if (count) require(m_api.get_body_states(m_world, rows.data(), count, &count) == RUBBLE_OK, "no bodies", m_api);
    Handles out;
    for (const rubble_body_state& row : rows) out.insert(row.body);
    return out;
}

void WorldModel::requireSums() const {
    rubble_voxel_accounting sums = {};
    sums.struct_size = sizeof sums;
    require(m_api.get_voxel_accounting(m_world, &sums) == RUBBLE_OK, "no sums", m_api);
    uint64_t voxels = 0;
    for (const rubble_shape_state& row : shapeRows()) voxels += row.voxel_count;
    require(voxels == sums.standing + sums.in_pieces, "voxels of the shapes, and standing + in_pieces", m_api);
    require(sums.imported == voxels + sums.removed, "imported, and standing + in_pieces + removed", m_api);
}

void WorldModel::restart() {
    m_hash = hash(), m_bodies = bodies(), m_shapes = shapes();
    m_mirror.forget();
}

void WorldModel::requireUnchanged() const {
    require(hash() == m_hash, "a call changed the world", m_api);
}

void WorldModel::step() {
    require(m_api.step(m_world) == RUBBLE_OK, "step() failed", m_api);
    rubble_events events = {};
    events.struct_size = sizeof events;
    require(m_api.get_events(m_world, &events) == RUBBLE_OK, "no events", m_api);
    apply(m_bodies, events.bodies_destroyed, events.bodies_destroyed_count, events.bodies_created,
          events.bodies_created_count);
    apply(m_shapes, events.shapes_destroyed, events.shapes_destroyed_count, events.shapes_created,
          events.shapes_created_count);
    require(m_bodies == bodies(), "bodies, and those of the events", m_api);
    require(m_shapes == shapes(), "shapes, and those of the events", m_api);
    requireSums();
    m_mirror.step();
    for (uint32_t i = 0; i < events.split_count; ++i) {
        reached("pieces that came off");
        require(m_shapes.count(events.splits[i].piece) == 1 ||
                    std::count(events.shapes_destroyed, events.shapes_destroyed + events.shapes_destroyed_count,
                               events.splits[i].piece) > 0,
                "a piece of the events is no shape", m_api);
    }
    m_hash = hash();
    reached("steps compared with the model");
}

std::vector<uint8_t> WorldModel::voxels(const rubble_shape_state& shape) const {
    rubble_voxel_box all = {};
    all.struct_size = sizeof all, all.shape = shape.shape;
    std::copy_n(shape.size, 3, all.size);
    std::vector<uint8_t> out(size_t(shape.size[0]) * size_t(shape.size[1]) * size_t(shape.size[2]));
    uint64_t count = 0;
    require(m_api.read_voxels(m_world, &all, out.data(), out.size(), &count) == RUBBLE_OK, "read_voxels()", m_api);
    require(count == out.size(), "cells of read_voxels()", m_api);
    const auto full = uint64_t(out.size() - size_t(std::count(out.begin(), out.end(), 0)));
    require(full == shape.voxel_count, "voxels of read_voxels(), and voxel_count", m_api);
    return out;
}

/// Whether a fire is on it, which gives voxels the colours of char.
bool WorldModel::isBurning(rubble_shape shape) const {
    uint32_t count = 0;
    m_api.get_fires(m_world, nullptr, 0, &count);
    std::vector<rubble_fire> fires(count);
    if (count) require(m_api.get_fires(m_world, fires.data(), count, &count) == RUBBLE_OK, "no fires", m_api);
    return std::any_of(fires.begin(), fires.end(), [&](const rubble_fire& fire) { return fire.shape == shape; });
}

void WorldModel::write(const rubble_shape_state& shape, const rubble_voxel_box& box,
                       const std::vector<uint8_t>& written) {
    std::vector<uint8_t> expected = voxels(shape);
    bool chars = isBurning(shape.shape);
    if (m_api.write_voxels(m_world, &box, written.data(), written.size()) != RUBBLE_OK) return step();
    size_t next = 0;
    for (int z = box.low[2]; z < box.low[2] + box.size[2]; ++z)
        for (int y = box.low[1]; y < box.low[1] + box.size[1]; ++y)
            for (int x = box.low[0]; x < box.low[0] + box.size[0]; ++x)
                expected[(size_t(z) * size_t(shape.size[1]) + size_t(y)) * size_t(shape.size[0]) + size_t(x)] =
                    written[next++];
    step();
    rubble_events events = {};
    events.struct_size = sizeof events;
    m_api.get_events(m_world, &events);
    // A piece too small to live is dust at once: the only rows that name it are those of its removed voxels.
    const bool isBroken =
        std::any_of(events.removed, events.removed + events.removed_count,
                    [&](const auto& row) { return row.shape == shape.shape || !m_shapes.count(row.shape); }) ||
        std::any_of(events.splits, events.splits + events.split_count,
                    [&](const auto& row) { return row.parent == shape.shape; });
    if (isBroken || m_shapes.count(shape.shape) == 0) return;
    chars |= isBurning(shape.shape);
    const auto areAlike = [&](uint8_t a, uint8_t b) { return chars ? (a == 0) == (b == 0) : a == b; };
    for (const rubble_shape_state& now : shapeRows())
        if (now.shape == shape.shape && std::equal(now.size, now.size + 3, shape.size)) {
            const std::vector<uint8_t> found = voxels(now);
            require(std::equal(found.begin(), found.end(), expected.begin(), areAlike), "written voxels", m_api);
            reached("writes read back");
        }
}

}  // namespace rubble
