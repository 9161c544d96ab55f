#include "samples/hosts/godot/godot_bodies.h"

#include <algorithm>
#include <cmath>

#include "samples/hosts/godot/spatial_math.h"
#include "samples/hosts/godot/voxel_world.h"

namespace rubble_godot {
namespace {

const Method kBodyCreate{"PhysicsServer", "body_create"}, kBodySetSpace{"PhysicsServer", "body_set_space"},
    kBodySetMode{"PhysicsServer", "body_set_mode"}, kBodySetParam{"PhysicsServer", "body_set_param"},
    kBodySetState{"PhysicsServer", "body_set_state"}, kBodyGetState{"PhysicsServer", "body_get_state"},
    kBodyAddShape{"PhysicsServer", "body_add_shape"}, kBodyClearShapes{"PhysicsServer", "body_clear_shapes"},
    kBodySetContacts{"PhysicsServer", "body_set_max_contacts_reported"},
    kBodyImpulse{"PhysicsServer", "body_apply_impulse"}, kBodyDirectState{"PhysicsServer", "body_get_direct_state"},
    kShapeCreate{"PhysicsServer", "shape_create"}, kShapeSetData{"PhysicsServer", "shape_set_data"},
    kFree{"PhysicsServer", "free_rid"}, kGetWorld{"Spatial", "get_world"}, kGetSpace{"World", "get_space"};
const Method kContactCount{"PhysicsDirectBodyState", "get_contact_count"},
    kContactImpulse{"PhysicsDirectBodyState", "get_contact_impulse"},
    kContactNormal{"PhysicsDirectBodyState", "get_contact_local_normal"},
    kContactPosition{"PhysicsDirectBodyState", "get_contact_collider_position"},
    kContactCollider{"PhysicsDirectBodyState", "get_contact_collider"};

constexpr int32_t kStatic = 0, kRigid = 2;                                   // PhysicsServer.BODY_MODE_...
constexpr int32_t kBox = 3;                                                  // SHAPE_BOX
constexpr int32_t kMass = 2;                                                 // BODY_PARAM_MASS
constexpr int32_t kTransform = 0, kLinear = 1, kAngular = 2, kSleeping = 3;  // BODY_STATE_...
constexpr int32_t kContacts = 4;                                             // of a body that Godot reports
constexpr double kMinHitSpeed = 1.0;                                         // m/s: slower contacts rest

double dot(const Vec3& a, const Vec3& b) {
    return double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
}

}  // namespace

GodotBodies::~GodotBodies() {
    clear();
}

void GodotBodies::clear() {
    while (!m_bodies.empty()) remove(m_bodies.begin()->first);
}

void GodotBodies::remove(rubble_body handle) {
    const auto found = m_bodies.find(handle);
    if (found == m_bodies.end()) return;
    gd::Object* const server = singleton("PhysicsServer");
    m_handles.erase(found->second.rid.ridKey());
    kFree(server, found->second.rid);
    for (const Variant& box : found->second.boxes) kFree(server, box);
    m_bodies.erase(found);
}

void GodotBodies::setCollider(const rubble_rigid_body& row, Body& body) {
    gd::Object* const server = singleton("PhysicsServer");
    const rubble_api& api = m_owner.api();
    uint32_t count = 0;
    if (!m_owner.check(api.get_body_boxes(m_owner.world(), row.body, nullptr, 0, &count), "get_body_boxes")) return;
    std::vector<rubble_body_box> boxes(count);
    if (!m_owner.check(api.get_body_boxes(m_owner.world(), row.body, boxes.data(), count, &count), "get_body_boxes"))
        return;
    kBodyClearShapes(server, body.rid);
    for (const Variant& box : body.boxes) kFree(server, box);
    body.boxes.clear();
    body.center = toVec3(row.center);
    for (const rubble_body_box& row_box : boxes) {
        Transform place = toTransform(row_box.center, row_box.rotation);
        for (size_t i = 0; i < 3; ++i) place.origin[i] -= body.center[i];
        body.boxes.push_back(kShapeCreate(server, kBox));
        kShapeSetData(server, body.boxes.back(), toVec3(row_box.half_size));
        kBodyAddShape(server, body.rid, body.boxes.back(), place);
    }
    kBodySetParam(server, body.rid, kMass, std::max(row.mass, 0.001));
}

void GodotBodies::setMotion(const rubble_rigid_body& row, Body& body) {
    gd::Object* const server = singleton("PhysicsServer");
    Transform place = toTransform(row.position, row.rotation);
    place.origin = transformPoint(place, body.center);
    body.moves = !(row.flags & RUBBLE_BODY_STATIC);
    body.asleep = row.flags & RUBBLE_BODY_ASLEEP;
    body.velocity = toVec3(row.velocity);
    kBodySetMode(server, body.rid, body.moves ? kRigid : kStatic);
    kBodySetState(server, body.rid, kTransform, place);
    if (!body.moves) return;
    kBodySetContacts(server, body.rid, kContacts);
    kBodySetState(server, body.rid, kLinear, body.velocity);
    kBodySetState(server, body.rid, kAngular, toVec3(row.angular_velocity));
    kBodySetState(server, body.rid, kSleeping, body.asleep);
}

void GodotBodies::follow() {
    gd::Object* const server = singleton("PhysicsServer");
    const rubble_api& api = m_owner.api();
    rubble_events events = {.struct_size = sizeof events};
    uint32_t count = 0;
    if (!m_owner.check(api.get_events(m_owner.world(), &events), "get_events")) return;
    for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i) remove(events.bodies_destroyed[i]);
    api.get_rigid_bodies(m_owner.world(), RUBBLE_BODIES_CHANGED, nullptr, 0, &count);
    std::vector<rubble_rigid_body> rows(count);
    if (!m_owner.check(api.get_rigid_bodies(m_owner.world(), RUBBLE_BODIES_CHANGED, rows.data(), count, &count),
                       "get_rigid_bodies"))
        return;
    for (const rubble_rigid_body& row : rows) {
        const auto [found, isNew] = m_bodies.try_emplace(row.body);
        if (isNew) {
            const Variant world = kGetWorld(m_owner.node());
            found->second.rid = kBodyCreate(server, kStatic, false);
            kBodySetSpace(server, found->second.rid, kGetSpace(world.as<gd::Object*>()));
            m_handles[found->second.rid.ridKey()] = row.body;
        }
        if (isNew || row.changes & (RUBBLE_RIGID_NEW | RUBBLE_RIGID_SOLID)) setCollider(row, found->second);
        setMotion(row, found->second);  // a collider about another centre moves the body of Godot too
    }
    api.get_body_impulses(m_owner.world(), nullptr, 0, &count);
    std::vector<rubble_body_impulse> impulses(count);
    m_owner.check(api.get_body_impulses(m_owner.world(), impulses.data(), count, &count), "get_body_impulses");
    for (const rubble_body_impulse& impulse : impulses) {
        const auto found = m_bodies.find(impulse.body);
        if (found == m_bodies.end()) continue;
        Vec3 arm = toVec3(impulse.position);  // Godot wants it from the body's centre, along the world's axes
        const Transform place = kBodyGetState(server, found->second.rid, kTransform).as<Transform>();
        for (size_t i = 0; i < 3; ++i) arm[i] -= place.origin[i];
        kBodyImpulse(server, found->second.rid, arm, toVec3(impulse.impulse));
    }
}

void GodotBodies::tellContacts(rubble_body handle, const Body& body) {
    const Variant direct = kBodyDirectState(singleton("PhysicsServer"), body.rid);
    gd::Object* const state = direct.as<gd::Object*>();
    if (!state) return;
    const int64_t count = kContactCount(state).as<int64_t>();
    for (int64_t i = 0; i < count; ++i) {
        const Vec3 normal = kContactNormal(state, i).as<Vec3>();
        const auto other = m_handles.find(kContactCollider(state, i).ridKey());
        const Body* const hit = other == m_handles.end() ? nullptr : &m_bodies.at(other->second);
        const double speed = (hit ? dot(hit->velocity, normal) : 0.0) - dot(body.velocity, normal);
        const double impulse = kContactImpulse(state, i).as<double>();
        if (speed < kMinHitSpeed || impulse <= 0.0) continue;
        if (hit && hit->moves && other->second < handle) continue;  // the other one tells it
        rubble_impact row = {};
        row.body = handle, row.other = hit ? other->second : 0;
        copy(kContactPosition(state, i).as<Vec3>(), row.position);
        copy(normal, row.normal);
        row.impulse = impulse, row.speed = speed;
        m_impacts.push_back(row);
    }
}

void GodotBodies::tellBody(rubble_body handle, Body& body) {
    gd::Object* const server = singleton("PhysicsServer");
    const bool asleep = kBodyGetState(server, body.rid, kSleeping).as<bool>();
    if (asleep && body.asleep) return;
    body.asleep = asleep;
    rubble_body_state state = {};
    state.body = handle;
    state.flags = asleep ? RUBBLE_BODY_ASLEEP : 0;
    Transform place = kBodyGetState(server, body.rid, kTransform).as<Transform>();
    place.origin = transformPoint(place, {-body.center[0], -body.center[1], -body.center[2]});
    copy(place.origin, state.position);
    toQuaternion(place, state.rotation);
    const Vec3 velocity = asleep ? Vec3{} : kBodyGetState(server, body.rid, kLinear).as<Vec3>();
    copy(velocity, state.velocity);
    if (!asleep) copy(kBodyGetState(server, body.rid, kAngular).as<Vec3>(), state.angular_velocity);
    m_states.push_back(state);
    tellContacts(handle, body);
}

void GodotBodies::tell() {
    m_states.clear(), m_impacts.clear();
    for (auto& [handle, body] : m_bodies)
        if (body.moves) tellBody(handle, body);
    for (const rubble_body_state& state : m_states) m_bodies[state.body].velocity = toVec3(state.velocity);
    const auto count = uint32_t(m_states.size()), hits = uint32_t(m_impacts.size());
    m_owner.check(m_owner.api().set_body_states(m_owner.world(), m_states.data(), count), "set_body_states");
    m_owner.check(m_owner.api().report_impacts(m_owner.world(), m_impacts.data(), hits), "report_impacts");
}

}  // namespace rubble_godot
