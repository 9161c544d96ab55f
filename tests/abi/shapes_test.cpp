#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/abi/abi_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

class AbiShapes : public Abi {
protected:
    std::vector<uint8_t> voxels(const rubble_shape_state& shape, uint32_t what = RUBBLE_VOXEL_INDEX) {
        auto box = sized<rubble_voxel_box>();
        box.shape = shape.shape;
        box.what = what;
        std::copy_n(shape.size, 3, box.size);
        uint64_t count = 0;
        EXPECT_EQ(api()->read_voxels(m_world, &box, nullptr, 0, &count), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> out(count, 99);
        EXPECT_EQ(api()->read_voxels(m_world, &box, out.data(), count, &count), RUBBLE_OK);
        return out;
    }
    uint32_t fires() {
        uint32_t count = 0;
        EXPECT_EQ(api()->get_fires(m_world, nullptr, 0, &count), RUBBLE_OK);
        return count;
    }
    /// Loads a table that burns.
    void loadWood() {
        const std::string level = writeTestLevel("wood");
        ASSERT_EQ(api()->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << api()->get_last_error();
        std::filesystem::remove(level);
        step();
    }
    static rubble_heat lighter() {
        auto heat = sized<rubble_heat>();
        heat.position[0] = heat.position[2] = 0.85, heat.position[1] = 1.0;
        heat.flags = RUBBLE_HEAT_IGNITE;
        return heat;
    }
};

TEST_F(AbiShapes, VoxelsAreReadAsTheLastStepLeftThem) {
    const std::vector<uint8_t> before = voxels(shapes()[0]);
    ASSERT_EQ(before.size(), size_t(17 * 10 * 17));
    EXPECT_EQ(std::count(before.begin(), before.end(), 1), 650);
    EXPECT_EQ(before[0], 0) << "beside the leg";
    EXPECT_EQ(before[size_t(8 * 17)], 1) << "cell 0, 8, 0 of the top";
    auto carve = sized<rubble_carve>();
    carve.brush = RUBBLE_BRUSH_BOX;
    carve.position[1] = 0.95;
    for (double& half : carve.half_size) half = 0.11;
    ASSERT_EQ(api()->carve(m_world, &carve), RUBBLE_OK);
    EXPECT_EQ(voxels(shapes()[0]), before) << "not yet";
    step();
    EXPECT_EQ(voxels(shapes()[0])[size_t(9 * 17)], 0);

    auto box = sized<rubble_voxel_box>();
    box.shape = shapes()[0].shape;
    for (int a = 0; a < 3; ++a) box.low[a] = -2, box.size[a] = 2;
    uint8_t outside[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    uint64_t count = 0;
    ASSERT_EQ(api()->read_voxels(m_world, &box, outside, 8, &count), RUBBLE_OK);
    EXPECT_EQ(std::count(outside, outside + 8, 0), 8);
    expectRefused(api()->read_voxels(m_world, &box, outside, 7, &count), RUBBLE_ERROR_CAPACITY, "8 cells");
    EXPECT_EQ(count, 8u);
    box.size[1] = 0;
    expectRefused(api()->read_voxels(m_world, &box, outside, 8, &count), RUBBLE_ERROR_ARGUMENT, "size[1] is 0");
    box.size[1] = 2, box.what = 2;
    expectRefused(api()->read_voxels(m_world, &box, outside, 8, &count), RUBBLE_ERROR_ARGUMENT, "box->what is 2");
    box.what = 0, box.shape = m_world;
    expectRefused(api()->read_voxels(m_world, &box, outside, 8, &count), RUBBLE_ERROR_STALE, "box->shape");
}

TEST_F(AbiShapes, VoxelsAreWrittenIntoAGridThatIsResizedInTheSameStep) {
    const rubble_shape shape = shapes()[0].shape;
    auto resize = sized<rubble_resize>();
    resize.shape = shape;
    resize.size[0] = 30, resize.size[1] = 4, resize.size[2] = 17;
    auto box = sized<rubble_voxel_box>();
    box.shape = shape;
    box.low[0] = 29;
    for (int& side : box.size) side = 1;
    const uint8_t voxel = 1;
    expectRefused(api()->write_voxels(m_world, &box, &voxel, 1), RUBBLE_ERROR_ARGUMENT, "expected 0 to 16");
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK);
    EXPECT_EQ(api()->write_voxels(m_world, &box, &voxel, 1), RUBBLE_OK) << api()->get_last_error();
    box.low[1] = 5;
    expectRefused(api()->write_voxels(m_world, &box, &voxel, 1), RUBBLE_ERROR_ARGUMENT, "axis 1, expected 0 to 3");
    step();
    expectRefused(api()->write_voxels(m_world, &box, &voxel, 1), RUBBLE_ERROR_ARGUMENT, "expected 0 to 3");
    resize.size[1] = 10;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK);
    ASSERT_EQ(api()->trim_shape(m_world, shape), RUBBLE_OK);
    EXPECT_EQ(api()->write_voxels(m_world, &box, &voxel, 1), RUBBLE_OK) << "only the step knows how large it is then";
}

TEST_F(AbiShapes, ABodyIsSetInMotionByTheStepThatFreesIt) {
    auto change = sized<rubble_body_change>();
    change.body = bodies(m_world)[0].body;
    change.rotation[3] = 1.0;
    change.fields = RUBBLE_SET_STATIC;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    change.fields = RUBBLE_SET_VELOCITY;
    change.velocity[1] = 5.0;
    expectRefused(api()->set_body(m_world, &change), RUBBLE_ERROR_ARGUMENT, "static");
    change.fields = RUBBLE_SET_DYNAMIC;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK);
    change.fields = RUBBLE_SET_VELOCITY;
    ASSERT_EQ(api()->set_body(m_world, &change), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_GT(bodies(m_world)[0].velocity[1], 4.0);
}

TEST_F(AbiShapes, ShapesAreResizedTrimmedAndSplit) {
    auto resize = sized<rubble_resize>();
    resize.shape = shapes()[0].shape;
    resize.low[0] = -3;
    resize.size[0] = 30, resize.size[1] = 10, resize.size[2] = 17;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK) << api()->get_last_error();
    step();
    EXPECT_EQ(shapes()[0].size[0], 30);
    EXPECT_EQ(shapes()[0].voxel_count, 650u);
    ASSERT_EQ(api()->trim_shape(m_world, resize.shape), RUBBLE_OK);
    step();
    EXPECT_EQ(shapes()[0].size[0], 17);
    resize.low[0] = 0, resize.size[0] = 8;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK);
    step();
    EXPECT_EQ(shapes()[0].voxel_count, uint64_t(8 * 2 * 17 + 8 * 3)) << "the first 8 cells along x";
    EXPECT_EQ(api()->split_shape(m_world, resize.shape), RUBBLE_OK);
    step();
    EXPECT_EQ(shapes().size(), 1u) << "it is in one part";
    resize.size[2] = 5000;
    expectRefused(api()->resize_shape(m_world, &resize), RUBBLE_ERROR_ARGUMENT, "size[2] is 5000");
    expectRefused(api()->trim_shape(m_world, 0), RUBBLE_ERROR_STALE, "shape is 0");
    expectRefused(api()->merge_shape(m_world, resize.shape, resize.shape), RUBBLE_ERROR_ARGUMENT, "into is the shape");
    expectRefused(api()->detach_joint(m_world, 0, resize.shape), RUBBLE_ERROR_STALE, "joint is 0");
}

TEST_F(AbiShapes, FiresAreLitCountedAndPutOut) {
    loadWood();
    EXPECT_EQ(fires(), 0u);
    const rubble_heat heat = lighter();
    ASSERT_EQ(api()->heat(m_world, &heat), RUBBLE_OK) << api()->get_last_error();
    for (int i = 0; i < 5; ++i) step();
    const uint32_t lit = fires();
    ASSERT_GT(lit, 0u);
    std::vector<rubble_fire> rows(lit);
    uint32_t count = 0;
    ASSERT_EQ(api()->get_fires(m_world, rows.data(), lit, &count), RUBBLE_OK);
    double before[3], behind[3];  // it
    for (int a = 0; a < 3; ++a) before[a] = rows[0].position[a] - 1e-3, behind[a] = before[a] + 2e-3;
    const double far[3] = {1e3, 0.0, 0.0};
    uint32_t there = 0;
    rubble_fire closest = {};
    ASSERT_EQ(api()->count_fires(m_world, before, behind, &there), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(there, 1u);
    ASSERT_EQ(api()->find_closest_fire(m_world, behind, 0.1, &closest), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(closest.shape, rows[0].shape);
    EXPECT_EQ(closest.position[1], rows[0].position[1]);
    ASSERT_EQ(api()->find_closest_fire(m_world, far, 10.0, &closest), RUBBLE_OK);
    EXPECT_EQ(closest.shape, 0u);
    expectRefused(api()->count_fires(m_world, behind, before, &there), RUBBLE_ERROR_ARGUMENT, "low[0]");
    EXPECT_EQ(rows[0].shape, shapes()[0].shape);
    EXPECT_GT(rows[0].intensity, 0.0);
    EXPECT_GT(rows[0].position[1], 0.0);
    EXPECT_LT(rows[0].position[1], 1.0);
    const double low[3] = {-5, -5, -5}, high[3] = {5, 5, 5};
    ASSERT_EQ(api()->remove_fires(m_world, low, high), RUBBLE_OK);
    step();
    EXPECT_EQ(fires(), 0u);
    auto water = sized<rubble_extinguish>();
    std::copy_n(heat.position, 3, water.position);
    water.radius = 3.0, water.wet_seconds = 20.0;
    ASSERT_EQ(api()->heat(m_world, &heat), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->extinguish(m_world, &water), RUBBLE_OK);
    step();
    EXPECT_EQ(fires(), 0u);
    expectRefused(api()->remove_fires(m_world, high, low), RUBBLE_ERROR_ARGUMENT, "low[0] is 5");
    rubble_heat wrong = lighter();
    wrong.joules = -1.0;
    expectRefused(api()->heat(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "joules is -1");
    wrong = lighter(), wrong.flags = 2;
    expectRefused(api()->heat(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "flags has unknown bits");
    wrong = lighter(), wrong.reserved = 1;
    expectRefused(api()->heat(m_world, &wrong), RUBBLE_ERROR_ARGUMENT, "reserved is 1");
}

TEST_F(AbiShapes, TheirEditsAreRecordedAndUndone) {
    loadWood();
    const TempFolder folder;
    const std::string log = folder / "game.rubblelog";
    ASSERT_EQ(api()->set_undo_limit(m_world, 2), RUBBLE_OK);
    step();
    const std::vector<uint8_t> before = voxels(shapes()[0]);
    ASSERT_EQ(api()->start_recording(m_world, log.c_str()), RUBBLE_OK);
    ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
    auto resize = sized<rubble_resize>();
    resize.shape = shapes()[0].shape;
    resize.size[0] = 12, resize.size[1] = 10, resize.size[2] = 17;
    const rubble_heat heat = lighter();
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK);
    step();
    ASSERT_EQ(api()->trim_shape(m_world, resize.shape), RUBBLE_OK);
    ASSERT_EQ(api()->heat(m_world, &heat), RUBBLE_OK);
    for (int i = 0; i < 5; ++i) step();
    EXPECT_GT(fires(), 0u);
    const uint64_t end = hash();
    ASSERT_EQ(api()->stop_recording(m_world), RUBBLE_OK);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    step();
    EXPECT_EQ(voxels(shapes()[0]), before);
    EXPECT_EQ(fires(), 0u);
    uint64_t steps = 0;
    ASSERT_EQ(api()->play_recording(m_world, log.c_str(), &steps), RUBBLE_OK) << api()->get_last_error();
    EXPECT_EQ(steps, 6u);
    EXPECT_EQ(hash(), end);
}

}  // namespace
}  // namespace rubble
