#include <algorithm>
#include <array>
#include <cstring>

#include "runtime/assets/save_file.h"
#include "tests/abi/refusals/effective_calls.h"
#include "tests/abi/refusals/refusals_fixture.h"

namespace rubble {
namespace {

/// What a call does not change in the world, or not for others: "FUNCTION" or "FUNCTION ARGUMENT.FIELD", and why.
const std::map<std::string, std::string> kNotHashed = {
    {"set_host_data", "the host's own bytes"},
};
/// What deltas leave out: apply_deltas() says so.
const std::map<std::string, std::string> kNotInDeltas = {
    {"heat", "heat"},
    {"extinguish", "heat"},
};

/// What an undo drops: damage that physics has found, and that the next step would have carried out.
const std::map<std::string, std::string> kNotRedone = {
    {"add_joint settings.break_force", "it breaks"},
    {"add_joint settings.break_torque", "it breaks"},
    {"create_joint settings.break_force", "it breaks"},
    {"create_joint settings.break_torque", "it breaks"},
};
/// Functions that are called on the main thread of a world and change nothing in its state.
const std::set<std::string> kNoState = {
    "apply_edits",         "has_changed",        "save_level",        "cast_ray",        "cast_rays",
    "cast_shapes",         "count_carve",        "count_fires",       "create_renderer", "find_by_name",
    "find_by_tag",         "find_closest_point", "find_closest_fire", "find_material",   "mesh_brick",
    "overlap_bodies",      "overlap_shapes",     "set_report_filter", "spawn_particles", "translate_handle",
    "set_physics_threads", "get_level_hash"};

/// A field of a struct that a call reads, which gets another value; no field: the call as it is.
struct Variation {
    std::string place;
    std::function<void(HostCall&)> make = [](HostCall&) {};
};

/// Every function of the table that changes a world, in all the ways in which hosts call it and with another value in
/// each field: what it changes is hashed, saved, undone, redone, in deltas and in recordings.
class State : public Refusals {
protected:
    using Bytes = std::vector<uint8_t>;

    static Bytes save(rubble_world world) {
        uint64_t size = 0;
        EXPECT_EQ(api()->save_game_data(world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        Bytes out(size);
        EXPECT_EQ(api()->save_game_data(world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    static Bytes takeDeltas(rubble_world world) {
        uint64_t size = 0;
        EXPECT_EQ(api()->take_deltas(world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        Bytes out(size);
        EXPECT_EQ(api()->take_deltas(world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// A saved game without what deltas leave out.
    static Bytes withoutTheUnfollowed(const Bytes& bytes) {
        Result<SavedGame> game = gameFromBytes(bytes, "game", 1);
        if (!game) return ADD_FAILURE() << game.error(), Bytes();
        game->world.fire = {};
        game->world.pendingSplits.clear();
        game->world.hostData.clear();
        game->world.joints.forEach([](JointHandle, Joint& joint) { joint.points.assign(joint.points.size(), {}); });
        game->pending.clear();
        return gameToBytes(*game);
    }
    static uint64_t resolved(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_resolved_hash(world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    static uint64_t hashOf(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_state_hash(world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// Whether the last step could not make what was asked for.
    static bool isRefused(rubble_world world) {
        uint32_t count = 0;
        EXPECT_NE(api()->get_refusals(world, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT) << api()->get_last_error();
        return count > 0;
    }
    static void stepOnce(rubble_world world) { ASSERT_EQ(api()->step(world), RUBBLE_OK) << api()->get_last_error(); }

    /// A world of its own that was loaded from a saved game.
    struct Loaded {
        Loaded(const Bytes& game, bool byHost) {
            auto settings = sized<rubble_world_settings>();
            settings.flags = RUBBLE_WORLD_NO_RENDERER | (byHost ? RUBBLE_WORLD_HOST_PHYSICS : 0);
            EXPECT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
            EXPECT_EQ(api()->load_game_data(world, game.data(), game.size()), RUBBLE_OK) << api()->get_last_error();
        }
        ~Loaded() { api()->destroy_world(world); }
        Loaded(const Loaded&) = delete;
        Loaded& operator=(const Loaded&) = delete;
        rubble_world world = 0;
    };

    static bool isEdit(const FunctionDescription& function) {
        static const std::set<std::string> others = {"step",           "destroy_world",
                                                     "load_level",     "load_level_data",
                                                     "load_game",      "load_game_data",
                                                     "save_game",      "save_game_data",
                                                     "play_recording", "start_recording",
                                                     "stop_recording", "start_loading",
                                                     "finish_loading", "keep_deltas",
                                                     "take_deltas",    "apply_deltas",
                                                     "add_undo_mark",  "undo",
                                                     "redo",           "play_recording_data",
                                                     "cancel_loading", "set_undo_limit"};
        return isOfWorld(function) && function.thread == "main" && !others.contains(function.name) &&
               !function.name.starts_with("get_") && !function.name.starts_with("read_");
    }
    static void addFields(size_t argument, const StructDescription& type, size_t base, const std::string& owner,
                          std::vector<Variation>& out) {
        for (const FieldDescription& field : type.fields) {
            const std::string place = owner + "." + field.name;
            if (const StructDescription* inner = structOf(field.type + "*")) {
                addFields(argument, *inner, base + field.offset, place, out);
                continue;
            }
            const bool isNumber = field.type == "double" || field.type == "uint32_t" || field.type == "uint64_t" ||
                                  field.type == "int32_t";
            if (!isNumber || field.name == "struct_size" || field.name.ends_with("count") || field.name == "size")
                continue;
            const auto change = [=, offset = base + field.offset, kind = field.type](HostCall& call) {
                unsigned char* at = call.memoryOf(argument) + offset;
                if (kind == "double") {
                    double value;
                    std::memcpy(&value, at, sizeof value);
                    value = value * 0.5 + 0.25;
                    std::memcpy(at, &value, sizeof value);
                } else {
                    uint32_t value;
                    std::memcpy(&value, at, sizeof value);
                    value = field.name == "flags" || field.name == "fields" ? value ^ 1 : value + 1;
                    std::memcpy(at, &value, sizeof value);
                }
            };
            out.push_back({place, change});
        }
    }
    static std::vector<Variation> variationsOf(const FunctionDescription& function) {
        std::vector<Variation> out = {{}};
        for (size_t i = 0; i < function.arguments.size(); ++i) {
            const ArgumentDescription& argument = function.arguments[i];
            const StructDescription* type = structOf(argument.type);
            if (type && argument.type.starts_with("const ")) addFields(i, *type, 0, argument.name, out);
        }
        return out;
    }
    static bool isListed(const std::map<std::string, std::string>& list, const FunctionDescription& function,
                         const Variation& variation) {
        return list.contains(function.name) || list.contains(function.name + " " + variation.place);
    }

    /// Counts the calls that were accepted and changed the world.
    void check(const FunctionDescription& function, Prepare prepare, const Variation& variation) {
        const auto world = makeWorld(function);
        const rubble_world changed = world->world();
        const bool byHost = function.name == "set_body_states" || function.name == "report_impacts";
        ASSERT_EQ(api()->set_undo_limit(changed, 5), RUBBLE_OK);
        stepOnce(changed);
        HostCall call(function, *world);
        prepare(call);
        if (const auto effect = effectiveCalls().find(function.name); effect != effectiveCalls().end())
            effect->second(call);
        variation.make(call);
        const std::string path = *s_folder / "state.rubblelog";
        ASSERT_EQ(api()->start_recording(changed, path.c_str()), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->keep_deltas(changed, RUBBLE_DELTAS_ALL), RUBBLE_OK);
        const Bytes start = save(changed);
        const Loaded same(start, byHost), follower(start, byHost);
        ASSERT_EQ(api()->add_undo_mark(changed), RUBBLE_OK);
        if (byHost)  // what it says counts at once, for a mark of the same step too
            for (const rubble_world each : {changed, same.world}) stepOnce(each);
        if (call.call() != RUBBLE_OK) return;
        stepOnce(changed);
        stepOnce(same.world);
        if (isRefused(changed)) {
            EXPECT_EQ(hashOf(changed), hashOf(same.world)) << "by an edit that was refused";
            return;
        }
        const Bytes after = save(changed);
        if (after == save(same.world)) return;
        ++m_changes[function.name];
        if (!isListed(kNotHashed, function, variation)) {
            EXPECT_NE(hashOf(changed), hashOf(same.world)) << "saved, but not hashed";
        }
        const Bytes deltas = takeDeltas(changed);
        ASSERT_EQ(api()->apply_deltas(follower.world, deltas.data(), deltas.size()), RUBBLE_OK)
            << api()->get_last_error();
        EXPECT_EQ(resolved(follower.world), resolved(changed));
        if (!isListed(kNotInDeltas, function, variation)) {
            EXPECT_TRUE(withoutTheUnfollowed(save(follower.world)) == withoutTheUnfollowed(after)) << "not in deltas";
        }
        const Loaded loaded(after, byHost);
        EXPECT_EQ(hashOf(loaded.world), hashOf(changed)) << "not saved";
        EXPECT_TRUE(save(loaded.world) == after) << "saved, but not loaded";
        ASSERT_EQ(api()->undo(changed), RUBBLE_OK);
        stepOnce(changed);
        EXPECT_EQ(resolved(changed), resolved(same.world)) << "not undone";
        ASSERT_EQ(api()->redo(changed), RUBBLE_OK);
        stepOnce(changed);
        stepOnce(loaded.world);
        if (!isListed(kNotRedone, function, variation)) {
            EXPECT_EQ(resolved(changed), resolved(loaded.world)) << "not redone";
        }
        ASSERT_EQ(api()->stop_recording(changed), RUBBLE_OK) << api()->get_last_error();
        const Loaded replayed(start, byHost);
        uint64_t steps = 0;
        EXPECT_EQ(api()->play_recording(replayed.world, path.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(steps, byHost ? 4u : 3u);
        EXPECT_EQ(hashOf(replayed.world), hashOf(changed)) << "not recorded";
    }

    std::map<std::string, int> m_changes;
};

TEST_F(State, WhatAnyCallChangesIsHashedSavedUndoneAndFollowed) {
    for (const FunctionDescription& function : functions(false)) {
        if (!isEdit(function)) continue;
        for (const Prepare prepare : waysOf(function))
            for (const Variation& variation : variationsOf(function)) {
                SCOPED_TRACE(function.name + " " + variation.place);
                check(function, prepare, variation);
            }
    }
    EXPECT_GT(m_changes["set_settings"], 25) << "of its fields";
    EXPECT_GT(m_changes["set_environment"], 15);
    for (const FunctionDescription& function : functions(false))
        EXPECT_NE(m_changes.contains(function.name), !isEdit(function) || kNoState.contains(function.name))
            << function.name << ": say in effective_calls.cpp how it changes something, or in kNoState that it cannot";
}

/// A world without a level: a floor of 8 m, and what a test makes.
class Created {
public:
    explicit Created(uint32_t flags = 0) {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER | flags;
        EXPECT_EQ(api()->create_world(&settings, &world), RUBBLE_OK) << api()->get_last_error();
        makeBox(makeBody({-4.0, -0.4, -4.0}, RUBBLE_BODY_STATIC), {80, 4, 80});
        step();
    }
    ~Created() { api()->destroy_world(world); }
    Created(const Created&) = delete;
    Created& operator=(const Created&) = delete;

    rubble_body makeBody(const std::array<double, 3>& position, uint32_t flags = 0) const {
        auto body = sized<rubble_body_settings>();
        std::copy_n(position.begin(), 3, body.position), body.flags = flags;
        rubble_body out = 0;
        EXPECT_EQ(api()->create_body(world, &body, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_shape makeBox(rubble_body body, const std::array<int32_t, 3>& size) const {
        auto shape = sized<rubble_shape_settings>();
        shape.body = body, shape.source = RUBBLE_SHAPE_BOX, shape.index = 6;
        std::copy_n(size.begin(), 3, shape.size);
        rubble_shape out = 0;
        EXPECT_EQ(api()->create_shape(world, &shape, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// A beam under a static cube, from a joint: of a rope, the beam is 0.8 m lower and aside.
    void hang(uint32_t kind, double x) const {
        const bool isRope = kind == RUBBLE_JOINT_ROPE;
        auto joint = sized<rubble_joint_settings>();
        joint.kind = kind;
        joint.shapes[0] = makeBox(makeBody({x, 5.0, 0.0}, RUBBLE_BODY_STATIC), {2, 2, 2});
        joint.shapes[1] = makeBox(makeBody({x + (isRope ? 0.5 : 0.1), isRope ? 4.0 : 4.8, 0.0}), {6, 2, 2});
        joint.position[0] = x + 0.1, joint.position[1] = 5.0, joint.position[2] = 0.1;
        joint.rope_end[0] = x + 0.6, joint.rope_end[1] = 4.2, joint.rope_end[2] = 0.1;
        rubble_joint out = 0;
        EXPECT_EQ(api()->create_joint(world, &joint, &out), RUBBLE_OK) << api()->get_last_error();
    }
    void step(int count = 1) const {
        for (int i = 0; i < count; ++i) ASSERT_EQ(api()->step(world), RUBBLE_OK) << api()->get_last_error();
    }

    rubble_world world = 0;
};

TEST_F(State, WhatFollowsAnUndoDoesNotDependOnWhenItComes) {
    std::set<uint64_t> ends;
    for (const int wait : {1, 2, 5, 40}) {
        const Created scene;
        ASSERT_EQ(api()->set_undo_limit(scene.world, 2), RUBBLE_OK);
        scene.hang(RUBBLE_JOINT_ROPE, -2.0), scene.hang(RUBBLE_JOINT_HINGE, 0.0), scene.hang(RUBBLE_JOINT_BALL, 2.0);
        for (int i = 0; i < 4; ++i) scene.makeBox(scene.makeBody({0.1 * i, 0.5 + 0.6 * i, 2.0}), {5, 5, 5});
        scene.step(30);
        ASSERT_EQ(api()->add_undo_mark(scene.world), RUBBLE_OK);
        scene.step(wait);
        ASSERT_EQ(api()->undo(scene.world), RUBBLE_OK);
        scene.step(60);
        ends.insert(resolved(scene.world));
    }
    EXPECT_EQ(ends.size(), 1u);
}

TEST_F(State, AFollowerKeepsUpWithAHostThatPutsBodiesToSleep) {
    const Created scene(RUBBLE_WORLD_HOST_PHYSICS);
    rubble_body_state state = {};
    state.body = scene.makeBody({0.0, 1.0, 0.0});
    scene.makeBox(state.body, {8, 8, 8});
    scene.step(2);
    ASSERT_EQ(api()->keep_deltas(scene.world, RUBBLE_DELTAS_ALL), RUBBLE_OK);
    const Loaded follower(save(scene.world), true);
    for (const uint32_t flags : {0u, RUBBLE_BODY_ASLEEP + 0u, RUBBLE_BODY_ASLEEP + 0u, 0u, RUBBLE_BODY_ASLEEP + 0u}) {
        state.position[1] += 0.05, state.flags = flags;
        ASSERT_EQ(api()->set_body_states(scene.world, &state, 1), RUBBLE_OK) << api()->get_last_error();
        scene.step();
        const Bytes deltas = takeDeltas(scene.world);
        ASSERT_EQ(api()->apply_deltas(follower.world, deltas.data(), deltas.size()), RUBBLE_OK)
            << api()->get_last_error();
        EXPECT_EQ(hashOf(follower.world), hashOf(scene.world));
    }
}

TEST_F(State, AGameIsNotSavedWhileAnUndoOrRedoWaits) {
    const Created scene;
    const std::string path = *s_folder / "undo.rubble";
    uint64_t size = 0;
    for (const auto goBackOrForth : {api()->undo, api()->redo}) {
        ASSERT_EQ(goBackOrForth(scene.world), RUBBLE_OK);
        EXPECT_EQ(api()->save_game(scene.world, path.c_str()), RUBBLE_ERROR_ARGUMENT);
        EXPECT_EQ(api()->save_game_data(scene.world, nullptr, 0, &size), RUBBLE_ERROR_ARGUMENT);
        EXPECT_NE(std::string(api()->get_last_error()).find("undo"), std::string::npos) << api()->get_last_error();
        scene.step();
        EXPECT_EQ(api()->save_game(scene.world, path.c_str()), RUBBLE_OK) << api()->get_last_error();
    }
}

TEST_F(State, AWorldWithoutALevelEndsAroundWhatWasCreated) {
    const Created scene;
    auto bounds = sized<rubble_bounds>();
    ASSERT_EQ(api()->get_bounds(scene.world, &bounds), RUBBLE_OK);
    EXPECT_NEAR(bounds.low[0], -132.0, 1e-6) << "the floor, and 128 m";
    EXPECT_NEAR(bounds.high[1], 128.0, 1e-6);
    const rubble_body fallen = scene.makeBody({20.0, 0.0, 0.0});
    scene.makeBox(fallen, {2, 2, 2});
    scene.step(600);
    rubble_body_state state = {};
    EXPECT_EQ(api()->get_body_state(scene.world, fallen, &state), RUBBLE_ERROR_STALE) << "it is dust";
    ASSERT_EQ(api()->get_bounds(scene.world, &bounds), RUBBLE_OK);
    EXPECT_NEAR(bounds.high[0], 20.2 + 128.0, 1e-6) << "where it was created";
    EXPECT_NEAR(bounds.low[1], -0.4 - 128.0, 1e-6) << "not where it fell";
}

}  // namespace
}  // namespace rubble
