#include <algorithm>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// The state of the body of argument 1; that of one that is gone is at rest at the origin.
rubble_body_state stateAt(lua_State* L) {
    rubble_body_state state = {};
    state.rotation[3] = 1.0;
    rubble_body_state read = {};
    if (isDone(L, apiOf(L).get_body_state(worldOf(L), handleAt(L, 1, "body"), &read))) state = read;
    return state;
}

Placement frameOf(const rubble_body_state& state) {
    return placementOf(state.position, state.rotation);
}

/// The properties of the body of argument 1; false: it is gone.
bool readProperties(lua_State* L, rubble_body_properties& properties) {
    return isDone(L, apiOf(L).get_body_properties(worldOf(L), handleAt(L, 1, "body"), &properties));
}

rubble_body_properties propertiesAt(lua_State* L) {
    auto properties = sized<rubble_body_properties>();
    readProperties(L, properties);
    return properties;
}

rubble_body_change changeAt(lua_State* L, uint32_t fields) {
    auto change = sized<rubble_body_change>();
    change.fields = fields;
    change.body = handleAt(L, 1, "body");
    change.rotation[3] = 1.0;
    return change;
}

int apply(lua_State* L, const rubble_body_change& change) {
    isDone(L, apiOf(L).set_body(worldOf(L), &change));
    return 0;
}

int getTransform(lua_State* L) {
    pushPlacement(L, frameOf(stateAt(L)));
    return 1;
}

int setTransform(lua_State* L) {
    rubble_body_change change = changeAt(L, RUBBLE_SET_POSE);
    const Placement placement = poseAt(L, 2, "transform");
    copy(change.position, placement.position);
    copy(change.rotation, placement.rotation);
    return apply(L, change);
}

int getVelocity(lua_State* L) {
    pushVector(L, stateAt(L).velocity);
    return 1;
}

int getAngularVelocity(lua_State* L) {
    pushVector(L, stateAt(L).angular_velocity);
    return 1;
}

/// Whether the body of argument 1 moves freely after the edits of this step. Tells once that the running function has
/// no effect on one that does not.
bool movesFreely(lua_State* L) {
    const PendingReads& pending = ScriptContext::of(L).shared.pending;
    const rubble_body body = handleAt(L, 1, "body");
    bool isStatic = false;
    if (const auto set = pending.kinds.find(body); set != pending.kinds.end())
        isStatic = set->second;
    else if (!pending.created.count(body))
        isStatic = stateAt(L).flags & RUBBLE_BODY_STATIC;
    if (isStatic) warnOnce(L, "body: expected a dynamic body, found a static one, so it has no effect");
    return !isStatic;
}

/// Sets one of the two velocities. The interface sets both: the other one is what this step has set, or that of the
/// last step.
int setMotion(lua_State* L, bool isAngular) {
    PendingReads& pending = ScriptContext::of(L).shared.pending;
    rubble_body_change change = changeAt(L, RUBBLE_SET_VELOCITY);
    const Vector given = vectorAt(L, 2, "velocity");
    if (!movesFreely(L)) return 0;
    std::array<double, 6> motion{};
    if (const auto set = pending.motions.find(change.body); set != pending.motions.end()) {
        motion = set->second;
    } else if (!pending.created.count(change.body)) {
        const rubble_body_state state = stateAt(L);
        if (!state.body) return 0;
        std::copy_n(state.velocity, 3, motion.begin());
        std::copy_n(state.angular_velocity, 3, motion.begin() + 3);
    }
    std::copy_n(given.begin(), 3, motion.begin() + (isAngular ? 3 : 0));
    std::copy_n(motion.begin(), 3, change.velocity);
    std::copy_n(motion.begin() + 3, 3, change.angular_velocity);
    apply(L, change);
    pending.motions[change.body] = motion;
    return 0;
}

int setVelocity(lua_State* L) {
    return setMotion(L, false);
}

int setAngularVelocity(lua_State* L) {
    return setMotion(L, true);
}

int getVelocityAtPos(lua_State* L) {
    const rubble_body_state state = stateAt(L);
    const Vector center = toParent(frameOf(state), vectorOf(propertiesAt(L).center));
    const Vector arm = vectorAt(L, 2, "pos") - center;
    const Vector velocity = vectorOf(state.velocity) + cross(vectorOf(state.angular_velocity), arm);
    pushVector(L, velocity.data());
    return 1;
}

int getMass(lua_State* L) {
    const bool isStatic = stateAt(L).flags & RUBBLE_BODY_STATIC;
    lua_pushnumber(L, isStatic ? 0.0 : propertiesAt(L).mass);
    return 1;
}

int getCenterOfMass(lua_State* L) {
    pushVector(L, propertiesAt(L).center);
    return 1;
}

/// The shapes of the body of argument 1; none: it is gone.
std::vector<uint64_t> shapesAt(lua_State* L) {
    const rubble_body body = stateAt(L).body;
    return body ? readOwned(L, body, RUBBLE_KIND_SHAPE) : std::vector<uint64_t>();
}

int getShapes(lua_State* L) {
    const std::vector<uint64_t> shapes = shapesAt(L);
    return pushHandles(L, shapes.data(), shapes.size());
}

/// The box around the grids of all shapes of a body.
int getBounds(lua_State* L) {
    return pushBounds(L, shapesAt(L));
}

int isActive(lua_State* L) {
    const rubble_body_state state = stateAt(L);
    lua_pushboolean(L, state.body && !(state.flags & (RUBBLE_BODY_STATIC | RUBBLE_BODY_ASLEEP)));
    return 1;
}

int setActive(lua_State* L) {
    const rubble_body_change change = changeAt(L, boolOr(L, 2, true) ? RUBBLE_SET_AWAKE : RUBBLE_SET_ASLEEP);
    if (!movesFreely(L)) return 0;
    if (change.fields == RUBBLE_SET_ASLEEP) ScriptContext::of(L).shared.pending.motions[change.body] = {};
    return apply(L, change);
}

int isDynamic(lua_State* L) {
    const rubble_body_state state = stateAt(L);
    lua_pushboolean(L, state.body && !(state.flags & RUBBLE_BODY_STATIC));
    return 1;
}

int setDynamic(lua_State* L) {
    const rubble_body_change change = changeAt(L, boolOr(L, 2, true) ? RUBBLE_SET_DYNAMIC : RUBBLE_SET_STATIC);
    const bool isStatic = change.fields == RUBBLE_SET_STATIC;
    PendingReads& pending = ScriptContext::of(L).shared.pending;
    if (!isDone(L, apiOf(L).set_body(worldOf(L), &change))) return 0;
    pending.kinds[change.body] = isStatic;
    if (isStatic) pending.motions[change.body] = {};
    return 0;
}

int isBroken(lua_State* L) {
    auto properties = sized<rubble_body_properties>();
    const bool isMade = isMadeInThisStep(L, handleAt(L, 1, "body"));
    lua_pushboolean(L, !isMade && (!readProperties(L, properties) || properties.is_broken));
    return 1;
}

int applyImpulse(lua_State* L) {
    auto push = sized<rubble_impulse>();
    push.body = handleAt(L, 1, "body");
    copy(push.position, vectorAt(L, 2, "pos"));
    copy(push.impulse, vectorAt(L, 3, "impulse"));
    isDone(L, apiOf(L).apply_impulse(worldOf(L), &push));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"GetBodyTransform(body) -> transform", "Where a body's frame is.", getTransform},
    {"SetBodyTransform(body, transform)", "Puts a body elsewhere in the next step.", setTransform, 200},
    {"GetBodyVelocity(body) -> v", "The velocity of its centre of mass, in m/s.", getVelocity},
    {"SetBodyVelocity(body, velocity)", "Sets that velocity in the next step.", setVelocity, 30},
    {"GetBodyAngularVelocity(body) -> v", "How it turns, in radians a second about the world's axes.",
     getAngularVelocity},
    {"SetBodyAngularVelocity(body, velocity)", "Sets how it turns in the next step.", setAngularVelocity, 30},
    {"GetBodyVelocityAtPos(body, pos) -> v", "The velocity of the body's point at a place of the world.",
     getVelocityAtPos},
    {"GetBodyMass(body) -> kg", "Its mass; 0 of a static one.", getMass},
    {"GetBodyCenterOfMass(body) -> v", "Its centre of mass, in its own frame.", getCenterOfMass},
    {"GetBodyBounds(body) -> min, max", "The box around its shapes' grids, in the world.", getBounds},
    {"GetBodyShapes(body) -> list", "Its shapes.", getShapes},
    {"IsBodyActive(body) -> boolean", "Whether it is simulated: neither static nor asleep.", isActive},
    {"SetBodyActive(body, active)", "Wakes it, or puts it to sleep.", setActive, 30},
    {"IsBodyDynamic(body) -> boolean", "Whether it moves freely.", isDynamic},
    {"SetBodyDynamic(body, dynamic)", "Lets it move freely, or holds it where it is.", setDynamic, 200},
    {"IsBodyBroken(body) -> boolean",
     "Whether it has lost voxels, or is gone; saved games keep that, levels do not, and an undo takes it back.",
     isBroken},
    {"ApplyBodyImpulse(body, pos, impulse)", "Pushes it at a place of the world, in N s.", applyImpulse, 30},
};

}  // namespace

std::span<const ScriptFunction> bodyFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
