#include <array>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiPalettes : public AbiCreate {
protected:
    static rubble_palette_range entryOf(rubble_shape shape, uint32_t first = 1) {
        auto out = sized<rubble_palette_range>();
        out.shape = shape, out.first = first, out.count = 1;
        return out;
    }
    rubble_palette_entry get(rubble_shape shape, uint32_t entry = 1) {
        const rubble_palette_range range = entryOf(shape, entry);
        rubble_palette_entry out = {};
        EXPECT_EQ(api()->get_palette(m_world, &range, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    void set(rubble_shape shape, const rubble_palette_entry& entry, uint32_t flags = 0) {
        rubble_palette_range range = entryOf(shape);
        range.flags = flags;
        ASSERT_EQ(api()->set_palette(m_world, &range, &entry), RUBBLE_OK) << api()->get_last_error();
    }
    rubble_shape table() { return shapes().at(0).shape; }
};

TEST_F(AbiPalettes, EntriesAreReadWrittenUndoneRecordedAndSaved) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    rubble_palette_entry entry = get(table());
    EXPECT_EQ(entry.color[0], 200);
    EXPECT_EQ(entry.opacity, 255);
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    entry.color[0] = 10, entry.material = 5, entry.emission = 2.5, entry.roughness = 7, entry.metallic = 8;
    set(table(), entry);
    EXPECT_EQ(get(table()).color[0], 200) << "an edit waits for its step";
    step(2);
    const auto isNew = [&] {
        const rubble_palette_entry now = get(table());
        return now.color[0] == 10 && now.material == 5 && now.emission == 2.5 && now.roughness == 7 &&
               now.metallic == 8;
    };
    EXPECT_TRUE(isNew());
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(get(table()).color[0], 200);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isNew());
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isNew());
}

TEST_F(AbiPalettes, AShapeThatTheStepMakesTakesItsPaletteInTheSameStep) {
    const rubble_shape box = make(shapeOn(make(bodyAt(5.0, 5.0, 0)), RUBBLE_SHAPE_BOX, 4));
    std::array<rubble_palette_entry, 255> all = {};
    for (size_t i = 0; i < all.size(); ++i) all[i].material = 5, all[i].opacity = uint8_t(i);
    auto range = sized<rubble_palette_range>();
    range.shape = box, range.count = 255;
    ASSERT_EQ(api()->set_palette(m_world, &range, all.data()), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(get(box, 255).opacity, 254);
    EXPECT_EQ(get(box, 6).material, 5);
}

/// A shape is touched and falls as its new material says: a floor of what nothing touches lets a crate through.
TEST_F(AbiPalettes, PhysicsFollowsAMaterial) {
    auto floor = shapeOn(make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 10);
    const rubble_shape ground = make(floor);
    const rubble_body crate = make(bodyAt(10.3, 1.05, 0));
    make(shapeOn(crate, RUBBLE_SHAPE_BOX, 4));
    step(180);
    ASSERT_NEAR(bodyState(crate).position[1], 1.0, 0.02);
    ASSERT_TRUE(bodyState(crate).flags & RUBBLE_BODY_ASLEEP);
    const uint32_t voxels = uint32_t(state(ground).voxel_count);
    rubble_palette_range range = entryOf(ground, 6);
    rubble_palette_entry ghost = get(ground, 6);
    ghost.material = 16;  // unphysical
    ASSERT_EQ(api()->set_palette(m_world, &range, &ghost), RUBBLE_OK) << api()->get_last_error();
    step(20);
    EXPECT_LT(bodyState(crate).position[1], 0.8);
    EXPECT_EQ(state(ground).voxel_count, voxels);
    ghost.material = 6;
    ASSERT_EQ(api()->set_palette(m_world, &range, &ghost), RUBBLE_OK);
    auto back = sized<rubble_body_change>();
    back.body = crate, back.fields = RUBBLE_SET_POSE | RUBBLE_SET_VELOCITY;
    back.position[0] = 10.3, back.position[1] = 1.1;
    ASSERT_EQ(api()->set_body(m_world, &back), RUBBLE_OK);
    step(60);
    EXPECT_NEAR(bodyState(crate).position[1], 1.0, 0.02) << "and holds it again";
}

TEST_F(AbiPalettes, AHostMayKnowMoreOfAnEntryThanThePlugin) {
    struct Grown {
        rubble_palette_entry known;
        uint64_t added;
    } rows[2] = {};
    rubble_palette_range range = entryOf(table());
    range.count = 2, range.entry_size = sizeof(Grown);
    rows[1].added = 7;
    ASSERT_EQ(api()->get_palette(m_world, &range, &rows[0].known), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(rows[0].known.color[0], 200);
    EXPECT_EQ(rows[1].added, 0u);
    rows[0].known.color[0] = 50;
    ASSERT_EQ(api()->set_palette(m_world, &range, &rows[0].known), RUBBLE_OK);
    step();
    EXPECT_EQ(get(table()).color[0], 50);
}

TEST_F(AbiPalettes, BadArgumentsAreRefused) {
    const rubble_palette_entry good = get(table());
    rubble_palette_range range = entryOf(table());
    const auto refused = [&](rubble_palette_entry entry, rubble_result code, const char* word) {
        expectRefused(api()->set_palette(m_world, &range, &entry), code, word);
    };
    rubble_palette_entry wrong = good;
    wrong.material = 20;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "entries[0].material is 20, expected 0 to 19");
    wrong = good, wrong.emission = -1.0;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "entries[0].emission is -1");
    wrong = good, wrong.light_group = table();
    refused(wrong, RUBBLE_ERROR_STALE, "light_group is a handle of another type");
    wrong = good, wrong.reserved = 1;
    refused(wrong, RUBBLE_ERROR_ARGUMENT, "reserved is 1");
    range.count = 0;
    refused(good, RUBBLE_ERROR_ARGUMENT, "range->count is 0, expected 1 to 255");
    range.first = 255, range.count = 2;
    refused(good, RUBBLE_ERROR_ARGUMENT, "range->count is 2, expected 1 to 1");
    range = entryOf(table()), range.flags = 2;
    refused(good, RUBBLE_ERROR_ARGUMENT, "range->flags has unknown bits");
    range = entryOf(0);
    refused(good, RUBBLE_ERROR_STALE, "range->shape is 0");
    range = entryOf(table()), range.entry_size = 8;
    refused(good, RUBBLE_ERROR_ARGUMENT, "range->entry_size is 8");
    range.entry_size = 0;
    expectRefused(api()->set_palette(m_world, &range, nullptr), RUBBLE_ERROR_NULL, "entries is null");
    expectRefused(api()->set_palette(m_world, nullptr, &good), RUBBLE_ERROR_NULL, "range is null");
    range.flags = RUBBLE_PALETTE_ALL_EQUAL;
    rubble_palette_entry out = {};
    expectRefused(api()->get_palette(m_world, &range, &out), RUBBLE_ERROR_ARGUMENT, "range->flags has unknown bits");
    step();
    EXPECT_EQ(get(table()).material, good.material);
}

}  // namespace
}  // namespace rubble
