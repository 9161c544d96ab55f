#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/allocation_count.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

TEST_F(AbiCreate, AJointOfTwoNewShapesIsPlacedWhereTheyAreThen) {
    const rubble_body post = make(bodyAt(20.0, 0.0, RUBBLE_BODY_STATIC)), arm = make(bodyAt(0.0, 0.0, 0));
    const rubble_shape upright = make(shapeOn(post, RUBBLE_SHAPE_BOX, 20)),
                       beam = make(shapeOn(arm, RUBBLE_SHAPE_BOX, 8));
    auto change = sized<rubble_body_change>();
    change.body = arm, change.fields = RUBBLE_SET_POSE;
    change.position[0] = 22.0, change.position[1] = 1.0, change.position[2] = 0.6;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    auto settings = sized<rubble_joint_settings>();
    settings.kind = RUBBLE_JOINT_FIXED;
    settings.shapes[0] = upright, settings.shapes[1] = beam;
    settings.position[0] = 22.0, settings.position[1] = 1.4, settings.position[2] = 1.0;
    rubble_joint joint = 0;
    ASSERT_EQ(api()->create_joint(m_world, &settings, &joint), RUBBLE_OK) << api()->get_last_error();
    auto motor = sized<rubble_joint_motor>();
    motor.joint = joint;
    ASSERT_EQ(api()->set_joint_motor(m_world, &motor), RUBBLE_OK) << api()->get_last_error();
    step(60);
    rubble_joint_state row = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_joint_states(m_world, &row, 1, &count), RUBBLE_OK);
    EXPECT_EQ(row.joint, joint);
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(row.first_anchor[a], settings.position[a], 0.01);
        EXPECT_NEAR(row.second_anchor[a], settings.position[a], 0.02) << "it holds the beam where it was placed";
    }
    settings.position[1] = 40.0;
    rubble_joint nowhere = 0;
    ASSERT_EQ(api()->create_joint(m_world, &settings, &nowhere), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(refusals().size(), 1u);
    EXPECT_EQ(refusals()[0].handle, nowhere);
    EXPECT_EQ(refusals()[0].reason, std::string("add_joint: no voxel to hold on to within the radius of an end"));
    EXPECT_TRUE(isStale(nowhere));
}

TEST_F(AbiCreate, LightsWatersTriggersAndCharactersHaveTheirHandlesAtOnce) {
    const rubble_body body = make(bodyAt(20.0, 5.0, RUBBLE_BODY_STATIC));
    const rubble_shape shape = make(shapeOn(body, RUBBLE_SHAPE_BOX, 4));
    auto bulb = sized<rubble_light_settings>();
    bulb.shape = shape, bulb.flags = RUBBLE_LIGHT_ENABLED, bulb.color[0] = 1.0, bulb.reach = 5.0;
    rubble_light light = 0;
    ASSERT_EQ(api()->create_light(m_world, &bulb, &light), RUBBLE_OK) << api()->get_last_error();
    bulb.light = light, bulb.reach = 7.0;
    ASSERT_EQ(api()->set_light(m_world, &bulb), RUBBLE_OK) << api()->get_last_error();
    const double corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    auto pool = sized<rubble_water_settings>();
    pool.outline = corners, pool.outline_count = 4;
    rubble_water water = 0, drained = 0;
    ASSERT_EQ(api()->create_water(m_world, &pool, &drained), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->create_water(m_world, &pool, &water), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->remove_water(m_world, drained), RUBBLE_OK) << api()->get_last_error();
    auto region = sized<rubble_trigger_settings>();
    rubble_trigger trigger = 0;
    ASSERT_EQ(api()->create_trigger(m_world, &region, &trigger), RUBBLE_OK) << api()->get_last_error();
    auto walker = sized<rubble_character_settings>();
    walker.position[1] = 3.0;
    rubble_character character = 0;
    ASSERT_EQ(api()->create_character(m_world, &walker, &character), RUBBLE_OK) << api()->get_last_error();
    auto teleport = sized<rubble_character_teleport>();
    teleport.character = character, teleport.position[0] = 30.0, teleport.position[1] = 8.0;
    ASSERT_EQ(api()->teleport_character(m_world, &teleport), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_TRUE(refusals().empty());
    auto known = sized<rubble_light_settings>();
    ASSERT_EQ(api()->get_light_settings(m_world, light, &known), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(known.reach, 7.0);
    EXPECT_EQ(known.shape, shape);
    uint64_t handle = 0;
    uint32_t count = 0;
    ASSERT_EQ(api()->get_waters(m_world, &handle, 1, &count), RUBBLE_OK);
    EXPECT_EQ(handle, water);
    ASSERT_EQ(api()->get_triggers(m_world, &handle, 1, &count), RUBBLE_OK);
    EXPECT_EQ(handle, trigger);
    rubble_character_state row = {};
    ASSERT_EQ(api()->get_character_states(m_world, &row, 1, &count), RUBBLE_OK);
    EXPECT_EQ(row.character, character);
    EXPECT_NEAR(row.position[0], 30.0, 0.1);
    EXPECT_TRUE(isStale(drained));
}

TEST_F(AbiCreate, ALightOnADestroyedShapeIsRefused) {
    const rubble_body body = make(bodyAt(20.0, 5.0, RUBBLE_BODY_STATIC));
    auto bulb = sized<rubble_light_settings>();
    bulb.shape = make(shapeOn(body, RUBBLE_SHAPE_BOX, 4));
    ASSERT_EQ(api()->destroy_shape(m_world, bulb.shape), RUBBLE_OK) << api()->get_last_error();
    rubble_light light = 0;
    ASSERT_EQ(api()->create_light(m_world, &bulb, &light), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(refusals().size(), 1u);
    EXPECT_EQ(refusals()[0].handle, light);
    EXPECT_TRUE(isStale(light));
    uint64_t added = 1;
    uint32_t count = 0;
    ASSERT_EQ(api()->get_added_lights(m_world, &added, 1, &count), RUBBLE_OK);
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(added, 0u);
}

/// In a world that is drawn too: what is static there is in the shadow volume.
TEST_F(AbiCreate, ABodyIsMadeStaticAndFree) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_SHADOW_INLINE;
    const rubble_world undrawn = m_world;
    rubble_world drawn = 0;
    ASSERT_EQ(api()->create_world(&settings, &drawn), RUBBLE_OK);
    std::vector<uint64_t> hashes;
    for (const rubble_world world : {drawn, undrawn}) {
        m_world = world;
        ASSERT_EQ(api()->load_level(world, s_level.c_str(), nullptr), RUBBLE_OK);
        ASSERT_EQ(api()->set_undo_limit(world, 3), RUBBLE_OK);
        const rubble_body crate = make(bodyAt(8.0, 10.0, 0));
        const rubble_shape shape = make(shapeOn(crate, RUBBLE_SHAPE_BOX, 8));
        step(10);
        ASSERT_EQ(api()->add_undo_mark(world), RUBBLE_OK);
        auto change = sized<rubble_body_change>();
        change.body = crate, change.fields = RUBBLE_SET_STATIC;
        ASSERT_EQ(api()->set_body(world, &change), RUBBLE_OK) << api()->get_last_error();
        step();
        const double height = bodyState(crate).position[1];
        step(30);
        EXPECT_EQ(bodyState(crate).position[1], height) << "it hangs where it was";
        EXPECT_TRUE(bodyState(crate).flags & RUBBLE_BODY_STATIC);
        EXPECT_EQ(state(shape).voxel_count, 512u);
        const rubble_body ball = make(bodyAt(8.2, height + 1.0, 0));
        make(shapeOn(ball, RUBBLE_SHAPE_BOX, 4));
        step(60);
        EXPECT_NEAR(bodyState(ball).position[1], height + 0.8, 0.03) << "it bears what falls onto it";
        change.fields = RUBBLE_SET_DYNAMIC | RUBBLE_SET_VELOCITY;
        change.velocity[0] = 1.0;
        ASSERT_EQ(api()->set_body(world, &change), RUBBLE_OK) << api()->get_last_error();
        step(20);
        EXPECT_LT(bodyState(crate).position[1], height - 0.1);
        EXPECT_LT(bodyState(ball).position[1], height + 0.7) << "what lay on it falls";
        EXPECT_FALSE(bodyState(crate).flags & RUBBLE_BODY_STATIC);
        hashes.push_back(hash());
        ASSERT_EQ(api()->undo(world), RUBBLE_OK);
        step(10);
        EXPECT_FALSE(bodyState(crate).flags & RUBBLE_BODY_STATIC);
        ASSERT_EQ(api()->redo(world), RUBBLE_OK);
        step();
        change.fields = RUBBLE_SET_STATIC | RUBBLE_SET_AWAKE;
        expectRefused(api()->set_body(world, &change), RUBBLE_ERROR_ARGUMENT, "the body is static");
        change.fields = RUBBLE_SET_STATIC | RUBBLE_SET_DYNAMIC;
        expectRefused(api()->set_body(world, &change), RUBBLE_ERROR_ARGUMENT, "expected one of them");
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    m_world = undrawn;
    EXPECT_EQ(api()->destroy_world(drawn), RUBBLE_OK);
}

TEST_F(AbiCreate, UndoMakesAStaticBodyFreeAgain) {
    ASSERT_EQ(api()->set_undo_limit(m_world, 3), RUBBLE_OK);
    const rubble_body crate = make(bodyAt(8.0, 50.0, 0));
    make(shapeOn(crate, RUBBLE_SHAPE_BOX, 8));
    step(5);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    auto change = sized<rubble_body_change>();
    change.body = crate, change.fields = RUBBLE_SET_STATIC;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    step(2);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step(10);
    EXPECT_FALSE(bodyState(crate).flags & RUBBLE_BODY_STATIC);
    EXPECT_LT(bodyState(crate).velocity[1], -1.0) << "it falls";
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    step();
    const double height = bodyState(crate).position[1];
    step(10);
    EXPECT_EQ(bodyState(crate).position[1], height);
}

/// A world without a level, with a block at the origin that is then put 300 m away.
class AbiMadeWorld : public AbiCreate {
protected:
    void SetUp() override {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK) << api()->get_last_error();
    }
    void makeBlock(uint32_t flags) {
        m_block = make(bodyAt(0.0, 0.0, flags));
        make(shapeOn(m_block, RUBBLE_SHAPE_BOX, 4));
    }
    void putAway() {
        auto change = sized<rubble_body_change>();
        change.body = m_block, change.fields = RUBBLE_SET_POSE, change.position[0] = 300.0;
        ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    }
    void applyEdits() { ASSERT_EQ(api()->apply_edits(m_world), RUBBLE_OK) << api()->get_last_error(); }
    double end() {
        auto bounds = sized<rubble_bounds>();
        EXPECT_EQ(api()->get_bounds(m_world, &bounds), RUBBLE_OK);
        return bounds.high[0];
    }
    rubble_body m_block = 0;
};

TEST_F(AbiMadeWorld, ReachesToWhereTheStepPutsWhatItMakes) {
    makeBlock(0);
    putAway();
    step(3);
    EXPECT_FALSE(isStale(m_block)) << "it became dust";
    EXPECT_NEAR(end(), 300.4 + 128.0, 1e-6);
}

TEST_F(AbiMadeWorld, ReachesToWhereAStaticBodyIsMoved) {
    makeBlock(RUBBLE_BODY_STATIC);
    step();
    putAway();
    step();
    EXPECT_NEAR(end(), 300.4 + 0.5 * 300.4, 1e-4);
    auto change = sized<rubble_shape_change>();
    change.shape = shapes().at(0).shape, change.fields = RUBBLE_SHAPE_ANCHORS;  // nothing holds it
    ASSERT_EQ(api()->set_shape(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    step(3);
    EXPECT_EQ(shapes().size(), 1u) << "what comes off it became dust";
}

TEST_F(AbiMadeWorld, ReachesToWhereAnEditorPutsAFreeBody) {
    makeBlock(0);
    applyEdits();
    putAway();
    applyEdits();
    step(3);
    EXPECT_FALSE(isStale(m_block)) << "it became dust";
}

TEST_F(AbiMadeWorld, IsLeftByAFreeBodyThatAStepPutsAway) {
    makeBlock(0);
    step();
    putAway();
    step(3);
    EXPECT_TRUE(isStale(m_block));
}

class AbiPrefab : public AbiCreate {
protected:
    std::vector<rubble_prefab_row> place(const rubble_prefab& prefab) {
        uint32_t count = 0;
        EXPECT_EQ(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        std::vector<rubble_prefab_row> rows(count);
        EXPECT_EQ(api()->create_prefab(m_world, &prefab, rows.data(), count, &count), RUBBLE_OK)
            << api()->get_last_error();
        return rows;
    }
    /// The bytes of the test level.
    static std::vector<char> levelBytes() {
        std::ifstream file(s_level, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

TEST_F(AbiPrefab, ALevelIsPlacedAsOftenAsWanted) {
    const std::vector<char> bytes = levelBytes();
    for (int i = 1; i < 4; ++i) {
        auto prefab = sized<rubble_prefab>();
        prefab.position[0] = 5.0 * i;
        prefab.rotation[1] = prefab.rotation[3] = 0.7071067811865476;
        if (i == 1)
            prefab.path = s_level.c_str();
        else
            prefab.data = bytes.data(), prefab.size = bytes.size();
        const std::vector<rubble_prefab_row> rows = place(prefab);
        ASSERT_EQ(rows.size(), 3u) << "a body, its shape and a light";
        EXPECT_EQ(rows[0].kind, uint32_t(RUBBLE_PREFAB_BODY));
        EXPECT_EQ(rows[1].kind, uint32_t(RUBBLE_PREFAB_SHAPE));
        EXPECT_EQ(rows[1].owner, 0u);
        EXPECT_EQ(rows[2].kind, uint32_t(RUBBLE_PREFAB_LIGHT));
        step();
        EXPECT_EQ(bodyState(rows[0].handle).position[0], 5.0 * i);
        EXPECT_EQ(state(rows[1].handle).body, rows[0].handle);
        EXPECT_EQ(state(rows[1].handle).voxel_count, 650u);
        auto light = sized<rubble_light_settings>();
        ASSERT_EQ(api()->get_light_settings(m_world, rows[2].handle, &light), RUBBLE_OK);
        EXPECT_NEAR(light.position[0], 5.0 * i + 1.0, 1e-9);
        EXPECT_NEAR(light.position[2], -1.0, 1e-9);
    }
    EXPECT_EQ(shapes().size(), 4u);
}

TEST_F(AbiPrefab, IsRecorded) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog";
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    auto prefab = sized<rubble_prefab>();
    prefab.path = s_level.c_str(), prefab.position[1] = 4.0;
    place(prefab);
    step(3);
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    const uint64_t end = hash();
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 3u);
    EXPECT_EQ(hash(), end);
}

TEST_F(AbiPrefab, IsReadOnceAndAgainWhereItsFileHasChanged) {
    const TempFolder folder;
    const std::string path = folder / "model.rubble";
    const std::vector<char> bytes = levelBytes();
    const auto write = [&](const std::vector<char>& content) {
        std::ofstream(path, std::ios::binary).write(content.data(), std::streamsize(content.size()));
    };
    auto prefab = sized<rubble_prefab>();
    prefab.path = path.c_str();
    rubble_result result = RUBBLE_OK;
    const auto ask = [&] {
        uint32_t count = 0;
        const size_t before = allocationCount();
        result = api()->create_prefab(m_world, &prefab, nullptr, 0, &count);
        return allocationCount() - before;
    };
    write(bytes);
    const size_t first = ask(), again = ask();
    EXPECT_EQ(result, RUBBLE_OK) << api()->get_last_error();
    EXPECT_LT(4 * again, first) << "allocations";
    write({'n', 'o'});
    ask();
    EXPECT_EQ(result, RUBBLE_ERROR_FILE) << "another content is read";
    prefab.path = nullptr, prefab.data = bytes.data(), prefab.size = bytes.size();
    EXPECT_LT(4 * ask(), first) << "from memory it is the same one";
    EXPECT_EQ(place(prefab).size(), 3u);
    step();
    EXPECT_EQ(shapes().size(), 2u);
}

TEST_F(AbiPrefab, BringsItsScriptsInItsStep) {
    const TempFolder folder;
    const std::string path = folder / "scripted.rubble", log = folder / "game.rubblelog";
    const rubble_level_script lift = {"lift.lua", "speed=2"};
    const auto names = [&] {
        rubble_level_script rows[4] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_level_scripts(m_world, rows, 4, &count), RUBBLE_OK);
        std::string all;
        for (uint32_t i = 0; i < count; ++i) all += std::string(rows[i].path) + " " + rows[i].parameters + ";";
        return all;
    };
    ASSERT_EQ(api()->set_level_scripts(m_world, &lift, 1), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->save_level(m_world, path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    auto prefab = sized<rubble_prefab>();
    prefab.path = path.c_str(), prefab.position[1] = 4.0;
    place(prefab);
    EXPECT_EQ(names(), "lift.lua speed=2;");
    step(3);
    EXPECT_EQ(names(), "lift.lua speed=2;lift.lua speed=2;");
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    const uint64_t end = hash();
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(names(), "lift.lua speed=2;lift.lua speed=2;") << "a replay has them too";
}

TEST_F(AbiPrefab, SaysWhatIsWrong) {
    auto prefab = sized<rubble_prefab>();
    uint32_t count = 9;
    expectRefused(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_ERROR_NULL, "data");
    EXPECT_EQ(count, 0u);
    prefab.data = "no level", prefab.size = 8;
    expectRefused(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_ERROR_FILE, "data");
    prefab.path = "no/such/file.rubble";
    expectRefused(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_ERROR_FILE, "no/such/file");
    prefab.path = s_level.c_str();
    rubble_prefab_row row = {};
    expectRefused(api()->create_prefab(m_world, &prefab, &row, 1, &count), RUBBLE_ERROR_CAPACITY, "holds 1");
    EXPECT_EQ(count, 3u);
    expectRefused(api()->create_prefab(m_world, &prefab, nullptr, 3, &count), RUBBLE_ERROR_NULL, "out");
    prefab.position[0] = 1e10;
    expectRefused(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT, "position[0]");
    step();
    EXPECT_EQ(shapes().size(), 1u) << "nothing was placed";
}

}  // namespace
}  // namespace rubble
