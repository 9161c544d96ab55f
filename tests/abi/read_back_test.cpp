// Setting what was just read changes nothing: not the state, not the copies that hosts keep.
#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

/// Objects of one world whose values are read and set again.
struct Objects {
    rubble_world world = 0;
    rubble_body falling = 0, standing = 0;
    rubble_shape shape = 0;
    rubble_light light = 0;
    rubble_light_group group = 0;
    rubble_joint joint = 0;
    rubble_character character = 0;
};

void expectOk(rubble_result result) {
    EXPECT_EQ(result, RUBBLE_OK) << api()->get_last_error();
}

void setEnvironment(const Objects& o) {
    auto value = sized<rubble_environment>();
    expectOk(api()->get_environment(o.world, &value));
    expectOk(api()->set_environment(o.world, &value));
}
void setLight(const Objects& o) {
    auto value = sized<rubble_light_settings>();
    expectOk(api()->get_light_settings(o.world, o.light, &value));
    expectOk(api()->set_light(o.world, &value));
}
void setLightGroup(const Objects& o) {
    auto state = sized<rubble_light_group_state>();
    expectOk(api()->get_light_group(o.world, o.group, &state));
    auto change = sized<rubble_light_group_change>();
    change.fields = RUBBLE_GROUP_SWITCH | RUBBLE_GROUP_THRESHOLD | RUBBLE_GROUP_SUPPLY;
    change.group = o.group;
    change.on = state.flags & RUBBLE_GROUP_ON ? 1 : 0;
    change.threshold = state.threshold;
    change.supply_shape = state.supply_shape;
    std::copy_n(state.supply_cell, 3, change.supply_cell);
    expectOk(api()->set_light_group(o.world, &change));
}
void setSettings(const Objects& o) {
    auto value = sized<rubble_settings>();
    expectOk(api()->get_settings(o.world, &value));
    expectOk(api()->set_settings(o.world, &value));
}
void setBody(const Objects& o) {
    for (const rubble_body body : {o.falling, o.standing}) {
        rubble_body_state state = {};
        auto properties = sized<rubble_body_properties>();
        expectOk(api()->get_body_state(o.world, body, &state));
        expectOk(api()->get_body_properties(o.world, body, &properties));
        auto change = sized<rubble_body_change>();
        change.fields = RUBBLE_SET_POSE | RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
        change.fields |= body == o.falling ? RUBBLE_SET_VELOCITY | RUBBLE_SET_DYNAMIC : RUBBLE_SET_STATIC;
        change.body = body;
        std::copy_n(state.position, 3, change.position), std::copy_n(state.rotation, 4, change.rotation);
        std::copy_n(state.velocity, 3, change.velocity);
        std::copy_n(state.angular_velocity, 3, change.angular_velocity);
        change.gravity_scale = properties.gravity_scale;
        change.linear_damping = properties.linear_damping, change.angular_damping = properties.angular_damping;
        expectOk(api()->set_body(o.world, &change));
    }
}
void setShape(const Objects& o) {
    auto value = sized<rubble_shape_properties>();
    expectOk(api()->get_shape_properties(o.world, o.shape, &value));
    std::vector<rubble_cell_box> anchors(value.anchor_count);
    uint32_t count = 0;
    expectOk(api()->get_anchors(o.world, o.shape, anchors.data(), value.anchor_count, &count));
    auto change = sized<rubble_shape_change>();
    change.fields =
        RUBBLE_SHAPE_STRENGTH | RUBBLE_SHAPE_DENSITY | RUBBLE_SHAPE_EMISSION | RUBBLE_SHAPE_LOAD | RUBBLE_SHAPE_ANCHORS;
    change.shape = o.shape;
    change.strength = value.strength, change.density = value.density, change.emission = value.emission;
    change.bears_load = value.bears_load;
    change.anchor_count = count;
    change.anchors = anchors.data();
    expectOk(api()->set_shape(o.world, &change));
}
void setCollisionFilter(const Objects& o) {
    auto value = sized<rubble_shape_properties>();
    expectOk(api()->get_shape_properties(o.world, o.shape, &value));
    auto filter = sized<rubble_collision_filter>();
    filter.shape = o.shape, filter.layer = value.collision_layer, filter.mask = value.collision_mask;
    expectOk(api()->set_collision_filter(o.world, &filter));
}
void setCollisionShape(const Objects& o) {
    auto value = sized<rubble_shape_properties>();
    expectOk(api()->get_shape_properties(o.world, o.shape, &value));
    auto shape = sized<rubble_collision_shape>();
    shape.shape = o.shape, shape.kind = value.collision_shape;
    expectOk(api()->set_collision_shape(o.world, &shape));
}
void setPalette(const Objects& o) {
    auto range = sized<rubble_palette_range>();
    range.shape = o.shape, range.count = 255, range.entry_size = sizeof(rubble_palette_entry);
    std::vector<rubble_palette_entry> entries(255);
    expectOk(api()->get_palette(o.world, &range, entries.data()));
    expectOk(api()->set_palette(o.world, &range, entries.data()));
}
void setMaterials(const Objects& o) {
    uint32_t count = 0;
    expectOk(api()->get_material_count(o.world, &count));
    std::vector<rubble_material> rows(count, sized<rubble_material>());
    for (uint32_t i = 0; i < count; ++i) expectOk(api()->get_material(o.world, i, &rows[i]));
    expectOk(api()->set_materials(o.world, 1, rows.data() + 1, count - 1));
}
void setName(const Objects& o) {
    char name[64];
    uint32_t count = 0;
    expectOk(api()->get_name(o.world, o.shape, name, sizeof name, &count));
    expectOk(api()->set_name(o.world, o.shape, name));
}
void setTag(const Objects& o) {
    char value[64];
    uint32_t count = 0;
    expectOk(api()->get_tag(o.world, o.shape, "tag", value, sizeof value, &count));
    expectOk(api()->set_tag(o.world, o.shape, "tag", value));
}
void setUserValue(const Objects& o) {
    uint64_t value = 0;
    expectOk(api()->get_user_value(o.world, o.shape, &value));
    expectOk(api()->set_user_value(o.world, o.shape, value));
}
void setJointMotor(const Objects& o) {
    auto value = sized<rubble_joint_properties>();
    expectOk(api()->get_joint_properties(o.world, o.joint, &value));
    auto motor = sized<rubble_joint_motor>();
    motor.joint = o.joint, motor.motor = value.motor;
    motor.motor_target = value.motor_target, motor.motor_max_force = value.motor_max_force;
    motor.friction = value.friction, motor.steer_angle = value.steer_angle;
    expectOk(api()->set_joint_motor(o.world, &motor));
}
void setHostData(const Objects& o) {
    std::array<uint8_t, 16> bytes{}, again{};
    uint64_t count = 0, sameCount = 0;
    expectOk(api()->get_host_data(o.world, "data", bytes.data(), bytes.size(), &count));
    expectOk(api()->set_host_data(o.world, "data", bytes.data(), count));
    expectOk(api()->get_host_data(o.world, "data", again.data(), again.size(), &sameCount));
    EXPECT_EQ(sameCount, 3u);
    EXPECT_EQ(again, bytes) << "no hash is of it";
}
void setLevelScripts(const Objects& o) {
    rubble_level_script rows[2] = {};
    uint32_t count = 0;
    expectOk(api()->get_level_scripts(o.world, rows, 2, &count));
    EXPECT_EQ(count, 2u);
    expectOk(api()->set_level_scripts(o.world, rows, count));
}
void writeVoxels(const Objects& o) {
    auto box = sized<rubble_voxel_box>();
    box.shape = o.shape;
    std::fill_n(box.size, 3, 8);
    std::vector<uint8_t> voxels(512);
    uint64_t count = 0;
    expectOk(api()->read_voxels(o.world, &box, voxels.data(), voxels.size(), &count));
    expectOk(api()->write_voxels(o.world, &box, voxels.data(), count));
}

/// Functions that set what another one reads, and how that is set again.
const std::map<std::string, std::function<void(const Objects&)>> kPairs = {
    {"set_environment", setEnvironment},
    {"set_light", setLight},
    {"set_light_group", setLightGroup},
    {"set_settings", setSettings},
    {"set_body", setBody},
    {"set_shape", setShape},
    {"set_collision_filter", setCollisionFilter},
    {"set_collision_shape", setCollisionShape},
    {"set_palette", setPalette},
    {"set_materials", setMaterials},
    {"set_name", setName},
    {"set_tag", setTag},
    {"set_user_value", setUserValue},
    {"set_joint_motor", setJointMotor},
    {"set_host_data", setHostData},
    {"set_level_scripts", setLevelScripts},
    {"write_voxels", writeVoxels},
};
/// Other functions that set something, and why they are in no pair.
const std::map<std::string, std::string> kAlone = {
    {"set_host", "nothing reads the host's services"},
    {"set_bounds", "bounds that follow what there is are read as they are now; to set those holds them"},
    {"set_overlay", "of a renderer"},
    {"set_overlay_image", "of a renderer"},
    {"set_undo_limit", "nothing reads the limit"},
    {"set_debug_view", "of a renderer"},
    {"set_body_states", "of worlds that the host's physics moves: HostPhysics tests it"},
    {"set_physics_threads", "nothing reads the number, and nothing depends on it"},
    {"set_report_filter", "nothing reads the filter"},
};

rubble_character makeCharacter(rubble_world world) {
    auto settings = sized<rubble_character_settings>();
    settings.position[0] = 5.0, settings.position[1] = 3.0;
    rubble_character made = 0;
    expectOk(api()->create_character(world, &settings, &made));
    return made;
}

rubble_body makeBox(rubble_world world, uint32_t flags, double x, rubble_shape* made) {
    auto body = sized<rubble_body_settings>();
    body.flags = flags;
    body.position[0] = x, body.position[1] = 40.0;
    const double rotation[4] = {0.3, 0.2, 0.1, 0.927};  // of length 1 after rounding alone
    std::copy_n(rotation, 4, body.rotation);
    if (!flags) body.velocity[0] = 0.3, body.angular_velocity[1] = 0.7;
    rubble_body out = 0;
    expectOk(api()->create_body(world, &body, &out));
    auto shape = sized<rubble_shape_settings>();
    shape.body = out, shape.source = RUBBLE_SHAPE_BOX, shape.index = 6, shape.rotation[3] = 1.0;
    std::fill_n(shape.size, 3, 20);
    expectOk(api()->create_shape(world, &shape, made));
    return out;
}

/// A hinge with a motor between a body and the world.
rubble_joint makeHinge(rubble_world world) {
    rubble_shape shape = 0;
    makeBox(world, 0, 20.0, &shape);
    auto joint = sized<rubble_joint_settings>();
    joint.kind = RUBBLE_JOINT_HINGE, joint.shapes[0] = shape, joint.anchor_radius = 1.0;
    joint.position[0] = 20.2, joint.position[1] = 40.2, joint.position[2] = 0.2;
    joint.motor = RUBBLE_MOTOR_SPEED, joint.motor_target = 0.7, joint.motor_max_force = 1e4, joint.friction = 0.3;
    rubble_joint made = 0;
    expectOk(api()->create_joint(world, &joint, &made));
    return made;
}

Objects makeObjects(rubble_world world) {
    Objects o = {.world = world};
    rubble_shape fallen = 0;
    o.falling = makeBox(world, 0, 10.0, &fallen);
    o.standing = makeBox(world, RUBBLE_BODY_STATIC, -10.0, &o.shape);
    o.joint = makeHinge(world);
    o.character = makeCharacter(world);
    const uint8_t data[3] = {1, 2, 3};
    expectOk(api()->set_host_data(world, "data", data, sizeof data));
    const rubble_level_script scripts[2] = {{"lift.lua", "speed=2"}, {"door.lua", ""}};
    expectOk(api()->set_level_scripts(world, scripts, 2));
    auto group = sized<rubble_light_group_settings>();
    group.threshold = 0.3;
    expectOk(api()->create_light_group(world, &group, &o.group));
    auto light = sized<rubble_light_settings>();
    light.kind = RUBBLE_LIGHT_AREA, light.flags = RUBBLE_LIGHT_ENABLED, light.shape = o.shape, light.group = o.group;
    light.rotation[0] = 0.3, light.rotation[1] = 0.2, light.rotation[2] = 0.1, light.rotation[3] = 0.927;
    light.color[0] = 0.1, light.color[1] = 0.7, light.radius = 0.1, light.reach = 3.3;
    light.width = 0.7, light.height = 0.3;
    expectOk(api()->create_light(world, &light, &o.light));
    auto environment = sized<rubble_environment>();
    expectOk(api()->get_environment(world, &environment));
    const double sun[3] = {0.05, 0.7, -0.5};  // divided by its length once and twice: two vectors of floats
    std::copy_n(sun, 3, environment.sun_direction);
    expectOk(api()->set_environment(world, &environment));
    expectOk(api()->step(world));
    expectOk(api()->set_name(world, o.shape, "name"));
    expectOk(api()->set_tag(world, o.shape, "tag", "value"));
    expectOk(api()->set_user_value(world, o.shape, 7));
    auto density = sized<rubble_shape_change>();
    density.shape = o.shape, density.fields = RUBBLE_SHAPE_DENSITY | RUBBLE_SHAPE_STRENGTH;
    density.density = 1.3, density.strength = 0.7;
    expectOk(api()->set_shape(world, &density));
    for (int i = 0; i < 30; ++i) expectOk(api()->step(world));
    return o;
}

uint64_t stateOf(rubble_world world) {
    uint64_t out = 0;
    expectOk(api()->get_state_hash(world, &out));
    return out;
}

/// The version of a shape's meshes; counts the questions that could not be answered.
uint64_t followMeshes(const Objects& o, uint64_t since, int& stale, uint32_t& bricks) {
    auto changes = sized<rubble_brick_changes>();
    changes.shape = o.shape, changes.what = RUBBLE_BRICKS_MESHES, changes.since = since;
    uint64_t version = 0;
    stale += api()->get_changed_bricks(o.world, &changes, &version, nullptr, 0, &bricks) != RUBBLE_OK;
    return version;
}

class ReadBack : public Abi, public testing::WithParamInterface<std::string> {};

TEST_P(ReadBack, ChangesNothing) {
    const rubble_world other = makeWorld();
    const Objects set = makeObjects(m_world);
    makeObjects(other);
    ASSERT_EQ(stateOf(m_world), stateOf(other));
    int stale = 0;
    uint32_t bricks = 0;
    const uint64_t version = followMeshes(set, 0, stale, bricks);
    kPairs.at(GetParam())(set);
    expectOk(api()->step(m_world));
    expectOk(api()->step(other));
    EXPECT_EQ(stateOf(m_world), stateOf(other));
    followMeshes(set, version, stale, bricks);
    EXPECT_EQ(stale, 0) << "a host would mesh the whole shape again";
    EXPECT_EQ(bricks, 0u);
    auto events = sized<rubble_events>();
    expectOk(api()->get_events(m_world, &events));
    EXPECT_EQ(events.shapes_created_count + events.shapes_destroyed_count, 0u);
    api()->destroy_world(other);
}

std::vector<std::string> names() {
    std::vector<std::string> out;
    for (const auto& [name, set] : kPairs) out.push_back(name);
    return out;
}
INSTANTIATE_TEST_SUITE_P(Pairs, ReadBack, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& pair) { return pair.param; });

TEST(ReadBackTable, HasAllFunctionsThatSet) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/runtime/plugin/include/rubble/rubble.h");
    std::stringstream header;
    header << file.rdbuf();
    const std::string text = header.str();
    const std::regex function(R"(\(\*(set_\w+)\)\()");
    int count = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), function), end; i != end; ++i, ++count)
        EXPECT_TRUE(kPairs.contains((*i)[1]) || kAlone.contains((*i)[1]))
            << (*i)[1] << ": how is what it sets read? Add a pair";
    EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace rubble
