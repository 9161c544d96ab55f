#include "runtime/plugin/c_abi/reads.h"

#include <algorithm>

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

template <class Handles>
void copyBits(const Handles& handles, std::vector<uint64_t>& out) {
    out.clear();
    for (const auto handle : handles) out.push_back(handle.bits);
}

void writeCell(int32_t (&out)[3], glm::ivec3 cell) {
    out[0] = cell.x, out[1] = cell.y, out[2] = cell.z;
}

}  // namespace

void EventRows::fill(const FrameChanges& changes) {
    m_step = changes.step;
    m_painted = changes.paintedVoxels;
    m_levelReplaced = changes.levelReplaced;
    copyBits(changes.bodiesCreated, m_bodiesCreated);
    copyBits(changes.bodiesDestroyed, m_bodiesDestroyed);
    copyBits(changes.shapesCreated, m_shapesCreated);
    copyBits(changes.shapesDestroyed, m_shapesDestroyed);
    copyBits(changes.groupsOut, m_groupsOut);
    copyBits(changes.broken, m_broken);
    copyBits(changes.settled, m_settled);
    copyBits(changes.unsettled, m_revived);
    m_dust.clear();
    for (const DustCloud& cloud : changes.dust) {
        rubble_dust_cloud row = {.radius = cloud.radius, .count = cloud.count, .material = cloud.material};
        writeVector(row.position, cloud.position);
        writeVector(row.velocity, cloud.velocity);
        std::copy_n(cloud.color.begin(), 3, row.color);
        m_dust.push_back(row);
    }
    m_removed.clear();
    for (const RemovedVoxels& removed : changes.removed)
        m_removed.push_back({removed.shape.bits,
                             removed.count,
                             {removed.color[0], removed.color[1], removed.color[2]},
                             removed.material,
                             removed.entry});
    m_splits.clear();
    for (const ShapeSplit& split : changes.splits)
        for (size_t i = 0; i < split.children.size(); ++i) {
            rubble_shape_split row = {split.parent.bits, split.children[i].bits, {}, 0};
            writeCell(row.cell, split.parentOffset[i]);
            m_splits.push_back(row);
        }
}

rubble_events EventRows::view() const {
    rubble_events events = {};
    events.level_loaded = m_levelReplaced;
    events.step = m_step;
    events.painted_voxels = m_painted;
    events.removed = m_removed.data();
    events.splits = m_splits.data();
    events.bodies_created = m_bodiesCreated.data();
    events.bodies_destroyed = m_bodiesDestroyed.data();
    events.shapes_created = m_shapesCreated.data();
    events.shapes_destroyed = m_shapesDestroyed.data();
    events.light_groups_out = m_groupsOut.data();
    events.dust = m_dust.data();
    events.bodies_broken = m_broken.data();
    events.bodies_settled = m_settled.data();
    events.bodies_unsettled = m_revived.data();
    events.dust_count = uint32_t(m_dust.size());
    events.bodies_broken_count = uint32_t(m_broken.size());
    events.bodies_settled_count = uint32_t(m_settled.size());
    events.bodies_unsettled_count = uint32_t(m_revived.size());
    events.removed_count = uint32_t(m_removed.size());
    events.split_count = uint32_t(m_splits.size());
    events.bodies_created_count = uint32_t(m_bodiesCreated.size());
    events.bodies_destroyed_count = uint32_t(m_bodiesDestroyed.size());
    events.shapes_created_count = uint32_t(m_shapesCreated.size());
    events.shapes_destroyed_count = uint32_t(m_shapesDestroyed.size());
    events.light_groups_out_count = uint32_t(m_groupsOut.size());
    return events;
}

rubble_body_state bodyState(BodyHandle handle, const Body& body) {
    rubble_body_state state = {};
    state.body = handle.bits;
    writeVector(state.position, body.pose.position);
    writeRotation(state.rotation, body.pose.rotation);
    writeVector(state.velocity, body.velocity);
    writeVector(state.angular_velocity, body.angularVelocity);
    if (body.isStatic) state.flags |= RUBBLE_BODY_STATIC;
    if (body.asleep) state.flags |= RUBBLE_BODY_ASLEEP;
    state.shape_count = uint32_t(body.shapes.size());
    return state;
}

rubble_shape_state shapeState(const World& world, ShapeHandle handle, const Shape& shape) {
    const Pose pose = world.shapeToWorld(handle);
    rubble_shape_state state = {};
    state.shape = handle.bits;
    state.body = shape.body.bits;
    writeVector(state.position, pose.position);
    writeRotation(state.rotation, pose.rotation);
    state.voxel_size = shape.voxelSize;
    writeCell(state.size, shape.grid.size());
    state.voxels = shape.grid.voxelCount();
    return state;
}

rubble_hit hitState(const World& world, const WorldHit& hit) {
    rubble_hit state = {};
    if (!hit.hit) return state;
    state.hit = 1;
    state.distance = hit.distance;
    writeVector(state.position, hit.position);
    writeVector(state.normal, hit.normal);
    state.shape = hit.shape.bits;
    state.body = world.shapes().at(hit.shape).body.bits;
    writeCell(state.cell, hit.cell);
    state.entry = hit.entry;
    return state;
}

}  // namespace rubble::abi
