#include <algorithm>
#include <bitset>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/layers.h"
#include "runtime/voxel/merged_boxes.h"
#include "runtime/world/objects/object_errors.h"

namespace rubble::abi {
namespace {

struct ChangedBody {
    BodyHandle body;
    uint32_t changes;  ///< RUBBLE_RIGID_...
};

rubble_result getLayers(uint32_t* layers) {
    return guarded("get_layers", [&] {
        if (isGiven(layers, "layers"))
            *layers = (hasPhysics() ? RUBBLE_LAYER_PHYSICS : 0) | (hasRenderer() ? RUBBLE_LAYER_RENDERER : 0);
    });
}

/// Each body once, by slot, with all that happened to it.
void sortChanges(std::vector<ChangedBody>& changed) {
    std::stable_sort(changed.begin(), changed.end(),
                     [](const ChangedBody& a, const ChangedBody& b) { return a.body.slot() < b.body.slot(); });
    size_t kept = 0;
    for (const ChangedBody& each : changed) {
        if (kept && changed[kept - 1].body == each.body)
            changed[kept - 1].changes |= each.changes;
        else
            changed[kept++] = each;
    }
    changed.resize(kept);
}

std::vector<ChangedBody> changedBodies(const FrameChanges& changes, const World& world) {
    std::vector<ChangedBody> out;
    const auto add = [&](BodyHandle body, uint32_t change) {
        if (world.bodies().find(body)) out.push_back({body, change});
    };
    const auto addOwner = [&](ShapeHandle shape) {
        if (const Shape* found = world.shapes().find(shape)) add(found->body, RUBBLE_RIGID_SOLID);
    };
    for (const BodyHandle body : changes.bodiesCreated) add(body, RUBBLE_RIGID_NEW);
    for (const auto* list : {&changes.teleported, &changes.woken})
        for (const BodyHandle body : *list) add(body, RUBBLE_RIGID_MOVED);
    for (const BodyHandle body : changes.lostShapes) add(body, RUBBLE_RIGID_SOLID);
    for (const auto* list : {&changes.shapesCreated, &changes.carved, &changes.filters})
        for (const ShapeHandle shape : *list)
            if (list != &changes.shapesCreated || !changes.isRelocated(shape)) addOwner(shape);
    sortChanges(out);
    for (ChangedBody& each : out)  // about another centre a body that turns has another velocity
        if (each.changes & RUBBLE_RIGID_SOLID && !world.bodies().at(each.body).isStatic)
            each.changes |= RUBBLE_RIGID_MOVED;
    return out;
}

rubble_rigid_body rigidBody(const World& world, ChangedBody changed) {
    const Body& body = world.bodies().at(changed.body);
    const MassProperties mass = bodyMass(world.data(), changed.body);
    rubble_rigid_body row = {.body = changed.body.bits, .changes = changed.changes, .mass = mass.mass};
    row.flags = (body.isStatic ? RUBBLE_BODY_STATIC : 0) | (body.asleep ? RUBBLE_BODY_ASLEEP : 0);
    writeVector(row.center, mass.center);
    writeVector(row.inertia, mass.principalInertia);
    writeRotation(row.inertia_rotation, mass.principalAxes);
    writeVector(row.position, body.pose.position);
    writeRotation(row.rotation, body.pose.rotation);
    writeVector(row.velocity, body.velocity);
    writeVector(row.angular_velocity, body.angularVelocity);
    return row;
}

rubble_result getRigidBodies(rubble_world world, uint32_t which, rubble_rigid_body* out, uint32_t capacity,
                             uint32_t* count) {
    return listRows<rubble_rigid_body>(
        "get_rigid_bodies", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
            const World& inside = hosted.loop.world();
            const FrameChanges& changes = hosted.loop.changes();
            const auto add = [&](ChangedBody changed) { rows.add([&] { return rigidBody(inside, changed); }); };
            if (readEnum(which, RUBBLE_BODIES_ALL, "which") == RUBBLE_BODIES_ALL || changes.levelReplaced)
                return inside.bodies().forEach([&](BodyHandle body, const Body&) { add({body, RUBBLE_RIGID_NEW}); });
            for (const ChangedBody& changed : changedBodies(changes, inside)) add(changed);
        });
}

/// The entries whose voxels bodies touch.
std::bitset<256> collidingEntries(const Palette& palette, const MaterialTable& materials) {
    std::bitset<256> out;
    for (size_t entry = 1; entry < 256; ++entry)
        out[entry] = materials[palette[uint8_t(entry)].material].hardness != Hardness::Unphysical;
    return out;
}

rubble_body_box boxRow(ShapeHandle handle, const Shape& shape, const CellBox& box) {
    const double voxel = double(shape.voxelSize);
    rubble_body_box row = {.shape = handle.bits, .layer = shape.collisionLayer, .mask = shape.collisionMask};
    writeVector(row.center, shape.local.transformPoint(glm::dvec3(box.low + box.high) * (0.5 * voxel)));
    writeRotation(row.rotation, shape.local.rotation);
    writeVector(row.half_size, glm::dvec3(box.high - box.low) * (0.5 * voxel));
    return row;
}

rubble_result getBodyBoxes(rubble_world world, rubble_body body, rubble_body_box* out, uint32_t capacity,
                           uint32_t* count) {
    return listRows<rubble_body_box>(
        "get_body_boxes", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
            const World& inside = hosted.loop.world();
            const Body* found = findLive<HandleType::Body>(inside.bodies(), body, "body");
            if (!found) return;
            for (const ShapeHandle handle : found->shapes) {
                const Shape& shape = inside.shapes().at(handle);
                for (const CellBox& box : mergedBoxes(shape.grid, collidingEntries(*shape.palette, inside.materials())))
                    rows.add([&] { return boxRow(handle, shape, box); });
            }
        });
}

rubble_result getBodyImpulses(rubble_world world, rubble_body_impulse* out, uint32_t capacity, uint32_t* count) {
    return listRows<rubble_body_impulse>("get_body_impulses", world, out, capacity, count,
                                         [](const HostedWorld& hosted, auto& rows) {
                                             for (const ImpulseApplied& given : hosted.loop.changes().impulses)
                                                 rows.add([&] {
                                                     rubble_body_impulse row = {.body = given.body.bits};
                                                     writeVector(row.position, given.position);
                                                     writeVector(row.impulse, given.impulse);
                                                     return row;
                                                 });
                                         });
}

/// A function that reads `count` rows of the host's physics, which must move the world, and takes them over.
template <class Value, class Row, class Read, class Take>
rubble_result takeRows(const char* function, rubble_world world, const Row* rows, const char* name, uint32_t count,
                       Read&& read, Take&& take) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        if (hosted.loop.physics())
            refuse(RUBBLE_ERROR_UNSUPPORTED,
                   "the world has physics of its own: expected one with RUBBLE_WORLD_HOST_PHYSICS");
        if (count) isGiven(rows, name);
        if (isRefused()) return;
        std::vector<Value> values(count);
        const auto* given = reinterpret_cast<const char*>(rows);
        for (uint32_t i = 0; i < count; ++i) {
            values[i] =
                read(hosted.loop.world(), copyStruct<Row>(given + size_t(i) * kFirstSize<Row>, kFirstSize<Row>));
            if (isRefused()) return Call::current().locate(fmt::format("{}[{}].", name, i));
        }
        change(hosted, [&] { take(hosted.loop, values); });
    });
}

BodyPose readState(const World& world, const rubble_body_state& given) {
    BodyPose pose{.body = BodyHandle{given.body}};
    const Body* body = findLive<HandleType::Body>(world.bodies(), given.body, "body");
    if (body && body->isStatic) refuse(RUBBLE_ERROR_ARGUMENT, "body is static: expected a free one, or set_body()");
    pose.pose = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    pose.velocity = readVector(given.velocity, "velocity", ranges::kVelocity);
    pose.angularVelocity = readVector(given.angular_velocity, "angular_velocity", ranges::kVelocity);
    pose.asleep = readFlags(given.flags, RUBBLE_BODY_ASLEEP, "flags") & RUBBLE_BODY_ASLEEP;
    return pose;
}

rubble_result setBodyStates(rubble_world world, const rubble_body_state* states, uint32_t count) {
    return takeRows<BodyPose>("set_body_states", world, states, "states", count, readState,
                              [](FrameLoop& loop, const std::vector<BodyPose>& poses) { loop.followHost(poses, {}); });
}

Impact readImpact(const World& world, const rubble_impact& given) {
    Impact impact;
    const auto readBody = [&](rubble_body bits, const char* name) {
        return bits && findLive<HandleType::Body>(world.bodies(), bits, name) ? BodyHandle{bits} : BodyHandle{};
    };
    impact.body = readBody(given.body, "body");
    impact.other = readBody(given.other, "other");
    if (!given.body && !given.other) refuse(RUBBLE_ERROR_STALE, "body and other are 0: expected one of them at least");
    impact.position = readVector(given.position, "position");
    impact.normal = glm::normalize(readDirection(given.normal, "normal"));
    impact.impulse = readInRange(given.impulse, {0.0, ranges::kImpulse.high}, "impulse");
    impact.speed = readInRange(given.speed, {0.0, ranges::kVelocity.high}, "speed");
    return impact;
}

rubble_result reportImpacts(rubble_world world, const rubble_impact* impacts, uint32_t count) {
    return takeRows<Impact>("report_impacts", world, impacts, "impacts", count, readImpact,
                            [](FrameLoop& loop, const std::vector<Impact>& hits) { loop.followHost({}, hits); });
}

}  // namespace

void setHostPhysicsFunctions(rubble_api& api) {
    api.get_layers = getLayers;
    api.get_rigid_bodies = getRigidBodies;
    api.get_body_boxes = getBodyBoxes;
    api.get_body_impulses = getBodyImpulses;
    api.set_body_states = setBodyStates;
    api.report_impacts = reportImpacts;
}

}  // namespace rubble::abi
