#pragma once
#include <span>
#include <vector>

#include "runtime/core/handle.h"
#include "tests/abi/create_fixture.h"

namespace rubble {

/// A world and another one that was equal when the first began to keep deltas.
class AbiDeltas : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        m_other = makeWorld();
        copyTo(m_other);
    }
    void TearDown() override {
        api()->destroy_world(m_other);
        AbiCreate::TearDown();
    }
    void copyTo(rubble_world other, uint32_t kept = RUBBLE_DELTAS_ALL) {
        uint64_t size = 0;
        ASSERT_EQ(api()->keep_deltas(m_world, kept), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->save_game_data(m_world, nullptr, 0, &size), RUBBLE_OK);
        std::vector<uint8_t> data(size);
        ASSERT_EQ(api()->save_game_data(m_world, data.data(), size, &size), RUBBLE_OK);
        ASSERT_EQ(api()->load_game_data(other, data.data(), size), RUBBLE_OK) << api()->get_last_error();
    }
    std::vector<uint8_t> take() {
        uint64_t size = 0;
        EXPECT_EQ(api()->take_deltas(m_world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> out(size);
        EXPECT_EQ(api()->take_deltas(m_world, out.data(), size, &size), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_result apply(const std::vector<uint8_t>& data) {
        return api()->apply_deltas(m_other, data.data(), data.size());
    }
    static uint64_t resolved(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_resolved_hash(world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    static uint64_t voxels(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_voxel_hash(world, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    static std::vector<rubble_body_state> movedIn(rubble_world world) {
        auto list = sized<rubble_row_list>();
        list.kind = RUBBLE_ROWS_MOVED_BODIES;
        uint32_t count = 0;
        EXPECT_EQ(api()->read_rows(world, &list, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        std::vector<rubble_body_state> out(count);
        EXPECT_EQ(api()->read_rows(world, &list, out.data(), count, &count), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// What moved in the leader, with the handles of the other world.
    std::vector<rubble_body_state> movedForOther() {
        std::vector<rubble_body_state> out = movedIn(m_world);
        for (rubble_body_state& state : out)
            EXPECT_EQ(api()->translate_handle(m_other, state.body, &state.body), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    /// The other world becomes one that the host moves, and follows without motion from now on.
    void followWithoutMotion() {
        api()->destroy_world(m_other);
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_HOST_PHYSICS | RUBBLE_WORLD_NO_RENDERER;
        ASSERT_EQ(api()->create_world(&settings, &m_other), RUBBLE_OK) << api()->get_last_error();
        copyTo(m_other, RUBBLE_DELTAS_EDITS);
    }
    void breakTable() {
        const rubble_explosion explosion = tableExplosion();
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    }

    /// What the last step tells but the step itself, by kind, as numbers; handles without that of their world.
    static std::vector<std::vector<double>> toldBy(rubble_world world) {
        auto events = sized<rubble_events>();
        auto reports = sized<rubble_reports>();
        EXPECT_EQ(api()->get_events(world, &events), RUBBLE_OK);
        EXPECT_EQ(api()->get_reports(world, &reports), RUBBLE_OK);
        const auto name = [](uint64_t handle) { return double(withWorld(handle, 0) % (uint64_t(1) << 53)); };
        std::vector<std::vector<double>> out(5);  // painted, removed, split, dust, bodies and breaks
        if (events.painted_voxel_count) out[0].push_back(double(events.painted_voxel_count));
        for (const auto& each : std::span(events.removed, events.removed_count))
            out[1].insert(out[1].end(), {name(each.shape), double(each.count), double(each.palette_index),
                                         double(each.material), double(each.color[0])});
        for (const auto& each : std::span(events.splits, events.split_count))
            out[2].insert(out[2].end(), {name(each.parent), name(each.piece), double(each.parent_offset[0]),
                                         double(each.parent_offset[1]), double(each.parent_offset[2])});
        for (const auto& each : std::span(events.dust_clouds, events.dust_cloud_count)) {
            out[3].insert(out[3].end(), {each.radius, double(each.count), double(each.material)});
            out[3].insert(out[3].end(), each.position, each.position + 3);
            out[3].insert(out[3].end(), each.velocity, each.velocity + 3);
        }
        for (const auto& list : {std::span(events.bodies_broken, events.bodies_broken_count),
                                 std::span(events.bodies_settled, events.bodies_settled_count),
                                 std::span(events.bodies_unsettled, events.bodies_unsettled_count)})
            for (const rubble_body body : list) out[4].push_back(name(body));
        for (const auto& each : std::span(reports.breaks, reports.break_count))
            out[4].insert(out[4].end(), {double(each.material), double(each.voxels), each.radius});
        return out;
    }

    rubble_world m_other = 0;
};

}  // namespace rubble
