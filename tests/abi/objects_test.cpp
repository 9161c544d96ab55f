#include <algorithm>
#include <string>
#include <vector>

#include "runtime/world/world.h"
#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiObjects : public Abi {
protected:
    std::string name(uint64_t object) {
        char text[64] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_name(m_world, object, text, sizeof text, &count), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(count, std::string(text).size() + 1);
        return text;
    }
    /// "none" without the tag.
    std::string tag(uint64_t object, const char* tag) {
        char text[64] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_tag(m_world, object, tag, text, sizeof text, &count), RUBBLE_OK);
        return count ? text : "none";
    }
    uint64_t userValue(uint64_t object) {
        uint64_t out = 1;
        EXPECT_EQ(api()->get_user_value(m_world, object, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    std::vector<uint64_t> objects(uint32_t kind) {
        uint64_t rows[256];
        uint32_t count = 0;
        EXPECT_EQ(api()->get_objects(m_world, kind, rows, 256, &count), RUBBLE_OK) << api()->get_last_error();
        return {rows, rows + count};
    }
    std::vector<uint64_t> withTag(uint32_t kind, const char* tag, const char* value) {
        uint64_t rows[256];
        uint32_t count = 0;
        EXPECT_EQ(api()->find_by_tag(m_world, kind, tag, value, rows, 256, &count), RUBBLE_OK);
        return {rows, rows + count};
    }
    std::vector<uint64_t> pieces(rubble_shape shape) {
        uint64_t rows[256];
        uint32_t count = 0;
        EXPECT_EQ(api()->get_pieces(m_world, shape, rows, 256, &count), RUBBLE_OK) << api()->get_last_error();
        return {rows, rows + count};
    }
    void breakTable() {
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
        step();
    }
    rubble_settings settings() {
        auto out = sized<rubble_settings>();
        EXPECT_EQ(api()->get_settings(m_world, &out), RUBBLE_OK);
        return out;
    }
};

TEST_F(AbiObjects, NamesOfTheLevelAreThereAndCanBeChanged) {
    const uint64_t body = objects(RUBBLE_KIND_BODY).at(0), shape = objects(RUBBLE_KIND_SHAPE).at(0);
    const uint64_t light = objects(RUBBLE_KIND_LIGHT).at(0);
    EXPECT_EQ(name(body), "table");
    EXPECT_EQ(name(light), "light");
    for (const uint64_t object : {body, shape, light})
        ASSERT_EQ(api()->set_name(m_world, object, "Tür"), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(name(shape), "table") << "an edit waits for its step";
    step();
    for (const uint64_t object : {body, shape, light}) EXPECT_EQ(name(object), "Tür");
    uint64_t found = 0;
    uint32_t count = 0;
    ASSERT_EQ(api()->find_by_name(m_world, RUBBLE_KIND_LIGHT, "Tür", &found, 1, &count), RUBBLE_OK);
    EXPECT_EQ(found, light);
    ASSERT_EQ(api()->find_by_name(m_world, RUBBLE_KIND_LIGHT, "light", nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    char small[3];
    expectRefused(api()->get_name(m_world, body, small, 3, &count), RUBBLE_ERROR_CAPACITY, "there are 5 bytes");
    expectRefused(api()->set_name(m_world, body, "\xff"), RUBBLE_ERROR_ARGUMENT, "name");
    expectRefused(api()->set_name(m_world, body, nullptr), RUBBLE_ERROR_NULL, "name is null");
    expectRefused(api()->set_name(m_world, m_world, "x"), RUBBLE_ERROR_STALE, "object is stale");
    expectRefused(api()->set_name(m_world, body, std::string(5000, 'x').c_str()), RUBBLE_ERROR_ARGUMENT, "5000");
}

TEST_F(AbiObjects, TagsHaveValuesAndAreFound) {
    const uint64_t shape = objects(RUBBLE_KIND_SHAPE).at(0);
    ASSERT_EQ(api()->set_tag(m_world, shape, "door", nullptr), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->set_tag(m_world, shape, "key", "red"), RUBBLE_OK);
    step();
    EXPECT_EQ(tag(shape, "door"), "");
    EXPECT_EQ(tag(shape, "key"), "red");
    EXPECT_EQ(tag(shape, "lock"), "none");
    EXPECT_EQ(withTag(RUBBLE_KIND_SHAPE, "key", nullptr), std::vector{shape});
    EXPECT_EQ(withTag(RUBBLE_KIND_SHAPE, "key", "red"), std::vector{shape});
    EXPECT_TRUE(withTag(RUBBLE_KIND_SHAPE, "key", "blue").empty());
    EXPECT_TRUE(withTag(RUBBLE_KIND_BODY, "key", nullptr).empty());
    char all[64];
    uint32_t count = 0;
    ASSERT_EQ(api()->get_tags(m_world, shape, all, sizeof all, &count), RUBBLE_OK);
    EXPECT_EQ(std::string(all, count), std::string("door\0key=red\0", 13));
    ASSERT_EQ(api()->set_tag(m_world, shape, "key", "blue"), RUBBLE_OK);
    ASSERT_EQ(api()->remove_tag(m_world, shape, "door"), RUBBLE_OK);
    step();
    EXPECT_EQ(tag(shape, "key"), "blue");
    EXPECT_EQ(tag(shape, "door"), "none");
    expectRefused(api()->set_tag(m_world, shape, "a=b", nullptr), RUBBLE_ERROR_ARGUMENT, "tag");
    expectRefused(api()->remove_tag(m_world, shape, ""), RUBBLE_ERROR_ARGUMENT, "at least one byte");
    expectRefused(api()->find_by_tag(m_world, RUBBLE_KIND_WATER, nullptr, nullptr, nullptr, 0, &count),
                  RUBBLE_ERROR_NULL, "tag is null");
    expectRefused(api()->find_by_name(m_world, RUBBLE_KIND_WATER, nullptr, nullptr, 0, &count), RUBBLE_ERROR_NULL,
                  "name is null");
    expectRefused(api()->get_objects(m_world, 8, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT, "kind is 8");
}

TEST_F(AbiObjects, WhatBelongsToAnObjectIsListed) {
    const uint64_t body = objects(RUBBLE_KIND_BODY).at(0), shape = objects(RUBBLE_KIND_SHAPE).at(0);
    auto joint = sized<rubble_joint_settings>();
    joint.kind = RUBBLE_JOINT_HINGE, joint.shapes[0] = shape;
    joint.position[0] = joint.position[2] = 0.85, joint.position[1] = 0.95;
    ASSERT_EQ(api()->add_joint(m_world, &joint), RUBBLE_OK) << api()->get_last_error();
    auto light = sized<rubble_light_settings>();
    light.shape = shape;
    ASSERT_EQ(api()->add_light(m_world, &light), RUBBLE_OK) << api()->get_last_error();
    step();
    const auto of = [&](uint64_t owner, uint32_t kind) {
        uint64_t rows[8];
        uint32_t count = 0;
        EXPECT_EQ(api()->get_objects_of(m_world, owner, kind, rows, 8, &count), RUBBLE_OK) << api()->get_last_error();
        return std::vector<uint64_t>(rows, rows + count);
    };
    EXPECT_EQ(of(body, RUBBLE_KIND_SHAPE), std::vector{shape});
    EXPECT_EQ(of(body, RUBBLE_KIND_JOINT), objects(RUBBLE_KIND_JOINT));
    EXPECT_EQ(of(shape, RUBBLE_KIND_JOINT).size(), 1u);
    EXPECT_EQ(of(shape, RUBBLE_KIND_LIGHT), std::vector{objects(RUBBLE_KIND_LIGHT).at(1)}) << "not the level's";
    uint32_t count = 0;
    expectRefused(api()->get_objects_of(m_world, shape, RUBBLE_KIND_BODY, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT,
                  "kind is 0");
    const uint64_t hinge = objects(RUBBLE_KIND_JOINT).at(0);
    ASSERT_EQ(api()->set_user_value(m_world, hinge, 77), RUBBLE_OK);
    step();
    EXPECT_EQ(userValue(hinge), 77u);
    ASSERT_EQ(api()->remove_joint(m_world, hinge), RUBBLE_OK);
    step();
    EXPECT_EQ(api()->set_user_value(m_world, hinge, 1), RUBBLE_ERROR_STALE);
}

TEST_F(AbiObjects, PiecesHaveWhatTheirShapeHadAndSayWhereTheyCameFrom) {
    const uint64_t table = objects(RUBBLE_KIND_SHAPE).at(0);
    ASSERT_EQ(api()->set_user_value(m_world, table, 42), RUBBLE_OK);
    ASSERT_EQ(api()->set_tag(m_world, table, "owner", "me"), RUBBLE_OK);
    step();
    breakTable();
    const std::vector<uint64_t> parts = pieces(table);
    ASSERT_FALSE(parts.empty());
    EXPECT_EQ(parts.size() + 1, objects(RUBBLE_KIND_SHAPE).size());
    for (const uint64_t piece : parts) {
        EXPECT_EQ(userValue(piece), 42u);
        EXPECT_EQ(tag(piece, "owner"), "me");
        rubble_shape parent = 0, root = 0;
        ASSERT_EQ(api()->get_origin(m_world, piece, &parent, &root), RUBBLE_OK);
        EXPECT_EQ(parent, table);
        EXPECT_EQ(root, table);
    }
    ASSERT_EQ(api()->destroy_shape(m_world, table), RUBBLE_OK);
    step();
    EXPECT_EQ(pieces(table), parts) << "by a handle that is stale";
    expectRefused(api()->get_user_value(m_world, table, nullptr), RUBBLE_ERROR_STALE, "object is stale");
}

TEST_F(AbiObjects, OriginsOfAllPiecesAreKeptOnlyIfTheHostAsks) {
    breakTable();
    const uint64_t table = objects(RUBBLE_KIND_SHAPE).at(0);
    EXPECT_TRUE(pieces(table).empty());
    api()->destroy_world(m_world);
    m_world = makeWorld();
    rubble_settings all = settings();
    all.flags |= RUBBLE_SETTING_KEEP_ORIGINS;
    ASSERT_EQ(api()->set_settings(m_world, &all), RUBBLE_OK) << api()->get_last_error();
    breakTable();
    EXPECT_EQ(pieces(objects(RUBBLE_KIND_SHAPE).at(0)).size() + 1, objects(RUBBLE_KIND_SHAPE).size());
}

TEST_F(AbiObjects, AreRecordedReplayedUndoneSavedAndHashed) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const uint64_t table = objects(RUBBLE_KIND_SHAPE).at(0), light = objects(RUBBLE_KIND_LIGHT).at(0);
    const uint64_t body = objects(RUBBLE_KIND_BODY).at(0);
    ASSERT_EQ(api()->set_name(m_world, body, "desk"), RUBBLE_OK);
    ASSERT_EQ(api()->set_tag(m_world, light, "night", "3"), RUBBLE_OK);
    ASSERT_EQ(api()->set_user_value(m_world, table, 9), RUBBLE_OK);
    step();
    const uint64_t named = hash();
    ASSERT_EQ(api()->set_user_value(m_world, table, 10), RUBBLE_OK);
    step();
    EXPECT_NE(hash(), named);
    breakTable();
    const std::vector<uint64_t> parts = pieces(table);
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(name(body), "table");
    EXPECT_EQ(tag(light, "night"), "none");
    EXPECT_EQ(userValue(table), 0u);
    EXPECT_TRUE(pieces(table).empty());
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(name(body), "desk");
    EXPECT_EQ(pieces(table), parts);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 3u);
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(userValue(table), 10u);
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(name(body), "desk");
    EXPECT_EQ(tag(light, "night"), "3");
    EXPECT_EQ(pieces(table), parts);
}

TEST_F(AbiObjects, SettingsAreReadChangedRecordedAndSaved) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog";
    rubble_settings all = settings();
    const WorldSettings defaults;
    EXPECT_EQ(all.impact_threshold, defaults.impactThreshold);
    EXPECT_EQ(all.debris_bodies, defaults.debris.bodies);
    EXPECT_EQ(all.flags, uint32_t(RUBBLE_SETTING_FIRE));
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    all.flags = RUBBLE_SETTING_STRESS | RUBBLE_SETTING_PAINT_LAYER;
    all.impact_radius = 0.5, all.split_parts = 7, all.debris_voxels = 1000, all.stress_work = 123, all.fire_spread = 2;
    auto bounds = sized<rubble_bounds>();
    bounds.rule = RUBBLE_BOUNDS_KEEP;
    ASSERT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_OK);
    ASSERT_EQ(api()->set_settings(m_world, &all), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->set_undo_limit(m_world, 3), RUBBLE_OK);
    step();
    const auto isAll = [&] {
        const rubble_settings now = settings();
        return now.flags == all.flags && now.impact_radius == 0.5 && now.split_parts == 7 &&
               now.debris_voxels == 1000 && now.stress_work == 123 && now.fire_spread == 2.0 &&
               now.max_hot == all.max_hot;
    };
    EXPECT_TRUE(isAll());
    ASSERT_EQ(api()->get_bounds(m_world, &bounds), RUBBLE_OK);
    EXPECT_EQ(bounds.rule, uint32_t(RUBBLE_BOUNDS_KEEP)) << "what waits in the queue is kept";
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_TRUE(isAll());
    all.impact_radius = 5.0;
    expectRefused(api()->set_settings(m_world, &all), RUBBLE_ERROR_ARGUMENT, "impact_radius is 5");
    all.impact_radius = 0.5, all.fire_spread = 1e300;
    expectRefused(api()->set_settings(m_world, &all), RUBBLE_ERROR_ARGUMENT, "fire_spread is 1e+300");
    all.fire_spread = 1, all.flags = 16;
    expectRefused(api()->set_settings(m_world, &all), RUBBLE_ERROR_ARGUMENT, "flags has unknown bits");
}

TEST(Notes, CostNothingWhereNobodyUsesThem) {
    World world;
    const Note* none = world.data().findNote(1);
    EXPECT_EQ(none, nullptr);
    EXPECT_EQ(world.data().noteOf.bucket_count(), 1u) << "no memory is taken for a table";
    EXPECT_EQ(world.data().notes.slotCount(), 0u);
    const FrameChanges changes = world.applyEdits({});
    EXPECT_EQ(changes.notes.capacity(), 0u);
}

TEST_F(AbiObjects, DataOfTheHostStaysWithTheGame) {
    const auto set = [&](const std::string& name, uint8_t value, uint64_t size) {
        return api()->set_host_data(m_world, name.c_str(), &value, size);
    };
    const auto get = [&](const std::string& name) {
        uint8_t value = 0;
        uint64_t count = 0;
        EXPECT_EQ(api()->get_host_data(m_world, name.c_str(), &value, 1, &count), RUBBLE_OK);
        return count ? int(value) : -1;
    };
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(set(std::to_string(i), 1, 1), RUBBLE_OK);
    EXPECT_EQ(set("another", 1, 1), RUBBLE_ERROR_CAPACITY);
    EXPECT_EQ(set("7", 3, 1), RUBBLE_OK) << "it is replaced";
    EXPECT_EQ(get("7"), 3);
    EXPECT_EQ(set("8", 0, 0), RUBBLE_OK);
    EXPECT_EQ(get("8"), -1);
    EXPECT_EQ(set("another", 5, 1), RUBBLE_OK) << "there is room again";
    uint64_t size = 0;
    ASSERT_EQ(api()->save_game_data(m_world, nullptr, 0, &size), RUBBLE_OK);
    std::vector<uint8_t> game(size);
    ASSERT_EQ(api()->save_game_data(m_world, game.data(), size, &size), RUBBLE_OK);
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(get("another"), -1);
    ASSERT_EQ(api()->load_game_data(m_world, game.data(), size), RUBBLE_OK);
    EXPECT_EQ(get("another"), 5);
    EXPECT_EQ(get("8"), -1);
}

TEST_F(AbiObjects, ScriptsOfALevelAreCheckedSavedAndUndone) {
    const auto set = [&](std::vector<rubble_level_script> scripts) {
        return api()->set_level_scripts(m_world, scripts.data(), uint32_t(scripts.size()));
    };
    const auto names = [&] {
        rubble_level_script rows[4] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_level_scripts(m_world, rows, 4, &count), RUBBLE_OK);
        std::string all;
        for (uint32_t i = 0; i < count; ++i) all += std::string(rows[i].path) + "(" + rows[i].parameters + ")";
        return all;
    };
    expectRefused(set({{nullptr, ""}}), RUBBLE_ERROR_NULL, "path is null");
    expectRefused(set({{"", ""}}), RUBBLE_ERROR_ARGUMENT, "path has 0 bytes, expected 1 to 4096");
    expectRefused(set({{"a\xff", ""}}), RUBBLE_ERROR_ARGUMENT, "path");
    expectRefused(set({{"a", "x=1\nfast"}}), RUBBLE_ERROR_ARGUMENT, "expected lines of \"name=value\"");
    expectRefused(api()->set_level_scripts(m_world, nullptr, 1), RUBBLE_ERROR_NULL, "scripts is null");
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    ASSERT_EQ(set({{"lift.lua", "speed=2\nheight=6"}, {"door.lua", nullptr}}), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(names(), "") << "a command for the next step";
    step();
    EXPECT_EQ(names(), "lift.lua(speed=2\nheight=6)door.lua()");
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    step();
    ASSERT_EQ(set({}), RUBBLE_OK);
    step();
    EXPECT_EQ(names(), "");
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(names(), "lift.lua(speed=2\nheight=6)door.lua()");
    const TempFolder folder;
    const std::string path = folder / "scripted.rubble";
    ASSERT_EQ(api()->save_level(m_world, path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(names(), "");
    ASSERT_EQ(api()->load_level(m_world, path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(names(), "lift.lua(speed=2\nheight=6)door.lua()");
}

}  // namespace
}  // namespace rubble
