#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

class AbiReports : public AbiCreate {
protected:
    static constexpr uint32_t kContacts =
        RUBBLE_REPORT_CONTACT_BEGUN | RUBBLE_REPORT_CONTACT_SLID | RUBBLE_REPORT_CONTACT_HIT;

    void ask(uint32_t kinds, double minImpulse = 0.0) {
        auto filter = sized<rubble_report_filter>();
        filter.kinds = kinds, filter.min_impulse = minImpulse;
        ASSERT_EQ(api()->set_report_filter(m_world, &filter), RUBBLE_OK) << api()->get_last_error();
    }
    rubble_reports reports() {
        auto out = sized<rubble_reports>();
        EXPECT_EQ(api()->get_reports(m_world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// A crate of wood above the table's top, which is of another material.
    rubble_body addCrate(double height) {
        auto settings = bodyAt(0.7, 1.0 + height, 0);
        settings.position[2] = 0.7;
        const rubble_body crate = make(settings);
        auto shape = shapeOn(crate, RUBBLE_SHAPE_BOX, 3);
        shape.index = 5;
        m_crate = make(shape);
        return crate;
    }
    /// How many parts of each shape burn.
    std::map<uint64_t, int> countFires() {
        std::vector<rubble_fire> rows(1000);
        uint32_t count = 0;
        EXPECT_EQ(api()->get_fires(m_world, rows.data(), uint32_t(rows.size()), &count), RUBBLE_OK);
        std::map<uint64_t, int> out;
        for (const rubble_fire& fire : std::span(rows).first(count)) ++out[fire.shape];
        return out;
    }
    rubble_shape m_crate = 0;
};

TEST_F(AbiReports, ACrateThatFallsOnATableIsHeard) {
    const rubble_body crate = addCrate(0.5);
    ask(kContacts);
    int begun = 0;
    for (int i = 0; i < 60; ++i) {
        step();
        const rubble_reports all = reports();
        EXPECT_EQ(all.kinds, kContacts);
        for (const rubble_contact& contact : std::span(all.contacts, all.contact_count)) {
            if (!(contact.kinds & RUBBLE_REPORT_CONTACT_BEGUN) || begun++) continue;  // it may bounce
            EXPECT_TRUE(contact.kinds & RUBBLE_REPORT_CONTACT_HIT);
            EXPECT_EQ(contact.bodies[0], crate);
            EXPECT_EQ(contact.shapes[0], m_crate);
            EXPECT_EQ(contact.materials[0], 5u);
            EXPECT_NE(contact.materials[1], 0u);
            EXPECT_NEAR(contact.hit_speed, std::sqrt(2.0 * 9.81 * 0.5), 0.2);
            EXPECT_NEAR(contact.position[1], 1.0, 0.02);
            EXPECT_NEAR(contact.normal[1], 1.0, 1e-6);
            EXPECT_GT(contact.impulse, 0.0);
        }
    }
    EXPECT_GE(begun, 1);
}

TEST_F(AbiReports, WhatIsSofterThanAskedForIsNotHeard) {
    addCrate(0.5);
    ask(kContacts, 1e9);
    for (int i = 0; i < 60; ++i) {
        step();
        EXPECT_EQ(reports().contact_count, 0u);
    }
}

TEST_F(AbiReports, BreaksCountEveryVoxelByMaterial) {
    ask(RUBBLE_REPORT_BREAK);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    step();
    auto events = sized<rubble_events>();
    ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
    uint64_t removed[256] = {}, reported[256] = {};
    for (const auto& row : std::span(events.removed, events.removed_count)) removed[row.material] += row.count;
    const rubble_reports all = reports();
    ASSERT_GT(all.break_count, 0u);
    EXPECT_LE(all.break_count, events.dust_cloud_count);
    for (const auto& row : std::span(all.breaks, all.break_count)) {
        reported[row.material] += row.voxels;
        EXPECT_LT(std::hypot(row.position[0] - 0.85, row.position[1] - 0.95, row.position[2] - 0.85), 1.0);
        EXPECT_LT(row.radius, 2.0);
    }
    EXPECT_TRUE(std::equal(std::begin(removed), std::end(removed), std::begin(reported)));
    step();
    EXPECT_EQ(reports().break_count, 0u) << "it was in the step before";
}

TEST_F(AbiReports, AJointThatIsRemovedIsReported) {
    const rubble_body crate = addCrate(2.0);
    ask(RUBBLE_REPORT_JOINT);
    auto settings = sized<rubble_joint_settings>();
    settings.shapes[0] = m_crate;
    settings.position[0] = settings.position[2] = 0.8, settings.position[1] = 3.1;
    rubble_joint joint = 0;
    ASSERT_EQ(api()->create_joint(m_world, &settings, &joint), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_TRUE(refusals().empty()) << refusals()[0].reason;
    EXPECT_EQ(reports().joint_count, 0u);
    ASSERT_EQ(api()->remove_joint(m_world, joint), RUBBLE_OK);
    step();
    ASSERT_EQ(reports().joint_count, 1u);
    EXPECT_EQ(reports().joints[0].joint, joint);
    EXPECT_EQ(reports().joints[0].what, uint32_t(RUBBLE_REPORT_JOINT_REMOVED));
    ASSERT_EQ(api()->create_joint(m_world, &settings, &joint), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->destroy_body(m_world, crate), RUBBLE_OK);
    step();
    ASSERT_EQ(reports().joint_count, 1u);
    EXPECT_EQ(reports().joints[0].what, uint32_t(RUBBLE_REPORT_JOINT_VOXEL_GONE));
}

TEST_F(AbiReports, AnEndOfARopeThatComesLooseIsReported) {
    const rubble_body crate = addCrate(2.0);
    ask(RUBBLE_REPORT_JOINT);
    auto rope = sized<rubble_joint_settings>();
    rope.kind = RUBBLE_JOINT_ROPE;
    rope.shapes[0] = m_crate;
    rope.position[0] = rope.position[2] = 0.8, rope.position[1] = 3.1;
    rope.rope_end[0] = rope.rope_end[2] = 0.8, rope.rope_end[1] = 5.0;
    rubble_joint joint = 0;
    ASSERT_EQ(api()->create_joint(m_world, &rope, &joint), RUBBLE_OK) << api()->get_last_error();
    step();
    auto now = sized<rubble_joint_properties>();
    ASSERT_EQ(api()->get_joint_properties(m_world, joint, &now), RUBBLE_OK);
    EXPECT_EQ(now.flags, 0u) << "its second end is on the world";
    ASSERT_EQ(api()->destroy_body(m_world, crate), RUBBLE_OK);
    step();
    ASSERT_EQ(reports().joint_count, 1u);
    const rubble_joint_report loose = reports().joints[0];
    EXPECT_EQ(loose.joint, joint);
    EXPECT_EQ(loose.what, uint32_t(RUBBLE_REPORT_JOINT_LOOSE));
    EXPECT_EQ(loose.from, m_crate);
    EXPECT_EQ(loose.to, 0u);
    EXPECT_NEAR(loose.position[1], 3.1, 0.1);
    ASSERT_EQ(api()->get_joint_properties(m_world, joint, &now), RUBBLE_OK);
    EXPECT_EQ(now.flags, uint32_t(RUBBLE_JOINT_FIRST_LOOSE));
}

TEST_F(AbiReports, FiresAreReportedWhenTheyAreLitAndWhenTheyGoOut) {
    addCrate(0.0);
    ask(RUBBLE_REPORT_FIRE);
    step();
    auto heat = sized<rubble_heat>();
    heat.flags = RUBBLE_HEAT_IGNITE, heat.shape = m_crate, heat.joules = 1.0;
    heat.position[0] = heat.position[2] = 0.8, heat.position[1] = 1.1;
    ASSERT_EQ(api()->heat(m_world, &heat), RUBBLE_OK) << api()->get_last_error();
    step();
    ASSERT_EQ(reports().fire_count, 1u);
    EXPECT_EQ(reports().fires[0].shape, m_crate);
    EXPECT_EQ(reports().fires[0].lit, 1u);
    const double low[3] = {-10, -10, -10}, high[3] = {10, 10, 10};
    ASSERT_EQ(api()->remove_fires(m_world, low, high), RUBBLE_OK);
    step();
    ASSERT_EQ(reports().fire_count, 1u);
    EXPECT_EQ(reports().fires[0].lit, 0u);
}

/// Of each shape, lit minus out is what burns: also when parts come off, burn down, are destroyed or undone.
TEST_F(AbiReports, FiresAddUpToWhatBurns) {
    const rubble_body body = make(bodyAt(5.0, 0.0, RUBBLE_BODY_STATIC));
    auto wall = shapeOn(body, RUBBLE_SHAPE_BOX, 3);
    wall.index = 5;  // wood
    wall.size[0] = 40, wall.size[1] = 30;
    const rubble_shape shape = make(wall);
    ASSERT_EQ(api()->set_undo_limit(m_world, 1), RUBBLE_OK);
    ask(RUBBLE_REPORT_FIRE);
    auto heat = sized<rubble_heat>();
    heat.flags = RUBBLE_HEAT_IGNITE, heat.joules = 1.0, heat.radius = 3.0;
    heat.position[0] = 6.0, heat.position[1] = 1.0;
    ASSERT_EQ(api()->heat(m_world, &heat), RUBBLE_OK);
    std::map<uint64_t, int> burning;
    size_t pieces = 0;
    for (int i = 0; i < 1200; ++i) {
        if (i == 100) {
            auto explosion = sized<rubble_explosion>();
            explosion.position[0] = 6.0, explosion.position[1] = 1.0, explosion.size = 1.0;
            ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
            ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        }
        ASSERT_EQ(i == 200 ? api()->undo(m_world) : RUBBLE_OK, RUBBLE_OK);
        ASSERT_EQ(i == 300 ? api()->redo(m_world) : RUBBLE_OK, RUBBLE_OK);
        if (i == 900) {
            ASSERT_TRUE(burning.contains(shape));
            ASSERT_EQ(api()->destroy_body(m_world, body), RUBBLE_OK);
        }
        step();
        for (const auto& row : std::span(reports().fires, reports().fire_count)) burning[row.shape] += row.lit ? 1 : -1;
        const std::map<uint64_t, int> expected = countFires();
        pieces = std::max(pieces, expected.size());
        std::erase_if(burning, [](const auto& each) { return each.second == 0; });
        ASSERT_EQ(burning, expected) << "step " << i;
    }
    EXPECT_GT(pieces, 1u);
}

TEST_F(AbiReports, ACharacterLandsWalksAndGetsIntoWater) {
    auto settings = bodyAt(20.0, 0.0, RUBBLE_BODY_STATIC);
    const rubble_body ground = make(settings);
    auto floor = shapeOn(ground, RUBBLE_SHAPE_BOX, 10);
    floor.size[0] = 60, floor.size[1] = 5, floor.index = 6;
    const rubble_shape shape = make(floor);
    auto person = sized<rubble_character_settings>();
    person.position[0] = 20.5, person.position[1] = 1.5, person.position[2] = 0.5;
    rubble_character character = 0;
    ASSERT_EQ(api()->create_character(m_world, &person, &character), RUBBLE_OK) << api()->get_last_error();
    const double outline[8] = {26, -5, 40, -5, 40, 5, 26, 5};
    auto water = sized<rubble_water_settings>();
    water.outline = outline, water.outline_count = 4, water.surface_height = 0.3, water.depth = 30.0;
    rubble_water lake = 0;
    ASSERT_EQ(api()->create_water(m_world, &water, &lake), RUBBLE_OK) << api()->get_last_error();
    auto filter = sized<rubble_report_filter>();
    filter.kinds = RUBBLE_REPORT_FOOTSTEP | RUBBLE_REPORT_WATER;
    filter.stride = 0.08;  // it walks 0.05 m in a step of the world
    ASSERT_EQ(api()->set_report_filter(m_world, &filter), RUBBLE_OK);
    int landed = 0, walked = 0, splashed = 0;
    for (int i = 0; i < 240; ++i) {
        auto move = sized<rubble_character_move>();
        move.character = character;
        if (i > 60) move.desired_velocity[0] = 3.0;
        if (i == 0) step();
        ASSERT_EQ(api()->move_character(m_world, &move), RUBBLE_OK) << api()->get_last_error();
        step();
        const rubble_reports all = reports();
        for (const auto& footstep : std::span(all.footsteps, all.footstep_count)) {
            if (footstep.position[0] > 25.5) continue;  // at the edge
            EXPECT_EQ(footstep.character, character);
            EXPECT_EQ(footstep.shape, shape);
            EXPECT_EQ(footstep.material, 6u);
            EXPECT_NEAR(footstep.position[1], 0.5, 0.05);
            (footstep.flags & RUBBLE_FOOTSTEP_LANDED ? landed : walked) += 1;
            EXPECT_NEAR(footstep.speed, footstep.flags ? std::sqrt(2.0 * 9.81 * 1.0) : 3.0, 0.3);
        }
        for (const auto& each : std::span(all.waters, all.water_count)) {
            ++splashed;
            EXPECT_EQ(each.object, character);
            EXPECT_EQ(each.water, lake);
            EXPECT_EQ(each.position[1], 0.3);
            EXPECT_GT(each.speed, 1.0);
            EXPECT_EQ(each.mass, 80.0);
        }
    }
    EXPECT_EQ(landed, 1);
    EXPECT_NEAR(walked, int(5.0 / 0.08), 3) << "it walks from 20.5 m to 25.5 m";
    EXPECT_GE(splashed, 1);
}

TEST_F(AbiReports, WhatNobodyAsksForCostsNothing) {
    addCrate(0.0);
    step(2);
    const auto allocations = [&] {
        const size_t before = allocationCount();
        step(10);
        return allocationCount() - before;
    };
    const size_t without = allocations();
    ask(0xff);
    step();
    ask(0);
    step();
    EXPECT_EQ(allocations(), without);
    EXPECT_EQ(reports().kinds, 0u);
    EXPECT_EQ(reports().contact_count, 0u);
}

TEST_F(AbiReports, AnotherWorldHasNoReportsOfTheOldOne) {
    addCrate(0.1);
    ask(0xff);
    uint32_t most = 0;
    for (int i = 0; i < 20; ++i) step(), most = std::max(most, reports().contact_count);
    EXPECT_GT(most, 0u);
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(reports().kinds, 0u);
    EXPECT_EQ(reports().contact_count, 0u);
    step();
    EXPECT_EQ(reports().kinds, 0xffu) << "the filter is the host's";
}

TEST_F(AbiReports, FiltersOutOfRangeAreRefused) {
    auto filter = sized<rubble_report_filter>();
    filter.kinds = 256;
    expectRefused(api()->set_report_filter(m_world, &filter), RUBBLE_ERROR_ARGUMENT, "filter->kinds has unknown bits");
    filter.kinds = 1, filter.min_impulse = -1.0;
    expectRefused(api()->set_report_filter(m_world, &filter), RUBBLE_ERROR_ARGUMENT, "filter->min_impulse is -1");
    filter.min_impulse = 0.0, filter.stride = NAN;
    expectRefused(api()->set_report_filter(m_world, &filter), RUBBLE_ERROR_ARGUMENT, "filter->stride");
    expectRefused(api()->set_report_filter(m_world, nullptr), RUBBLE_ERROR_NULL, "filter");
    step();
    EXPECT_EQ(reports().kinds, 0u);
}

}  // namespace
}  // namespace rubble
