#include <array>
#include <cmath>
#include <span>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiProperties : public AbiCreate {
protected:
    rubble_body_properties body(rubble_body handle) {
        auto out = sized<rubble_body_properties>();
        EXPECT_EQ(api()->get_body_properties(m_world, handle, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_shape_properties shape(rubble_shape handle) {
        auto out = sized<rubble_shape_properties>();
        EXPECT_EQ(api()->get_shape_properties(m_world, handle, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    void set(const rubble_body_change& change) {
        ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    }
    void set(const rubble_shape_change& change) {
        ASSERT_EQ(api()->set_shape(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    }
    rubble_body crateAt(double x, double y) {
        const rubble_body out = make(bodyAt(x, y, 0));
        m_crate = make(shapeOn(out, RUBBLE_SHAPE_BOX, 4));
        return out;
    }
    static rubble_body_change motionOf(rubble_body body, uint32_t fields) {
        auto out = sized<rubble_body_change>();
        out.body = body, out.fields = fields;
        return out;
    }
    static rubble_shape_change changeOf(rubble_shape shape, uint32_t fields, const rubble_cell_box* anchors = nullptr) {
        auto out = sized<rubble_shape_change>();
        out.shape = shape, out.fields = fields, out.anchors = anchors, out.anchor_count = anchors ? 1 : 0;
        return out;
    }
    rubble_shape m_crate = 0;
};

TEST_F(AbiProperties, ABodyFallsByItsOwnScaleOfGravity) {
    const rubble_body free = crateAt(10.0, 50.0), floats = crateAt(20.0, 50.0), rises = crateAt(30.0, 50.0);
    rubble_body_change change = motionOf(floats, RUBBLE_SET_GRAVITY_SCALE);
    set(change);
    change.body = rises, change.gravity_scale = -1.0;
    set(change);
    step(60);
    EXPECT_NEAR(bodyState(free).velocity[1], -9.81, 0.01);
    EXPECT_EQ(bodyState(floats).velocity[1], 0.0);
    EXPECT_NEAR(bodyState(rises).velocity[1], 9.81, 0.01);
    EXPECT_TRUE(bodyState(floats).flags & RUBBLE_BODY_ASLEEP) << "it rests where it is";
    EXPECT_EQ(body(rises).gravity_scale, -1.0);
}

TEST_F(AbiProperties, DampingSlowsABodyDown) {
    const rubble_body slow = crateAt(10.0, 50.0);
    rubble_body_change change = motionOf(slow, RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING | RUBBLE_SET_VELOCITY);
    change.velocity[0] = 10.0, change.angular_velocity[1] = 4.0;
    change.linear_damping = 1.0, change.angular_damping = 2.0;
    set(change);
    step(60);
    EXPECT_NEAR(bodyState(slow).velocity[0], 10.0 * std::exp(-1.0), 0.05);
    EXPECT_NEAR(bodyState(slow).angular_velocity[1], 4.0 * std::exp(-2.0), 0.05);
    EXPECT_EQ(body(slow).linear_damping, 1.0);
}

TEST_F(AbiProperties, AHandHoldsABodyAtAPlaceAndTurnsIt) {
    const rubble_body held = crateAt(10.0, 20.0);
    step();
    auto grab = sized<rubble_grab>();
    grab.body = held, grab.flags = RUBBLE_GRAB_TURNS, grab.max_force = 1e5;
    grab.point[0] = 10.2, grab.point[1] = 20.2, grab.point[2] = 0.2;
    grab.target[0] = 11.0, grab.target[1] = 21.0;
    grab.rotation[1] = grab.rotation[3] = std::sqrt(0.5);  // a quarter turn about y
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step(180);
    const rubble_body_state state = bodyState(held);
    EXPECT_NEAR(std::abs(state.rotation[1]), std::sqrt(0.5), 0.01);
    EXPECT_NEAR(state.position[0] + 0.2, 11.0, 0.05) << "the point is 0.2 along the new x and against the new z";
    EXPECT_NEAR(state.position[1] + 0.2, 21.0, 0.05);
    grab.flags = 4;
    expectRefused(api()->grab_body(m_world, &grab), RUBBLE_ERROR_ARGUMENT, "flags has unknown bits");
}

TEST_F(AbiProperties, AHandHoldsABodyAtAVelocityAndASpin) {
    const rubble_body held = crateAt(10.0, 20.0);
    step();
    auto grab = sized<rubble_grab>();
    grab.body = held, grab.flags = RUBBLE_GRAB_TURNS | RUBBLE_GRAB_VELOCITY, grab.max_force = 1e5;
    grab.point[0] = 10.2, grab.point[1] = 20.2, grab.point[2] = 0.2;  // its centre of mass
    grab.velocity[0] = 3.0, grab.velocity[1] = 0.5, grab.angular_velocity[1] = 2.0;
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step(60);
    rubble_body_state state = bodyState(held);
    EXPECT_NEAR(state.velocity[0], 3.0, 0.02) << "gravity does not change it";
    EXPECT_NEAR(state.velocity[1], 0.5, 0.02);
    EXPECT_NEAR(state.angular_velocity[1], 2.0, 0.02);
    const double before = state.position[1];
    grab.velocity[0] = grab.velocity[1] = grab.angular_velocity[1] = 0.0;
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step(60);
    state = bodyState(held);
    EXPECT_NEAR(state.position[1], before, 0.1) << "a velocity of 0 holds it where it is";
    grab.max_force = 10.0, grab.velocity[1] = 5.0;  // it weighs some 1500 N
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step(30);
    EXPECT_LT(bodyState(held).velocity[1], -3.0) << "a weak hand does not hold it";
    grab.velocity[1] = INFINITY;
    expectRefused(api()->grab_body(m_world, &grab), RUBBLE_ERROR_ARGUMENT, "velocity[1] is inf");
}

TEST_F(AbiProperties, AHandThatDrivesIsRecordedAndSaved) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    const rubble_body held = crateAt(10.0, 20.0);
    step();
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    auto grab = sized<rubble_grab>();
    grab.body = held, grab.flags = RUBBLE_GRAB_VELOCITY, grab.max_force = 1e5;
    grab.point[0] = 10.2, grab.point[1] = 20.2, grab.point[2] = 0.2, grab.velocity[2] = 1.5;
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step();
    const uint64_t first = hash();
    grab.velocity[2] = 2.5;
    ASSERT_EQ(api()->grab_body(m_world, &grab), RUBBLE_OK) << api()->get_last_error();
    step(5);
    const uint64_t end = hash();
    EXPECT_NE(end, first);
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    step(20);
    const uint64_t later = hash();
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    step(20);
    EXPECT_EQ(hash(), later) << "the hand goes on after a load";
}

TEST_F(AbiProperties, MassFollowsTheDensityOfAShape) {
    const rubble_body crate = crateAt(10.0, 5.0);
    step();
    EXPECT_NEAR(body(crate).mass, 2400.0 * 0.064, 0.01);
    EXPECT_NEAR(body(crate).center[0], 0.2, 1e-6);
    rubble_shape_change change = changeOf(m_crate, RUBBLE_SHAPE_DENSITY);
    change.density = 3.0;
    set(change);
    step();
    EXPECT_NEAR(body(crate).mass, 3.0 * 2400.0 * 0.064, 0.05);
    EXPECT_NEAR(body(crate).inertia[0], body(crate).mass * (0.16 + 0.16) / 12.0, 0.05);
    EXPECT_EQ(shape(m_crate).density, 3.0);
}

TEST_F(AbiProperties, WhatNoAnchorHoldsComesOff) {
    const rubble_shape table = shapes().at(0).shape;
    rubble_cell_box box = {};
    uint32_t count = 0;
    ASSERT_EQ(api()->get_anchors(m_world, table, &box, 1, &count), RUBBLE_OK);
    ASSERT_EQ(count, 1u);
    EXPECT_EQ(box.size[1], 1);
    box = {{0, 8, 0}, {2, 2, 2}};
    set(changeOf(table, RUBBLE_SHAPE_ANCHORS, &box));
    step(10);
    ASSERT_EQ(api()->get_anchors(m_world, table, &box, 1, &count), RUBBLE_OK);
    EXPECT_EQ(box.low[1], 8);
    EXPECT_TRUE(bodies(m_world).at(0).flags & RUBBLE_BODY_STATIC) << "held by its edge";
    set(changeOf(table, RUBBLE_SHAPE_ANCHORS));
    step(10);
    EXPECT_FALSE(bodies(m_world).at(0).flags & RUBBLE_BODY_STATIC);
    EXPECT_EQ(shape(table).is_piece, 1u);
}

TEST_F(AbiProperties, WhatWasFreeIsHeldByWhatIsItsLowestLayerNow) {
    const rubble_body post = make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), free = make(bodyAt(20.0, 5.0, 0));
    const rubble_shape shape = make(shapeOn(post, RUBBLE_SHAPE_BOX, 6));
    auto settings = sized<rubble_shape_settings>();
    settings.body = free, settings.source = RUBBLE_SHAPE_COPY, settings.copied = shape;
    const rubble_shape copy = make(settings);
    step();
    set(motionOf(post, RUBBLE_SET_DYNAMIC));
    step();
    EXPECT_EQ(this->shape(shape).anchor_count, 0u);
    EXPECT_EQ(this->shape(copy).anchor_count, 0u);
    for (const rubble_body body : {post, free}) {
        rubble_body_change change = motionOf(body, RUBBLE_SET_POSE | RUBBLE_SET_STATIC);
        change.position[0] = body == post ? 10.0 : 20.0;
        change.rotation[0] = change.rotation[3] = std::sqrt(0.5);  // y up becomes z up
        set(change);
    }
    step();
    for (const rubble_shape each : {shape, copy}) {
        rubble_cell_box box = {};
        uint32_t count = 0;
        ASSERT_EQ(api()->get_anchors(m_world, each, &box, 1, &count), RUBBLE_OK);
        EXPECT_EQ(count, 1u);
        EXPECT_EQ(box.size[2], 1) << "a layer along z";
    }
}

TEST_F(AbiProperties, DefaultAnchorsAreThoseOfAStaticShapeThatIsMade) {
    rubble_body_settings turned = bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC);
    turned.rotation[0] = turned.rotation[3] = std::sqrt(0.5);  // y up becomes z up
    const rubble_shape block = make(shapeOn(make(turned), RUBBLE_SHAPE_BOX, 6));
    const rubble_body free = crateAt(20.0, 5.0);
    step();
    const auto anchorsOf = [&](rubble_shape of) {
        std::vector<std::array<int32_t, 6>> out;
        rubble_cell_box boxes[4] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_anchors(m_world, of, boxes, 4, &count), RUBBLE_OK);
        for (const rubble_cell_box& box : std::span(boxes, count))
            out.push_back({box.low[0], box.low[1], box.low[2], box.size[0], box.size[1], box.size[2]});
        return out;
    };
    const auto made = anchorsOf(block);
    EXPECT_EQ(made.at(0)[2 + 3], 1) << "a layer along z";
    const rubble_cell_box other = {{0, 0, 0}, {1, 6, 6}};
    set(changeOf(block, RUBBLE_SHAPE_ANCHORS, &other));
    set(changeOf(m_crate, RUBBLE_SHAPE_ANCHORS, &other));
    step();
    ASSERT_NE(anchorsOf(block), made);
    set(changeOf(block, RUBBLE_SHAPE_DEFAULT_ANCHORS));
    set(changeOf(m_crate, RUBBLE_SHAPE_DEFAULT_ANCHORS));
    step();
    EXPECT_EQ(anchorsOf(block), made);
    EXPECT_TRUE(anchorsOf(m_crate).empty()) << "nothing holds a free body";
    set(motionOf(free, RUBBLE_SET_STATIC));
    step();
    EXPECT_EQ(anchorsOf(m_crate).size(), 1u);
}

TEST_F(AbiProperties, SayWhatIsBrokenUntilAnUndoMakesItWhole) {
    const rubble_body crate = crateAt(10.0, 5.0);
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    const auto isBroken = [&] { return body(crate).is_broken * 10 + shape(m_crate).is_broken; };
    EXPECT_EQ(isBroken(), 0u);
    auto carve = sized<rubble_carve>();
    carve.shape = m_crate, carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.15;
    std::copy_n(bodyState(crate).position, 3, carve.position);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    step();
    EXPECT_EQ(isBroken(), 11u);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(isBroken(), 0u);
}

TEST_F(AbiProperties, AreRecordedReplayedUndoneAndSaved) {
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog", save = folder / "game.rubble";
    const rubble_body crate = crateAt(10.0, 5.0);
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    const double mass = body(crate).mass;
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    rubble_shape_change change =
        changeOf(m_crate, RUBBLE_SHAPE_STRENGTH | RUBBLE_SHAPE_DENSITY | RUBBLE_SHAPE_EMISSION | RUBBLE_SHAPE_LOAD);
    change.strength = 2.0, change.density = 0.5, change.emission = 4.0;
    set(change);
    rubble_body_change motion = motionOf(crate, RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING);
    motion.gravity_scale = 0.5, motion.angular_damping = 3.0;
    set(motion);
    step(5);
    const auto isChanged = [&] {
        const rubble_shape_properties now = shape(m_crate);
        return now.strength == 2.0 && now.density == 0.5 && now.emission == 4.0 && now.bears_load == 0 &&
               body(crate).gravity_scale == 0.5 && body(crate).angular_damping == 3.0;
    };
    EXPECT_TRUE(isChanged());
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->save_game(m_world, save.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(shape(m_crate).strength, 1.0);
    EXPECT_EQ(shape(m_crate).bears_load, 1u);
    EXPECT_EQ(body(crate).mass, mass);
    EXPECT_EQ(body(crate).gravity_scale, 1.0);
    ASSERT_EQ(api()->redo(m_world), RUBBLE_OK);
    step();
    EXPECT_TRUE(isChanged());
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isChanged());
    ASSERT_EQ(api()->load_game(m_world, save.c_str()), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(hash(), end);
    EXPECT_TRUE(isChanged());
}

TEST_F(AbiProperties, BadArgumentsAreRefused) {
    const rubble_shape table = shapes().at(0).shape;
    const auto refused = [&](const rubble_shape_change& change, rubble_result code, const char* word) {
        expectRefused(api()->set_shape(m_world, &change), code, word);
    };
    refused(changeOf(table, 0), RUBBLE_ERROR_ARGUMENT, "fields is 0");
    refused(changeOf(table, 64), RUBBLE_ERROR_ARGUMENT, "fields has unknown bits");
    refused(changeOf(table, RUBBLE_SHAPE_ANCHORS | RUBBLE_SHAPE_DEFAULT_ANCHORS), RUBBLE_ERROR_ARGUMENT, "one of them");
    refused(changeOf(table, RUBBLE_SHAPE_STRENGTH), RUBBLE_ERROR_ARGUMENT, "strength is 0");
    refused(changeOf(table, RUBBLE_SHAPE_DENSITY), RUBBLE_ERROR_ARGUMENT, "density is 0");
    refused(changeOf(0, RUBBLE_SHAPE_LOAD), RUBBLE_ERROR_STALE, "shape is 0");
    const rubble_cell_box empty = {{0, 0, 0}, {1, 0, 1}};
    refused(changeOf(table, RUBBLE_SHAPE_ANCHORS, &empty), RUBBLE_ERROR_ARGUMENT, "anchors[0].size is 0");
    rubble_shape_change change = changeOf(table, RUBBLE_SHAPE_ANCHORS);
    change.anchor_count = 1;
    refused(change, RUBBLE_ERROR_NULL, "anchors is null");
    rubble_body_change motion = motionOf(bodies(m_world).at(0).body, RUBBLE_SET_GRAVITY_SCALE);
    motion.gravity_scale = 101.0;
    expectRefused(api()->set_body(m_world, &motion), RUBBLE_ERROR_ARGUMENT, "gravity_scale is 101");
    motion.fields = RUBBLE_SET_DAMPING, motion.linear_damping = -1.0;
    expectRefused(api()->set_body(m_world, &motion), RUBBLE_ERROR_ARGUMENT, "linear_damping is -1");
    expectRefused(api()->set_physics_threads(m_world, 0), RUBBLE_ERROR_ARGUMENT, "threads is 0, expected 1 to 64");
}

TEST_F(AbiProperties, PhysicsTakesAnotherPresetAndOtherThreadsWhileItRuns) {
    uint64_t hashes[2] = {};
    for (const uint32_t threads : {1u, 3u}) {
        const rubble_world world = makeWorld();
        auto settings = sized<rubble_settings>();
        ASSERT_EQ(api()->get_settings(world, &settings), RUBBLE_OK);
        settings.physics_preset = RUBBLE_PHYSICS_ACCURATE;
        ASSERT_EQ(api()->set_settings(world, &settings), RUBBLE_OK) << api()->get_last_error();
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(world, &explosion), RUBBLE_OK);
        for (int i = 0; i < 30; ++i) {
            if (i == 5) {
                ASSERT_EQ(api()->set_physics_threads(world, threads), RUBBLE_OK);
            }
            ASSERT_EQ(api()->step(world), RUBBLE_OK);
        }
        ASSERT_EQ(api()->get_settings(world, &settings), RUBBLE_OK);
        EXPECT_EQ(settings.physics_preset, uint32_t(RUBBLE_PHYSICS_ACCURATE));
        ASSERT_EQ(api()->get_state_hash(world, &hashes[threads > 1]), RUBBLE_OK);
        api()->destroy_world(world);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    step(30);
    EXPECT_NE(hash(), hashes[0]) << "the preset makes a difference";
}

}  // namespace
}  // namespace rubble
