#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/rows.h"

namespace rubble::abi {
namespace {

rubble_result getEvents(rubble_world world, rubble_events* out) {
    return inWorld("get_events", world, [&](const HostedWorld& hosted) { writeStruct(out, hosted.events.view()); });
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
    const Pose pose = shapeToWorld(world, handle);
    rubble_shape_state state = {};
    state.shape = handle.bits;
    state.body = shape.body.bits;
    writeVector(state.position, pose.position);
    writeRotation(state.rotation, pose.rotation);
    state.voxel_size = shape.voxelSize;
    writeCell(state.size, shape.grid.size());
    state.voxel_count = shape.grid.voxelCount();
    return state;
}

const Body* findBody(const World& world, rubble_body bits) {
    return findLive<HandleType::Body>(world.bodies(), bits, "body");
}

rubble_result getBodyStates(rubble_world world, rubble_body_state* out, uint32_t capacity, uint32_t* count) {
    return listRows("get_body_states", world, out, capacity, count);
}

rubble_result getBodyState(rubble_world world, rubble_body body, rubble_body_state* out) {
    return inWorld("get_body_state", world, [&](const HostedWorld& hosted) {
        const Body* found = findBody(hosted.loop.world(), body);
        if (found && isGiven(out, "out")) *out = bodyState(BodyHandle{body}, *found);
    });
}

rubble_result getShapeStates(rubble_world world, rubble_body body, rubble_shape_state* out, uint32_t capacity,
                             uint32_t* count) {
    return listRows<rubble_shape_state>(
        "get_shape_states", world, out, capacity, count,
        [&](const HostedWorld& hosted, RowWriter<rubble_shape_state>& rows) { writeRows(hosted, rows, body); });
}

rubble_result getShapeState(rubble_world world, rubble_shape shape, rubble_shape_state* out) {
    return inWorld("get_shape_state", world, [&](const HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        const Shape* found = findLive<HandleType::Shape>(inside.shapes(), shape, "shape");
        if (found && isGiven(out, "out")) *out = shapeState(inside, ShapeHandle{shape}, *found);
    });
}

rubble_result getVoxelAccounting(rubble_world world, rubble_voxel_accounting* out) {
    return inWorld("get_voxel_accounting", world, [&](const HostedWorld& hosted) {
        const VoxelAccounting all = voxelAccounting(hosted.loop.world());
        rubble_voxel_accounting row = {};
        row.imported = all.imported;
        row.standing = all.standing;
        row.in_pieces = all.inPieces;
        row.removed = all.removed;
        writeStruct(out, row);
    });
}

rubble_result getStateHash(rubble_world world, uint64_t* out) {
    return inWorld("get_state_hash", world, [&](const HostedWorld& hosted) {
        if (isGiven(out, "out")) *out = hosted.loop.world().hash();
    });
}

rubble_result getStepStats(rubble_world world, rubble_step_stats* out) {
    return inWorld("get_step_stats", world, [&](HostedWorld& hosted) {
        FrameLoop& loop = hosted.loop;
        const PhysicsStats physics = loop.physics() ? loop.physics()->stats() : PhysicsStats{};
        const StageTimes& times = loop.times();
        rubble_step_stats row = {};
        row.bodies = uint32_t(physics.bodies);
        row.bodies_awake = uint32_t(physics.awake);
        row.contacts = uint32_t(physics.contacts);
        row.step = loop.world().step();
        row.shadow_lag = loop.shadow() ? loop.shadow()->lag() : 0;
        row.edits_ms = times[Stage::ApplyEdits];
        row.physics_ms = times[Stage::Physics];
        row.poses_ms = times[Stage::Poses];
        row.impacts_ms = times[Stage::Impacts];
        row.shadow_ms = times[Stage::Shadow];
        row.publish_ms = times[Stage::Publish];
        writeStruct(out, row);
    });
}

}  // namespace

void writeRows(const HostedWorld& hosted, RowWriter<rubble_body_state>& rows) {
    hosted.loop.world().bodies().forEach(
        [&](BodyHandle handle, const Body& body) { rows.add([&] { return bodyState(handle, body); }); });
}

void writeMovedRows(HostedWorld& hosted, RowWriter<rubble_body_state>& rows) {
    std::vector<BodyHandle> moved;
    for (const BodyPose& pose : hosted.loop.drawingData().moved) moved.push_back(pose.body);
    std::sort(moved.begin(), moved.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    for (const BodyHandle handle : moved)
        if (const Body* body = hosted.loop.world().bodies().find(handle))
            rows.add([&] { return bodyState(handle, *body); });
}

void writeRows(const HostedWorld& hosted, RowWriter<rubble_shape_state>& rows, rubble_body body) {
    const World& inside = hosted.loop.world();
    const auto add = [&](ShapeHandle handle, const Shape& shape) {
        rows.add([&] { return shapeState(inside, handle, shape); });
    };
    if (!body) return inside.shapes().forEach(add);
    const Body* found = findBody(inside, body);
    if (!found) return;
    for (const ShapeHandle handle : found->shapes) add(handle, inside.shapes().at(handle));
}

void setStateFunctions(rubble_api& api) {
    api.get_events = getEvents;
    api.get_body_states = getBodyStates;
    api.get_body_state = getBodyState;
    api.get_shape_states = getShapeStates;
    api.get_shape_state = getShapeState;
    api.get_voxel_accounting = getVoxelAccounting;
    api.get_state_hash = getStateHash;
    api.get_step_stats = getStepStats;
}

}  // namespace rubble::abi
