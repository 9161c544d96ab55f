#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A bulb that a host makes: a bar of wire with a glowing end, in a group of its own.
class AbiLightGroups : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        makeBulb();
    }
    void makeBulb() {
        auto settings = sized<rubble_light_group_settings>();
        settings.threshold = 0.5;
        ASSERT_EQ(api()->create_light_group(m_world, &settings, &m_group), RUBBLE_OK) << api()->get_last_error();
        auto bar = shapeOn(make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_INDICES, 1);
        const uint8_t cells[10] = {2, 2, 2, 2, 2, 2, 2, 2, 3, 3};  // 2 wire, 3 the glowing end
        bar.size[1] = 10, bar.indices = cells, bar.count = 10;
        m_bulb = make(bar);
        auto range = sized<rubble_palette_range>();
        range.shape = m_bulb, range.first = 2, range.count = 2;
        rubble_palette_entry entries[2] = {};
        entries[0].material = 18, entries[0].opacity = 255;
        entries[1].material = 1, entries[1].opacity = 255, entries[1].emission = 8.0, entries[1].light_group = m_group;
        ASSERT_EQ(api()->set_palette(m_world, &range, entries), RUBBLE_OK) << api()->get_last_error();
        step();
    }
    rubble_light_group_state state() {
        auto out = sized<rubble_light_group_state>();
        EXPECT_EQ(api()->get_light_group(m_world, m_group, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_light_group_change change(uint32_t fields) {
        auto out = sized<rubble_light_group_change>();
        out.group = m_group, out.fields = fields;
        return out;
    }
    void set(const rubble_light_group_change& to) {
        ASSERT_EQ(api()->set_light_group(m_world, &to), RUBBLE_OK) << api()->get_last_error();
    }
    void supplyFrom(rubble_shape shape, int32_t y) {
        rubble_light_group_change supply = change(RUBBLE_GROUP_SUPPLY);
        supply.supply_shape = shape, supply.supply_cell[1] = y;
        set(supply);
    }
    bool isOut() { return state().flags & RUBBLE_GROUP_OUT; }
    void carveAt(double y) {
        auto carve = sized<rubble_carve>();
        carve.brush = RUBBLE_BRUSH_BOX;
        carve.position[0] = 10.05, carve.position[1] = y, carve.position[2] = 0.05;
        for (double& half : carve.half_size) half = 0.04;
        ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    }
    rubble_light_group m_group = 0;
    rubble_shape m_bulb = 0;
};

TEST_F(AbiLightGroups, VoxelsThatComeToAGroupCountInIt) {
    EXPECT_EQ(state().voxels, 2u);
    EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON));
    EXPECT_EQ(state().threshold, 0.5);
    carveAt(0.95);
    step();
    EXPECT_EQ(state().removed_voxels, 1u);
    EXPECT_TRUE(state().flags & RUBBLE_GROUP_OUT);
}

TEST_F(AbiLightGroups, ATenthOfItsVoxelsIsATenth) {
    auto bar = sized<rubble_voxel_box>();
    bar.shape = m_bulb, bar.size[0] = bar.size[2] = 1, bar.size[1] = 10;
    const uint8_t cells[10] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
    ASSERT_EQ(api()->write_voxels(m_world, &bar, cells, sizeof cells), RUBBLE_OK) << api()->get_last_error();
    rubble_light_group_change tenth = change(RUBBLE_GROUP_THRESHOLD);
    tenth.threshold = 0.1;
    set(tenth);
    step();
    ASSERT_EQ(state().voxels, 10u);
    carveAt(0.95);
    step();
    EXPECT_EQ(state().removed_voxels, 1u);
    EXPECT_TRUE(isOut());
}

TEST_F(AbiLightGroups, VoxelsThatAreMadeOrWrittenCountInTheirGroup) {
    auto copy = shapeOn(bodies(m_world).back().body, RUBBLE_SHAPE_COPY, 0);
    copy.copied = m_bulb, copy.position[0] = 2.0;
    const rubble_shape second = make(copy);
    step();
    EXPECT_EQ(state().voxels, 4u) << "those of the copy too";
    auto box = sized<rubble_voxel_box>();
    box.shape = second, box.size[0] = box.size[2] = 1, box.size[1] = 4;
    const uint8_t cells[4] = {3, 3, 3, 3};
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells, 4), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(state().voxels, 8u);
    ASSERT_EQ(api()->write_voxels(m_world, &box, cells, 4), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(state().voxels, 8u) << "the same once more";
    EXPECT_EQ(state().removed_voxels, 0u);
    const uint8_t none[4] = {};
    ASSERT_EQ(api()->write_voxels(m_world, &box, none, 3), RUBBLE_ERROR_ARGUMENT);
    ASSERT_EQ(api()->write_voxels(m_world, &box, none, 4), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(state().removed_voxels, 4u);
    EXPECT_TRUE(state().flags & RUBBLE_GROUP_OUT) << "half of them are gone";
}

TEST_F(AbiLightGroups, AreSwitchedOffAndOnRecordedAndUndone) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    const uint64_t lit = hash();
    set(change(RUBBLE_GROUP_SWITCH));
    step();
    EXPECT_EQ(state().flags, 0u);
    EXPECT_NE(hash(), lit);
    auto range = sized<rubble_palette_range>();
    range.shape = m_bulb, range.first = 3, range.count = 1;
    rubble_palette_entry entry = {};
    ASSERT_EQ(api()->get_palette(m_world, &range, &entry), RUBBLE_OK);
    EXPECT_EQ(entry.emission, 8.0) << "a switch forgets nothing";
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON));
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(state().flags, 0u);
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_EQ(state().flags, 0u);
}

TEST_F(AbiLightGroups, AWireFeedsAGroupUntilItIsCut) {
    rubble_light_group_change supply = change(RUBBLE_GROUP_SUPPLY);
    supply.supply_shape = m_bulb;
    set(supply);
    step(2);
    EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON)) << "wire leads from cell 0 to the end";
    EXPECT_EQ(state().supply_shape, m_bulb);
    carveAt(0.45);
    step(2);
    EXPECT_TRUE(state().flags & RUBBLE_GROUP_OUT);
}

TEST_F(AbiLightGroups, AWireFeedsAGroupInAWorldWithoutALevel) {
    ASSERT_EQ(api()->destroy_world(m_world), RUBBLE_OK);
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble_world worlds[2] = {};
    for (rubble_world& world : worlds) ASSERT_EQ(api()->create_world(&settings, &world), RUBBLE_OK);
    m_world = worlds[0];
    makeBulb();
    std::vector<uint8_t> game(1 << 20);
    uint64_t bytes = 0, hashes[2] = {};
    ASSERT_EQ(api()->save_game_data(m_world, game.data(), game.size(), &bytes), RUBBLE_OK) << api()->get_last_error();
    ASSERT_EQ(api()->load_game_data(worlds[1], game.data(), bytes), RUBBLE_OK) << api()->get_last_error();
    for (int i : {1, 0}) {  // the running game and the loaded one
        m_world = worlds[i];
        ASSERT_EQ(api()->translate_handle(m_world, m_group, &m_group), RUBBLE_OK);
        ASSERT_EQ(api()->translate_handle(m_world, m_bulb, &m_bulb), RUBBLE_OK);
        supplyFrom(m_bulb, 0);
        step(2);
        EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON));
        hashes[i] = hash();
        carveAt(0.45);
        step(2);
        EXPECT_TRUE(isOut());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(api()->destroy_world(worlds[1]), RUBBLE_OK);
}

TEST_F(AbiLightGroups, ASupplyMovesWithTheCellsOfItsShape) {
    supplyFrom(m_bulb, 2);
    step();
    auto resize = sized<rubble_resize>();
    resize.shape = m_bulb;
    resize.low[0] = -3, resize.low[1] = 1;
    resize.size[0] = 4, resize.size[1] = 12, resize.size[2] = 1;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(state().supply_cell[0], 3);
    EXPECT_EQ(state().supply_cell[1], 1);
    ASSERT_EQ(api()->trim_shape(m_world, m_bulb), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(state().supply_cell[0], 0);
    EXPECT_EQ(state().supply_cell[1], 1);
    EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON)) << "a wire that the resize cut below the supply";
    carveAt(0.45);
    step(2);
    EXPECT_TRUE(isOut());
}

TEST_F(AbiLightGroups, ASupplyGoesWithAShapeThatIsMerged) {
    supplyFrom(m_bulb, 2);
    auto below = shapeOn(bodies(m_world).back().body, RUBBLE_SHAPE_BOX, 1);
    below.position[1] = -0.1, below.palette_of = m_bulb, below.index = 2;
    const rubble_shape into = make(below);
    step();
    ASSERT_EQ(api()->merge_shape(m_world, m_bulb, into), RUBBLE_OK) << api()->get_last_error();
    step(2);
    EXPECT_EQ(state().supply_shape, into);
    EXPECT_EQ(state().supply_cell[1], 3);
    EXPECT_EQ(state().flags, uint32_t(RUBBLE_GROUP_ON));
    carveAt(0.45);
    step(2);
    EXPECT_TRUE(isOut());
}

TEST_F(AbiLightGroups, MeshesGlowAsTheGroupAndItsShapeDo) {
    const auto emission = [&] {
        std::vector<rubble_mesh_vertex> vertices(4096);
        const int32_t brick[3] = {0, 1, 0};
        uint32_t count = 0;
        EXPECT_EQ(api()->mesh_brick(m_world, m_bulb, brick, vertices.data(), 4096, &count), RUBBLE_OK);
        EXPECT_GT(count, 0u);
        return vertices[0].emission;
    };
    auto isStale = [&, version = uint64_t(0)]() mutable {
        auto changes = sized<rubble_brick_changes>();
        changes.shape = m_bulb, changes.what = RUBBLE_BRICKS_MESHES, changes.since = version;
        uint32_t count = 0;
        EXPECT_EQ(api()->get_changed_bricks(m_world, &changes, &version, nullptr, 0, &count), RUBBLE_OK);
        return count > 0;
    };
    EXPECT_EQ(emission(), 8.0f);
    EXPECT_TRUE(isStale());
    auto brighter = sized<rubble_shape_change>();
    brighter.shape = m_bulb, brighter.fields = RUBBLE_SHAPE_EMISSION, brighter.emission = 2.0;
    ASSERT_EQ(api()->set_shape(m_world, &brighter), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(emission(), 16.0f);
    EXPECT_TRUE(isStale());
    for (const bool on : {false, true}) {
        rubble_light_group_change to = change(RUBBLE_GROUP_SWITCH);
        to.on = on;
        set(to);
        step();
        EXPECT_EQ(emission(), on ? 16.0f : 0.0f) << "switched";
        EXPECT_TRUE(isStale()) << "switched";
        EXPECT_FALSE(isStale());
    }
    carveAt(0.95);
    step();
    EXPECT_EQ(emission(), 0.0f) << "it went out";
    EXPECT_TRUE(isStale());
}

TEST_F(AbiLightGroups, ASupplyWithoutWireFeedsNothing) {
    rubble_light_group_change supply = change(RUBBLE_GROUP_SUPPLY);
    supply.supply_shape = shapes().at(0).shape;
    set(supply);
    step(2);
    EXPECT_TRUE(state().flags & RUBBLE_GROUP_OUT);
}

TEST_F(AbiLightGroups, BadArgumentsAreRefused) {
    const auto refused = [&](const rubble_light_group_change& to, rubble_result code, const char* word) {
        expectRefused(api()->set_light_group(m_world, &to), code, word);
    };
    refused(change(0), RUBBLE_ERROR_ARGUMENT, "fields is 0");
    refused(change(8), RUBBLE_ERROR_ARGUMENT, "fields has unknown bits");
    rubble_light_group_change wrong = change(RUBBLE_GROUP_THRESHOLD);
    wrong.threshold = 2.0;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "threshold is 2");
    wrong = change(RUBBLE_GROUP_SWITCH), wrong.on = 2;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "on is 2, expected 0 to 1");
    wrong = change(RUBBLE_GROUP_SWITCH), wrong.group = m_bulb;
    refused(wrong, RUBBLE_ERROR_STALE, "group");
    wrong = change(RUBBLE_GROUP_SWITCH), wrong.reserved_2 = 1;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "reserved_2 is 1");
}

}  // namespace
}  // namespace rubble
