#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A world with a static block that no anchor holds, apart from the table of the level.
class AbiSavedLevel : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        m_path = m_folder / "level.rubble";
        auto body = bodyAt(0.0, 3.0, RUBBLE_BODY_STATIC);
        auto shape = shapeOn(make(body), RUBBLE_SHAPE_BOX, 6);
        m_block = make(shape);
        name(m_block, "block");
        applyEdits();
        auto change = sized<rubble_shape_change>();
        change.shape = m_block, change.fields = RUBBLE_SHAPE_ANCHORS;
        ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
        ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        ASSERT_EQ(api()->set_shape(m_world, &change), RUBBLE_OK) << api()->get_last_error();
        applyEdits();
        ASSERT_EQ(anchors("block"), 0u);
    }
    void applyEdits() { ASSERT_EQ(api()->apply_edits(m_world), RUBBLE_OK) << api()->get_last_error(); }
    void save() {
        ASSERT_EQ(api()->save_level(m_world, m_path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    }
    void load() {
        ASSERT_EQ(api()->load_level(m_world, m_path.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
    }
    void name(rubble_shape shape, const char* name) {
        ASSERT_EQ(api()->set_name(m_world, shape, name), RUBBLE_OK) << api()->get_last_error();
    }
    uint64_t named(const char* name) {
        uint64_t found = 0;
        uint32_t count = 0;
        EXPECT_EQ(api()->find_by_name(m_world, RUBBLE_KIND_SHAPE, name, &found, 1, &count), RUBBLE_OK);
        return found;
    }
    uint32_t anchors(const char* name) {
        auto out = sized<rubble_shape_properties>();
        EXPECT_EQ(api()->get_shape_properties(m_world, named(name), &out), RUBBLE_OK) << api()->get_last_error();
        return out.anchor_count;
    }
    uint64_t levelHash() {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_level_hash(m_world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// Carves a voxel: what nothing holds comes off.
    bool standsAfterACut() {
        auto cut = sized<rubble_carve>();
        cut.brush = RUBBLE_BRUSH_BOX;
        cut.position[0] = cut.position[2] = 0.05, cut.position[1] = 3.55;
        for (double& each : cut.half_size) each = 0.04;
        EXPECT_EQ(api()->carve(m_world, &cut), RUBBLE_OK) << api()->get_last_error();
        step(2);
        return named("block") && bodyState(state(named("block")).body).flags & RUBBLE_BODY_STATIC;
    }

    TempFolder m_folder;
    std::string m_path;
    rubble_shape m_block = 0;
};

TEST_F(AbiSavedLevel, AShapeWithoutAnchorsComesBackWithoutAny) {
    save();
    load();
    EXPECT_EQ(anchors("block"), 0u);
    save();
    load();
    EXPECT_EQ(anchors("block"), 0u) << "written a second time";
    EXPECT_FALSE(standsAfterACut());
}

TEST_F(AbiSavedLevel, UndoAndRedoOfAnchorsAreWritten) {
    for (const uint32_t count : {1u, 0u}) {
        ASSERT_EQ(count ? api()->undo(m_world) : api()->redo(m_world), RUBBLE_OK);
        applyEdits();
        ASSERT_EQ(anchors("block"), count);
        save();
        const rubble_world other = makeWorld(), first = m_world;
        m_world = other;
        load();
        EXPECT_EQ(anchors("block"), count);
        EXPECT_EQ(standsAfterACut(), count == 1);
        m_world = first;
        ASSERT_EQ(api()->destroy_world(other), RUBBLE_OK);
    }
}

TEST_F(AbiSavedLevel, CopiesAndPrefabsOfAShapeWithoutAnchorsHaveNone) {
    auto copy = sized<rubble_shape_settings>();
    copy.body = make(bodyAt(5.0, 3.0, RUBBLE_BODY_STATIC)), copy.source = RUBBLE_SHAPE_COPY, copy.copied = m_block;
    name(make(copy), "copy");
    applyEdits();
    EXPECT_EQ(anchors("copy"), 0u);
    ASSERT_EQ(api()->destroy_shape(m_world, named("copy")), RUBBLE_OK);
    applyEdits();
    save();
    ASSERT_EQ(api()->destroy_shape(m_world, m_block), RUBBLE_OK);
    applyEdits();
    auto prefab = sized<rubble_prefab>();
    prefab.path = m_path.c_str();
    prefab.position[0] = 10.0, prefab.rotation[3] = 1.0;
    uint32_t count = 0;
    ASSERT_EQ(api()->create_prefab(m_world, &prefab, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
    std::vector<rubble_prefab_row> rows(count);
    ASSERT_EQ(api()->create_prefab(m_world, &prefab, rows.data(), count, &count), RUBBLE_OK);
    applyEdits();
    EXPECT_EQ(anchors("block"), 0u);
}

TEST_F(AbiSavedLevel, AllKindsOfObjectsKeepTheirTags) {
    const auto settled = [&](auto create, auto settings) {
        uint64_t made = 0;
        EXPECT_EQ(create(m_world, &settings, &made), RUBBLE_OK) << api()->get_last_error();
        return made;
    };
    auto water = sized<rubble_water_settings>();
    const double outline[] = {20, 20, 24, 20, 24, 24};
    water.outline = outline, water.outline_count = 3, water.depth = 1.0;
    auto joint = sized<rubble_joint_settings>();
    joint.kind = RUBBLE_JOINT_HINGE, joint.shapes[0] = m_block;
    joint.position[0] = 0.3, joint.position[1] = 3.3, joint.position[2] = 0.3;
    auto light = sized<rubble_light_settings>();
    light.flags = RUBBLE_LIGHT_ENABLED, light.color[0] = 1.0, light.reach = 5.0;
    const std::pair<uint32_t, uint64_t> made[] = {
        {RUBBLE_KIND_LIGHT, settled(api()->create_light, light)},
        {RUBBLE_KIND_LIGHT_GROUP, settled(api()->create_light_group, sized<rubble_light_group_settings>())},
        {RUBBLE_KIND_WATER, settled(api()->create_water, water)},
        {RUBBLE_KIND_CHARACTER, settled(api()->create_character, sized<rubble_character_settings>())},
        {RUBBLE_KIND_JOINT, settled(api()->create_joint, joint)}};
    applyEdits();
    for (const auto& [kind, object] : made)
        ASSERT_EQ(api()->set_tag(m_world, object, "layer", "above"), RUBBLE_OK) << api()->get_last_error();
    applyEdits();
    const uint64_t tagged = levelHash();
    save();
    load();
    EXPECT_EQ(levelHash(), tagged);
    const auto withTag = [&](uint32_t kind) {
        uint64_t found[2] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->find_by_tag(m_world, kind, "layer", "above", found, 2, &count), RUBBLE_OK)
            << api()->get_last_error();
        return count;
    };
    for (const auto& [kind, object] : made) EXPECT_EQ(withTag(kind), 1u) << kind;
    auto prefab = sized<rubble_prefab>();
    prefab.path = m_path.c_str(), prefab.position[0] = 10.0, prefab.rotation[3] = 1.0;
    std::vector<rubble_prefab_row> rows(16);
    uint32_t count = 0;
    ASSERT_EQ(api()->create_prefab(m_world, &prefab, rows.data(), 16, &count), RUBBLE_OK) << api()->get_last_error();
    applyEdits();
    EXPECT_EQ(withTag(RUBBLE_KIND_LIGHT), 2u) << "of the prefab";
    EXPECT_EQ(withTag(RUBBLE_KIND_JOINT), 2u);
}

TEST_F(AbiSavedLevel, WhatAWheelIsSteeredToIsWritten) {
    auto wheel = sized<rubble_joint_settings>();
    wheel.kind = RUBBLE_JOINT_WHEEL;
    wheel.shapes[0] = make(shapeOn(make(bodyAt(5.0, 3.0, 0)), RUBBLE_SHAPE_BOX, 6));
    wheel.position[0] = 5.3, wheel.position[1] = 3.3, wheel.position[2] = 0.3;
    wheel.max_steer_angle = 0.5;
    uint64_t made = 0;
    ASSERT_EQ(api()->create_joint(m_world, &wheel, &made), RUBBLE_OK) << api()->get_last_error();
    applyEdits();
    const uint64_t straight = levelHash();
    auto drive = sized<rubble_drive>();
    drive.body = state(wheel.shapes[0]).body, drive.steer = 1.0;
    ASSERT_EQ(api()->drive_wheels(m_world, &drive), RUBBLE_OK) << api()->get_last_error();
    applyEdits();
    const uint64_t steered = levelHash();
    EXPECT_NE(steered, straight);
    save();
    load();
    EXPECT_EQ(levelHash(), steered);
    step(60);
    uint64_t joint = 0;
    uint32_t count = 0;
    ASSERT_EQ(api()->get_objects(m_world, RUBBLE_KIND_JOINT, &joint, 1, &count), RUBBLE_OK) << api()->get_last_error();
    auto state = sized<rubble_joint_properties>();
    ASSERT_EQ(api()->get_joint_properties(m_world, joint, &state), RUBBLE_OK) << api()->get_last_error();
    EXPECT_NEAR(state.steer_angle, 0.5, 1e-6);
}

TEST_F(AbiSavedLevel, ABodyThatIsMadeStaticStillGetsAnchors) {
    auto copy = sized<rubble_shape_settings>();
    copy.body = make(bodyAt(5.0, 3.0, 0)), copy.source = RUBBLE_SHAPE_COPY, copy.copied = m_block;
    name(make(copy), "copy");
    applyEdits();
    ASSERT_EQ(anchors("copy"), 0u);
    copy.body = make(bodyAt(8.0, 3.0, RUBBLE_BODY_STATIC)), copy.copied = named("copy");
    name(make(copy), "third");
    applyEdits();
    EXPECT_EQ(anchors("third"), 1u);
}

TEST_F(AbiSavedLevel, ItsHashAndItsBoundsAreThoseOfTheWorld) {
    auto bounds = sized<rubble_bounds>(), loaded = sized<rubble_bounds>();
    const uint64_t written = levelHash();
    save();
    load();
    EXPECT_EQ(levelHash(), written);
    auto shape = shapeOn(make(bodyAt(1000.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 4);
    make(shape);
    applyEdits();
    ASSERT_EQ(api()->get_bounds(m_world, &bounds), RUBBLE_OK);
    EXPECT_GT(bounds.high[0], 1100.0) << "what is created after loading widens the bounds of a level without any";
    const uint64_t wide = levelHash();
    EXPECT_NE(wide, written);
    save();
    load();
    EXPECT_EQ(levelHash(), wide);
    ASSERT_EQ(api()->get_bounds(m_world, &loaded), RUBBLE_OK);
    EXPECT_EQ(loaded.high[0], bounds.high[0]);
}

/// Joints at odd angles, a rope that has swung, and a light group that has begun to flicker.
TEST_F(AbiSavedLevel, ItsHashIsThatOfAWorldThatWasPlayed) {
    const auto makeCrate = [&](double x) { return make(shapeOn(make(bodyAt(x, 6.0, 0)), RUBBLE_SHAPE_BOX, 4)); };
    for (int i = 0; i < 8; ++i) {
        auto joint = sized<rubble_joint_settings>();
        joint.kind = i ? RUBBLE_JOINT_HINGE : RUBBLE_JOINT_ROPE;
        joint.shapes[0] = i ? makeCrate(-4.0 - i) : 0, joint.shapes[1] = i ? 0 : makeCrate(-3.0);
        joint.position[0] = i ? -3.8 - i : -4.0, joint.position[1] = i ? 6.2 : 8.0, joint.position[2] = 0.2;
        joint.rope_end[0] = -2.8, joint.rope_end[1] = 6.2, joint.rope_end[2] = 0.2;
        const double axis[4] = {0.1 * i, 0.3, 0.7 - 0.05 * i, 0.2};
        const double length = std::sqrt(std::inner_product(axis, axis + 4, axis, 0.0));
        for (int k = 0; k < 4; ++k) joint.rotation[k] = axis[k] / length;
        rubble_joint made = 0;
        ASSERT_EQ(api()->create_joint(m_world, &joint, &made), RUBBLE_OK) << api()->get_last_error();
    }
    auto settings = sized<rubble_light_group_settings>();
    settings.threshold = 0.5, settings.flicker_steps = 60;
    auto change = sized<rubble_light_group_change>();
    ASSERT_EQ(api()->create_light_group(m_world, &settings, &change.group), RUBBLE_OK) << api()->get_last_error();
    step(100);
    change.fields = RUBBLE_GROUP_SUPPLY, change.supply_shape = m_block;  // without wire
    ASSERT_EQ(api()->set_light_group(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    step(2);
    const uint64_t played = levelHash();
    save();
    load();
    EXPECT_EQ(levelHash(), played);
    rubble_light_group group = 0;
    uint32_t count = 0;
    ASSERT_EQ(api()->get_objects(m_world, RUBBLE_KIND_LIGHT_GROUP, &group, 1, &count), RUBBLE_OK);
    const auto flags = [&] {
        auto state = sized<rubble_light_group_state>();
        EXPECT_EQ(api()->get_light_group(m_world, group, &state), RUBBLE_OK) << api()->get_last_error();
        return state.flags & (RUBBLE_GROUP_OUT | RUBBLE_GROUP_FAILING);
    };
    EXPECT_EQ(flags(), uint32_t(RUBBLE_GROUP_FAILING));
    step(62);
    EXPECT_EQ(flags(), uint32_t(RUBBLE_GROUP_OUT));
}

/// Two static blocks that reach 2 m deep, 2 m apart: the ground between them lies as deep.
TEST_F(AbiSavedLevel, TheGroundOfAMadeWorldIsThatOfItsLevel) {
    const auto heightBetween = [&] {
        const double above[3] = {0.0, 5.0, 0.5}, down[3] = {0.0, -1.0, 0.0};
        rubble_hit hit = {};
        EXPECT_EQ(api()->cast_ray(m_world, above, down, 100.0, &hit), RUBBLE_OK) << api()->get_last_error();
        return hit.position[1];
    };
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    const rubble_world first = m_world;
    ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK) << api()->get_last_error();
    auto bounds = sized<rubble_bounds>();
    bounds.rule = RUBBLE_BOUNDS_GROUND;
    ASSERT_EQ(api()->set_bounds(m_world, &bounds), RUBBLE_OK);
    ASSERT_EQ(api()->set_undo_limit(m_world, 4), RUBBLE_OK);
    make(shapeOn(make(bodyAt(-3.0, -2.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 20));
    const rubble_body second = make(bodyAt(1.0, 8.0, 0));
    make(shapeOn(second, RUBBLE_SHAPE_BOX, 20));
    applyEdits();
    EXPECT_NEAR(heightBetween(), -0.05, 1e-6) << "beside the static block";
    auto change = sized<rubble_body_change>();
    change.body = second, change.position[0] = 1.0, change.rotation[3] = 1.0;
    double before = -0.05;
    for (const uint32_t fields : {RUBBLE_SET_POSE | RUBBLE_SET_STATIC, RUBBLE_SET_POSE | 0}) {
        const double after = std::min(before, -1.0) - 1.0;
        ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        change.fields = fields, change.position[1] = after;
        ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
        applyEdits();
        EXPECT_NEAR(heightBetween(), after, 1e-6) << fields;
        for (const bool redoes : {false, true}) {
            ASSERT_EQ(redoes ? api()->redo(m_world) : api()->undo(m_world), RUBBLE_OK);
            applyEdits();
            EXPECT_NEAR(heightBetween(), redoes ? after : before, 1e-6) << fields;
        }
        before = after;
    }
    const uint64_t made = levelHash();
    save();
    load();
    EXPECT_NEAR(heightBetween(), -3.0, 1e-6);
    EXPECT_EQ(levelHash(), made);
    ASSERT_EQ(api()->destroy_world(std::exchange(m_world, first)), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
