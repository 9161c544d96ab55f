#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "tests/abi/abi_fixture.h"

namespace rubble {

/// A world with the table of the test level in it.
class AbiCreate : public Abi {
protected:
    static rubble_body_settings bodyAt(double x, double y, uint32_t flags) {
        auto out = sized<rubble_body_settings>();
        out.position[0] = x, out.position[1] = y;
        out.flags = flags;
        return out;
    }
    static rubble_shape_settings shapeOn(rubble_body body, uint32_t source, int32_t side) {
        auto out = sized<rubble_shape_settings>();
        out.body = body, out.source = source, out.index = 6;  // concrete
        std::fill_n(out.size, 3, side);
        return out;
    }
    rubble_body make(const rubble_body_settings& settings) {
        rubble_body out = 0;
        EXPECT_EQ(api()->create_body(m_world, &settings, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_shape make(const rubble_shape_settings& settings) {
        rubble_shape out = 0;
        EXPECT_EQ(api()->create_shape(m_world, &settings, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    std::vector<rubble_refusal> refusals() {
        rubble_refusal rows[8] = {};
        uint32_t count = 0;
        EXPECT_EQ(api()->get_refusals(m_world, rows, 8, &count), RUBBLE_OK);
        return {rows, rows + count};
    }
    rubble_shape_state state(rubble_shape shape) {
        for (const rubble_shape_state& each : shapes())
            if (each.shape == shape) return each;
        ADD_FAILURE() << "there is no such shape";
        return {};
    }
    rubble_body_state bodyState(rubble_body body) {
        rubble_body_state out = {};
        EXPECT_EQ(api()->get_body_state(m_world, body, &out), RUBBLE_OK) << api()->get_last_error();
        return out;
    }
    rubble_voxel_box wholeOf(rubble_shape shape, int32_t side) {
        auto box = sized<rubble_voxel_box>();
        box.shape = shape;
        std::fill_n(box.size, 3, side);
        return box;
    }
    std::vector<uint8_t> read(const rubble_voxel_box& box) {
        std::vector<uint8_t> out(size_t(box.size[0] * box.size[1] * box.size[2]));
        uint64_t count = 0;
        EXPECT_EQ(api()->read_voxels(m_world, &box, out.data(), out.size(), &count), RUBBLE_OK);
        return out;
    }
    bool isStale(uint64_t handle) {
        uint64_t here = 0;
        return api()->translate_handle(m_world, handle, &here) == RUBBLE_ERROR_STALE;
    }
};

}  // namespace rubble
