// A host in C++ that knows rubble.hpp alone.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <rubble/rubble.hpp>
#include <string>

namespace {

/// A .vox file of one model: a slab of size^2 x 1 voxels with the palette index 1.
std::string voxFile(int size) {
    const auto number = [](int value) {
        char bytes[4];
        std::memcpy(bytes, &value, 4);
        return std::string(bytes, 4);
    };
    const auto chunk = [&](const char* id, const std::string& content, const std::string& children) {
        return id + number(int(content.size())) + number(int(children.size())) + content + children;
    };
    std::string voxels = number(size * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) voxels += {char(x), char(y), char(0), char(1)};
    const std::string model = chunk("SIZE", number(size) + number(size) + number(1), "") + chunk("XYZI", voxels, "");
    return "VOX " + number(150) + chunk("MAIN", "", model);
}

class Wrapper : public testing::Test {
protected:
    void SetUp() override { std::ofstream(m_path, std::ios::binary) << voxFile(16); }
    void TearDown() override { std::filesystem::remove(m_path); }

    static rubble::World makeWorld() {
        rubble_world_settings settings{};
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        return rubble::World(settings);
    }
    const std::string m_path =
        std::filesystem::temp_directory_path() / ("wrapper_" + std::to_string(getpid()) + ".vox");
};

TEST_F(Wrapper, AHostBreaksAndReads) {
    rubble::World world = makeWorld();
    world.load_level(m_path.c_str());
    world.step();
    const auto shapes = world.get_shape_states(0);
    ASSERT_EQ(shapes.size(), 1u);
    EXPECT_EQ(shapes[0].voxel_count, 256u);
    EXPECT_EQ(world.get_body_states().size(), 1u);

    rubble_voxel_box box{};
    box.shape = shapes[0].shape;
    for (int axis = 0; axis < 3; ++axis) box.size[axis] = shapes[0].size[axis];
    const std::vector<uint8_t> before = world.read_voxels(box);
    EXPECT_EQ(before.size(), size_t(box.size[0]) * size_t(box.size[1]) * size_t(box.size[2]));

    rubble_explosion explosion{};
    for (int axis = 0; axis < 3; ++axis)
        explosion.position[axis] = shapes[0].position[axis] + 0.5 * shapes[0].voxel_size * shapes[0].size[axis];
    world.explode(explosion);
    world.step();
    const rubble_voxel_accounting count = world.get_voxel_accounting();
    EXPECT_EQ(count.imported, 256u);
    EXPECT_GT(count.removed, 0u);
    EXPECT_EQ(count.imported, count.standing + count.in_pieces + count.removed);
    EXPECT_GT(world.get_events().removed_count, 0u);
}

TEST_F(Wrapper, ListsWhoseLengthStandsElsewhereAreWhole) {
    rubble::World world = makeWorld();
    world.load_level(m_path.c_str());
    world.step();
    rubble_palette_range range{};
    range.shape = world.get_shape_states(0).at(0).shape;
    range.count = 255;
    std::vector<rubble_palette_entry> entries = world.get_palette(range);
    ASSERT_EQ(entries.size(), 255u);
    entries[1].color[0] = 7;
    world.set_palette(range, entries.data());
    world.step();
    EXPECT_EQ(world.get_palette(range)[1].color[0], 7);
    range.count = 4000000000;
    EXPECT_THROW((void)world.get_palette(range), rubble::Error);

    const rubble_brick bricks[2]{};
    EXPECT_EQ(world.read_bricks(range.shape, bricks, 2).size(), 2u * RUBBLE_BRICK_BYTES);
}

TEST_F(Wrapper, RowsThatGoInGetTheirSize) {
    rubble::World world = makeWorld();
    world.load_level(m_path.c_str());
    world.step();
    std::vector<rubble_material> materials{world.get_material(1), world.get_material(2)};
    for (rubble_material& each : materials) each.struct_size = 0, each.density = 123.0;
    world.set_materials(1, materials);
    world.step();
    EXPECT_EQ(world.get_material(2).density, 123.0);
    EXPECT_TRUE(rubble::get_layers() & RUBBLE_LAYER_PHYSICS);
}

TEST_F(Wrapper, RaysFindTheSlab) {
    rubble::World world = makeWorld();
    world.load_level(m_path.c_str());
    world.step();
    const rubble_shape_state slab = world.get_shape_states(0).at(0);
    rubble_ray rays[2] = {};
    for (rubble_ray& ray : rays) {
        for (int axis = 0; axis < 3; ++axis)
            ray.origin[axis] = slab.position[axis] + 0.5 * slab.voxel_size * slab.size[axis];
        ray.origin[1] += 5.0;
        ray.direction[1] = -1.0;
        ray.max_distance = 100.0;
    }
    rays[1].origin[0] += 50.0;
    const auto hits = world.cast_rays(rays, 2);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].hit, 1u);
    EXPECT_EQ(hits[0].shape, slab.shape);
    EXPECT_EQ(hits[1].hit, 0u);
    const rubble_hit one = world.cast_ray(rays[0].origin, rays[0].direction, 100.0);
    EXPECT_EQ(one.distance, hits[0].distance);
}

TEST_F(Wrapper, FailedCallsThrowWhatWasWrong) {
    rubble::World world = makeWorld();
    try {
        world.load_level("no such file.vox");
        FAIL() << "nothing was thrown";
    } catch (const rubble::Error& error) {
        EXPECT_EQ(error.result(), RUBBLE_ERROR_FILE);
        EXPECT_NE(std::string(error.what()).find("no such file.vox"), std::string::npos) << error.what();
    }
    EXPECT_THROW(world.destroy_body(12345), rubble::Error);
    EXPECT_THROW(rubble::Renderer renderer(world), rubble::Error);
}

TEST_F(Wrapper, AWorldLivesOnceHoweverOftenItMoves) {
    rubble::World first = makeWorld();
    const rubble_world handle = first.handle();
    rubble::World second = std::move(first);
    EXPECT_EQ(first.handle(), 0u);
    EXPECT_EQ(second.handle(), handle);
    second = makeWorld();
    EXPECT_NE(second.handle(), handle);
    EXPECT_EQ(rubble::api().step(handle), RUBBLE_ERROR_STALE);
    second.step();
}

}  // namespace
