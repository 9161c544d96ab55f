#include <string>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiMaterials : public AbiCreate {
protected:
    rubble_material get(uint32_t index) {
        auto out = sized<rubble_material>();
        EXPECT_EQ(api()->get_material(m_world, index, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    void set(uint32_t index, const rubble_material& row) {
        ASSERT_EQ(api()->set_materials(m_world, index, &row, 1), RUBBLE_OK) << api()->get_last_error();
    }
    uint32_t count() {
        uint32_t out = 0;
        EXPECT_EQ(api()->get_material_count(m_world, &out), RUBBLE_OK);
        return out;
    }
    uint32_t find(const char* name) {
        uint32_t out = 99;
        EXPECT_EQ(api()->find_material(m_world, name, &out), RUBBLE_OK);
        return out;
    }
    double massOf(rubble_body body) {
        auto out = sized<rubble_body_properties>();
        EXPECT_EQ(api()->get_body_properties(m_world, body, &out), RUBBLE_OK) << api()->get_last_error();
        return out.mass;
    }
};

TEST_F(AbiMaterials, TheTableIsRead) {
    EXPECT_EQ(count(), 20u);
    const rubble_material wood = get(find("wood"));
    EXPECT_STREQ(wood.name, "wood");
    EXPECT_STREQ(wood.fragments, "splinter");
    EXPECT_EQ(wood.density, 500u);
    EXPECT_EQ(wood.hardness, uint32_t(RUBBLE_HARDNESS_SOFT));
    EXPECT_EQ(wood.ignition_temperature, 570.0);
    EXPECT_EQ(get(find("hard masonry")).tools, uint32_t(RUBBLE_BREAKS_BY_EXPLOSIVE));
    EXPECT_EQ(find("cheese"), 0u);
    auto out = sized<rubble_material>();
    expectRefused(api()->get_material(m_world, 20, &out), RUBBLE_ERROR_ARGUMENT, "index is 20, expected 0 to 19");
}

TEST_F(AbiMaterials, WhatIsOfAMaterialFollowsItsRow) {
    const rubble_body crate = make(bodyAt(10.0, 20.0, 0));
    make(shapeOn(crate, RUBBLE_SHAPE_BOX, 4));  // of concrete
    step();
    const double before = massOf(crate);
    rubble_material concrete = get(6);
    concrete.density = 1200;
    set(6, concrete);
    step();
    EXPECT_NEAR(massOf(crate), 0.5 * before, 1e-6 * before);
    EXPECT_EQ(get(6).density, 1200u);
}

TEST_F(AbiMaterials, ANewRowIsUsedInTheStepThatMakesIt) {
    const rubble_shape table = shapes().at(0).shape;
    rubble_material lead = get(9);
    lead.name = "lead", lead.density = 11'340, lead.fragments = "tear";
    set(20, lead);
    auto range = sized<rubble_palette_range>();
    range.shape = table, range.count = 1;
    rubble_palette_entry entry = {};
    entry.material = 20, entry.opacity = 255;
    ASSERT_EQ(api()->set_palette(m_world, &range, &entry), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(count(), 21u);
    EXPECT_EQ(find("lead"), 20u);
    EXPECT_NEAR(massOf(bodies(m_world).at(0).body), 650 * 11.34, 0.1);
}

TEST_F(AbiMaterials, AMaterialBreaksAsItsRowSays) {
    auto carve = sized<rubble_carve>();
    carve.position[0] = carve.position[1] = carve.position[2] = 0.9;
    carve.radii[0] = 0.5;  // soft ones alone
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    step();
    EXPECT_EQ(shapes().at(0).voxel_count, 650u) << "it is of a harder one";
    auto range = sized<rubble_palette_range>();
    range.shape = shapes().at(0).shape, range.count = 1;
    rubble_palette_entry entry = {};
    ASSERT_EQ(api()->get_palette(m_world, &range, &entry), RUBBLE_OK);
    rubble_material soft = get(entry.material);
    soft.hardness = RUBBLE_HARDNESS_SOFT;
    set(entry.material, soft);
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    step();
    uint64_t left = 0;
    for (const rubble_shape_state& each : shapes()) left += each.voxel_count;
    EXPECT_LT(left, 650u);
}

TEST_F(AbiMaterials, AreRecordedReplayedUndoneAndSaved) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    const rubble_body crate = make(bodyAt(10.0, 5.0, 0));
    make(shapeOn(crate, RUBBLE_SHAPE_BOX, 4));
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    const double before = massOf(crate);
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    rubble_material row = get(6);
    row.name = "light concrete", row.density = 800, row.friction = 0.2;
    set(6, row);
    row.name = "mud";
    set(20, row);
    step(3);
    const auto isNew = [&] {
        return find("light concrete") == 6 && find("mud") == 20 && massOf(crate) < before * 0.34 &&
               get(6).density == 800;
    };
    EXPECT_TRUE(isNew());
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(find("concrete"), 6u);
    EXPECT_EQ(count(), 20u);
    EXPECT_EQ(massOf(crate), before);
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    step();
    EXPECT_TRUE(isNew());
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isNew());
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isNew());
}

TEST_F(AbiMaterials, BadRowsAreRefused) {
    const rubble_material good = get(5);
    const auto refused = [&](uint32_t first, const rubble_material& row, rubble_result code, const char* word) {
        expectRefused(api()->set_materials(m_world, first, &row, 1), code, word);
    };
    refused(0, good, RUBBLE_ERROR_ARGUMENT, "first is 0, expected 1 to 20");
    refused(21, good, RUBBLE_ERROR_ARGUMENT, "first is 21, expected 1 to 20");
    rubble_material wrong = good;
    wrong.struct_size = 4;
    refused(5, wrong, RUBBLE_ERROR_STRUCT_SIZE, "set_materials: materials[0]->struct_size is 4");
    wrong = good, wrong.name = nullptr;
    refused(5, wrong, RUBBLE_ERROR_NULL, "materials[0].name is null");
    wrong.name = "";
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "name");
    wrong = good, wrong.fragments = "dust";
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "fragments");
    wrong = good, wrong.density = 30'001;
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "density is 30001");
    wrong = good, wrong.restitution = 2.0;
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "restitution is 2");
    wrong = good, wrong.hardness = 0;
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "hardness is 0, expected 1 to 5");
    wrong = good, wrong.tools = 16;
    refused(5, wrong, RUBBLE_ERROR_ARGUMENT, "tools has unknown bits");
    expectRefused(api()->set_materials(m_world, 5, &good, 0), RUBBLE_ERROR_ARGUMENT, "count is 0");
    expectRefused(api()->set_materials(m_world, 5, nullptr, 1), RUBBLE_ERROR_NULL, "materials is null");
}

}  // namespace
}  // namespace rubble
