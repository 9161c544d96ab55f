#include "tests/abi/refusals/full_world.h"

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

constexpr double kCorners[8] = {-90, -90, -80, -90, -80, -80, -90, -80};

void mustBeOk(rubble_result result) {
    ASSERT_EQ(result, RUBBLE_OK) << api()->get_last_error();
}

}  // namespace

FullWorld::FullWorld(const std::string& level, uint32_t flags) : m_hasPhysics(!(flags & RUBBLE_WORLD_HOST_PHYSICS)) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_SHADOW_DATA | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_PARTICLES | flags;
    mustBeOk(api()->create_world(&settings, &m_world));
    mustBeOk(api()->load_level(m_world, level.c_str(), nullptr));
    mustBeOk(api()->set_undo_limit(m_world, 4));
    m_stale = makeAll(20.0);
    m_live = makeAll(30.0);
    step();
    mustBeOk(api()->remove_joint(m_world, m_stale["rubble_joint"]));
    mustBeOk(api()->remove_light(m_world, m_stale["rubble_light"]));
    mustBeOk(api()->remove_water(m_world, m_stale["rubble_water"]));
    mustBeOk(api()->remove_trigger(m_world, m_stale["rubble_trigger"]));
    if (m_hasPhysics) mustBeOk(api()->remove_character(m_world, m_stale["rubble_character"]));
    mustBeOk(api()->destroy_body(m_world, m_stale["rubble_body"]));
    for (const char* kept : {"rubble_light_group", "rubble_world"}) m_stale.erase(kept);
    mustBeOk(api()->set_tag(m_world, m_live["rubble_body"], "t", "v"));
    step();
    mustBeOk(api()->keep_deltas(m_world, 1));
}

FullWorld::~FullWorld() {
    if (const auto found = m_live.find("rubble_renderer"); found != m_live.end())
        api()->destroy_renderer(found->second);
    api()->destroy_world(m_world);
}

void FullWorld::addRenderer() {
    auto settings = sized<rubble_renderer_settings>();
    settings.preset = "fast", settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    mustBeOk(api()->create_renderer(m_world, &settings, &m_live["rubble_renderer"]));
}

Handles FullWorld::makeAll(double x) {
    Handles out = {{"rubble_world", m_world}};
    auto frame = sized<rubble_body_settings>();
    frame.position[0] = x, frame.position[1] = 50.0;
    mustBeOk(api()->create_body(m_world, &frame, &out["rubble_body"]));
    auto shape = sized<rubble_shape_settings>();
    shape.source = RUBBLE_SHAPE_BOX, shape.body = out["rubble_body"];
    shape.size[0] = shape.size[1] = shape.size[2] = 9;
    mustBeOk(api()->create_shape(m_world, &shape, &out["rubble_shape"]));
    auto rope = sized<rubble_joint_settings>();
    rope.kind = RUBBLE_JOINT_ROPE, rope.shapes[0] = out["rubble_shape"];
    rope.position[0] = x + 0.45, rope.position[1] = 50.85, rope.position[2] = 0.45;
    rope.rope_end[0] = x, rope.rope_end[1] = 53.0;
    mustBeOk(api()->create_joint(m_world, &rope, &out["rubble_joint"]));
    auto light = sized<rubble_light_settings>();
    light.reach = 5.0;
    mustBeOk(api()->create_light(m_world, &light, &out["rubble_light"]));
    auto group = sized<rubble_light_group_settings>();
    mustBeOk(api()->create_light_group(m_world, &group, &out["rubble_light_group"]));
    auto water = sized<rubble_water_settings>();
    water.outline = kCorners, water.outline_count = 4;
    mustBeOk(api()->create_water(m_world, &water, &out["rubble_water"]));
    auto trigger = sized<rubble_trigger_settings>();
    mustBeOk(api()->create_trigger(m_world, &trigger, &out["rubble_trigger"]));
    if (!m_hasPhysics) return out;
    auto character = sized<rubble_character_settings>();
    character.position[0] = x, character.position[2] = 20.0;
    mustBeOk(api()->create_character(m_world, &character, &out["rubble_character"]));
    return out;
}

void FullWorld::step() {
    mustBeOk(api()->step(m_world));
}

uint64_t FullWorld::hash() const {
    uint64_t out = 0;
    EXPECT_EQ(api()->get_state_hash(m_world, &out), RUBBLE_OK) << api()->get_last_error();
    return out;
}

bool FullWorld::isAlive() const {
    uint64_t out = 0;
    return api()->get_state_hash(m_world, &out) == RUBBLE_OK;
}

}  // namespace rubble
