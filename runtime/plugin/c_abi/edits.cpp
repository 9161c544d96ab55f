#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/stages/carve_edits.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kHostRadius{1e-3, ranges::kBrushRadius.high};  // metres

Hardness readHardness(uint32_t hardness) {
    constexpr Hardness classes[] = {Hardness::Hard, Hardness::Soft, Hardness::Medium, Hardness::Hard};
    return classes[readEnum(hardness, RUBBLE_HARDNESS_HARD, "max_hardness")];
}

Tool readTool(uint32_t tool) {
    return Tool(readEnum(tool, RUBBLE_TOOL_EXPLOSIVE, "tool"));
}

std::array<double, 3> readRadii(const double (&given)[3]) {
    std::array<double, 3> radii;
    for (size_t i = 0; i < 3; ++i) radii[i] = readOrDefault(given[i], kHostRadius, 0.0, "radii");
    if (radii[0] == 0.0) refuse(RUBBLE_ERROR_ARGUMENT, "radii[0] is 0, expected more: nothing would be removed");
    if (!std::is_sorted(radii.rbegin(), radii.rend()))
        refuse(RUBBLE_ERROR_ARGUMENT, "radii grow, expected soft >= medium >= hard");
    return radii;
}

glm::dvec3 readHalfSize(const double (&given)[3]) {
    const glm::dvec3 halfSize = readVector(given, "half_size");
    for (int i = 0; i < 3; ++i)
        if (!(halfSize[i] > 0.0 && isWithin(halfSize[i], ranges::kBrushRadius)))
            refuse(RUBBLE_ERROR_ARGUMENT, "half_size is {:f}, expected more than 0, at most 100", halfSize[i]);
    return halfSize;
}

uint8_t readByteFraction(uint32_t value, uint8_t ifZero, const char* name) {
    return uint8_t(readOrDefault(value, {1, 255}, ifZero, name));
}

CarveEdit readCarve(const World& world, const rubble_carve& given) {
    constexpr BrushKind kinds[] = {BrushKind::Sphere, BrushKind::Box, BrushKind::Capsule};
    CarveEdit edit;
    edit.kind = kinds[readEnum(given.brush, RUBBLE_BRUSH_CAPSULE, "brush")];
    edit.position = readVector(given.position, "position");
    edit.maxHardness = readHardness(given.max_hardness);
    if (edit.kind == BrushKind::Box) {
        edit.halfSize = readHalfSize(given.half_size);
        edit.rotation = readRotation(given.rotation, "rotation");
    } else {
        edit.radii = readRadii(given.radii);
    }
    if (edit.kind == BrushKind::Capsule) edit.end = readVector(given.end, "end");
    edit.shape = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    edit.tool = readTool(given.tool);
    return edit;
}

BreakEdit readBreak(const World& world, const rubble_break& given) {
    BreakEdit edit;
    edit.position = readVector(given.position, "position");
    edit.radii = readRadii(given.radii);
    edit.tool = readTool(given.tool);
    edit.seed = given.seed;
    edit.shape = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    return edit;
}

ExplodeEdit readExplosion(const World&, const rubble_explosion& given) {
    ExplodeEdit edit;
    edit.position = readVector(given.position, "position");
    edit.size = readOrDefault(given.size, ranges::kExplosionSize, 1.0, "size");
    edit.impulse = readOrDefault(given.impulse, ranges::kBlast, 0.0, "impulse");
    return edit;
}

PaintEdit readPaint(const World&, const rubble_paint& given) {
    PaintEdit edit;
    edit.position = readVector(given.position, "position");
    edit.radius = readOrDefault(given.radius, {1e-3, ranges::kPaintRadius.high}, 0.5, "radius");
    std::copy_n(given.color, 3, edit.color.begin());
    edit.strength = readByteFraction(given.strength, 64, "strength");
    edit.probability = readByteFraction(given.probability, 255, "probability");
    edit.seed = given.seed;
    return edit;
}

ImpulseEdit readImpulse(const World& world, const rubble_impulse& given) {
    ImpulseEdit edit;
    edit.body = readLiveHandle<HandleType::Body>(world.bodies(), given.body, "body");
    edit.position = readVector(given.position, "position");
    edit.impulse = readVector(given.impulse, "impulse", ranges::kImpulse);
    return edit;
}

SetCollisionFilterEdit readCollisionFilter(const World& world, const rubble_collision_filter& given) {
    SetCollisionFilterEdit edit;
    edit.layer = readLayers(given.layer, 1, "layer");
    edit.mask = readLayers(given.mask, 255, "mask");
    edit.shape = readLiveHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    return edit;
}

SetCollisionShapeEdit readCollisionShape(const World& world, const rubble_collision_shape& given) {
    SetCollisionShapeEdit edit;
    edit.kind = CollisionShape(readEnum(given.kind, RUBBLE_COLLISION_CYLINDER_Z, "kind"));
    edit.shape = readLiveHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    return edit;
}

/// Whether a body is static after the edits that wait, as far as that is known.
bool isStaticThen(HostedWorld& hosted, BodyHandle handle) {
    const Body* body = hosted.loop.world().bodies().find(handle);  // null: it is made by the step
    hosted.waiting.follow(hosted.loop.edits());
    return hosted.waiting.isStatic(handle, body ? std::optional(body->isStatic) : std::nullopt).value_or(false);
}

SetBodyEdit readBodyChange(HostedWorld& hosted, const rubble_body_change& given) {
    constexpr uint32_t kSleep = RUBBLE_SET_ASLEEP | RUBBLE_SET_AWAKE;
    constexpr uint32_t kMotion = RUBBLE_SET_VELOCITY | kSleep;
    constexpr uint32_t kKind = RUBBLE_SET_STATIC | RUBBLE_SET_DYNAMIC;
    constexpr uint32_t kForces = RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
    const uint32_t fields = readFlags(given.fields, RUBBLE_SET_POSE | kMotion | kKind | kForces, "fields");
    const BodyHandle handle = readLiveHandle<HandleType::Body>(hosted.loop.world().bodies(), given.body, "body");
    if (fields == 0) refuse(RUBBLE_ERROR_ARGUMENT, "fields is 0, expected RUBBLE_SET_...: nothing would change");
    if ((fields & kSleep) == kSleep)
        refuse(RUBBLE_ERROR_ARGUMENT, "fields has RUBBLE_SET_ASLEEP and RUBBLE_SET_AWAKE, expected one of them");
    if ((fields & kKind) == kKind)
        refuse(RUBBLE_ERROR_ARGUMENT, "fields has RUBBLE_SET_STATIC and RUBBLE_SET_DYNAMIC, expected one of them");
    const bool isStatic = fields & kKind ? (fields & RUBBLE_SET_STATIC) != 0 : isStaticThen(hosted, handle);
    if (isStatic && fields & kMotion)
        refuse(RUBBLE_ERROR_ARGUMENT, "fields has {:#x}, expected RUBBLE_SET_POSE alone: the body is static", fields);
    SetBodyEdit edit{.body = handle};
    edit.setsPose = fields & RUBBLE_SET_POSE;
    if (edit.setsPose) edit.pose = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    edit.setsVelocity = fields & RUBBLE_SET_VELOCITY;
    if (edit.setsVelocity) {
        edit.velocity = readVector(given.velocity, "velocity", ranges::kVelocity);
        edit.angularVelocity = readVector(given.angular_velocity, "angular_velocity", ranges::kVelocity);
    }
    edit.setsKind = fields & kKind;
    edit.isStatic = isStatic;
    edit.setsSleep = fields & kSleep;
    edit.asleep = fields & RUBBLE_SET_ASLEEP;
    edit.setsGravityScale = fields & RUBBLE_SET_GRAVITY_SCALE;
    if (edit.setsGravityScale)
        edit.gravityScale = readInRange(given.gravity_scale, ranges::kGravityScale, "gravity_scale");
    edit.setsDamping = fields & RUBBLE_SET_DAMPING;
    if (edit.setsDamping) {
        edit.linearDamping = readInRange(given.linear_damping, ranges::kDamping, "linear_damping");
        edit.angularDamping = readInRange(given.angular_damping, ranges::kDamping, "angular_damping");
    }
    return edit;
}

rubble_result setBody(rubble_world world, const rubble_body_change* edit) {
    return inWorld("set_body", world, [&](HostedWorld& hosted) {
        const rubble_body_change given = readStruct(edit, "change");
        if (!isRefused()) push(hosted, readBodyChange(hosted, given));
    });
}
rubble_result destroyBody(rubble_world world, rubble_body body) {
    return removeOne<DestroyBodyEdit, HandleType::Body>("destroy_body", world, body, "body", &World::bodies);
}
rubble_result carve(rubble_world world, const rubble_carve* edit) {
    return pushEdit("carve", world, edit, "carve", readCarve);
}
rubble_result countCarve(rubble_world world, const rubble_carve* edit, uint64_t* count) {
    return inWorld("count_carve", world, [&](const HostedWorld& hosted) {
        if (isGiven(count, "count")) *count = 0;
        const rubble_carve given = readStruct(edit, "carve");
        if (isRefused()) return;
        const CarveEdit carve = readCarve(hosted.loop.world(), given);
        if (!isRefused()) *count = countCarved(hosted.loop.world().data(), carve);
    });
}
rubble_result breakVoxels(rubble_world world, const rubble_break* edit) {
    return pushEdit("break_voxels", world, edit, "edit", readBreak);
}
rubble_result explode(rubble_world world, const rubble_explosion* edit) {
    return pushEdit("explode", world, edit, "explosion", readExplosion);
}
rubble_result paint(rubble_world world, const rubble_paint* edit) {
    return pushEdit("paint", world, edit, "paint", readPaint);
}
rubble_result applyImpulse(rubble_world world, const rubble_impulse* edit) {
    return pushEdit("apply_impulse", world, edit, "impulse", readImpulse);
}
rubble_result setCollisionFilter(rubble_world world, const rubble_collision_filter* edit) {
    return pushEdit("set_collision_filter", world, edit, "filter", readCollisionFilter);
}
rubble_result setCollisionShape(rubble_world world, const rubble_collision_shape* edit) {
    return pushEdit("set_collision_shape", world, edit, "shape", readCollisionShape);
}

}  // namespace

void setEditFunctions(rubble_api& api) {
    api.set_body = setBody;
    api.destroy_body = destroyBody;
    api.carve = carve;
    api.count_carve = countCarve;
    api.break_voxels = breakVoxels;
    api.explode = explode;
    api.paint = paint;
    api.apply_impulse = applyImpulse;
    api.set_collision_filter = setCollisionFilter;
    api.set_collision_shape = setCollisionShape;
}

}  // namespace rubble::abi
