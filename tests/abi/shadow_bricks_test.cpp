#include <cmath>
#include <cstring>
#include <map>
#include <tuple>
#include <vector>

#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

using ShadowBricks = std::map<std::tuple<int32_t, int32_t, int32_t>, rubble_shadow_brick>;

/// A world whose shadow volume is the host's to copy.
class AbiShadow : public AbiCreate {
protected:
    void SetUp() override {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_SHADOW_DATA;
        ASSERT_EQ(api()->create_world(&settings, &m_world), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
        step();
    }
    rubble_result list(uint64_t since, std::vector<rubble_shadow_brick>& out, uint64_t& version) {
        uint32_t count = 0;
        const rubble_result result = api()->get_shadow_bricks(m_world, since, &version, nullptr, 0, &count);
        if (result != RUBBLE_OK) return result;
        out.resize(count);
        return api()->get_shadow_bricks(m_world, since, &version, out.data(), count, &count);
    }
    /// Brings a host's copy up to date; returns how many bricks came.
    size_t update(uint64_t& version, ShadowBricks& bricks) {
        std::vector<rubble_shadow_brick> rows;
        if (list(version, rows, version) == RUBBLE_ERROR_STALE) {
            bricks.clear();
            EXPECT_EQ(list(0, rows, version), RUBBLE_OK) << api()->get_last_error();
        }
        for (const rubble_shadow_brick& row : rows)
            if (row.is_empty)
                bricks.erase({row.x, row.y, row.z});
            else
                bricks[{row.x, row.y, row.z}] = row;
        return rows.size();
    }
    static bool same(const ShadowBricks& a, const ShadowBricks& b) {
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
                   return x.first == y.first && std::memcmp(&x.second, &y.second, sizeof x.second) == 0;
               });
    }
    /// Whether the copy has a cell at a place, metres.
    static bool isSolid(const ShadowBricks& bricks, double x, double y, double z) {
        const auto cell = [](double at) { return int32_t(std::floor(at / 0.1)); };
        const int32_t c[3] = {cell(x), cell(y), cell(z)};
        const auto found = bricks.find({c[0] >> 4, c[1] >> 4, c[2] >> 4});
        if (found == bricks.end()) return false;
        const int word = (c[0] >> 2 & 3) + 4 * (c[1] >> 2 & 3) + 16 * (c[2] >> 2 & 3);
        if (!(found->second.occupied >> word & 1)) return false;
        return found->second.texels[word] >> ((c[0] & 3) + 4 * (c[1] & 3) + 16 * (c[2] & 3)) & 1;
    }
};

TEST_F(AbiShadow, ACopyThatFollowsChangesEqualsTheWholeVolume) {
    uint64_t version = 0;
    ShadowBricks copy;
    const size_t all = update(version, copy);
    EXPECT_GT(all, 0u);
    EXPECT_TRUE(isSolid(copy, 0.85, 0.95, 0.85)) << "the table's top";
    EXPECT_FALSE(isSolid(copy, 0.85, 1.15, 0.85));
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
    for (int i = 0; i < 30; ++i) {
        step();
        update(version, copy);
        uint64_t from = 0;
        ShadowBricks whole;
        update(from, whole);
        ASSERT_TRUE(same(copy, whole)) << i;
    }
    EXPECT_FALSE(isSolid(copy, 0.85, 0.95, 0.85));
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    step();
    std::vector<rubble_shadow_brick> rows;
    expectRefused(list(version, rows, version), RUBBLE_ERROR_STALE, "ask with 0");
    update(version, copy);
    EXPECT_TRUE(isSolid(copy, 0.85, 0.95, 0.85)) << "the table of the level";
    step();
    EXPECT_EQ(update(version, copy), 0u) << "nothing moves";
}

TEST_F(AbiShadow, ReadBricksGivesWhatReadVoxelsGives) {
    auto paint = sized<rubble_paint>();
    paint.color[0] = 255, paint.position[0] = paint.position[2] = 0.85, paint.position[1] = 1.0;
    ASSERT_EQ(api()->paint(m_world, &paint), RUBBLE_OK);
    step();
    for (const rubble_shape_state& shape : shapes()) {
        const rubble_brick bricks[2] = {{0, 0, 0, 0}, {-7, 3, 2, 0}};
        std::vector<uint8_t> data(2 * RUBBLE_BRICK_BYTES, 9);
        uint64_t bytes = 0;
        ASSERT_EQ(api()->read_bricks(m_world, shape.shape, bricks, 2, data.data(), data.size(), &bytes), RUBBLE_OK)
            << api()->get_last_error();
        auto box = wholeOf(shape.shape, 8);
        const std::vector<uint8_t> indices = read(box);
        box.what = RUBBLE_VOXEL_PAINT;
        const std::vector<uint8_t> painted = read(box);
        EXPECT_TRUE(std::equal(indices.begin(), indices.end(), data.begin()));
        EXPECT_TRUE(std::equal(painted.begin(), painted.end(), data.begin() + 512));
        EXPECT_EQ(std::count(data.begin() + RUBBLE_BRICK_BYTES, data.end(), 0), ptrdiff_t(RUBBLE_BRICK_BYTES));
    }
    const rubble_brick brick = {};
    const rubble_shape shape = shapes()[0].shape;
    uint8_t byte = 7;
    uint64_t bytes = 0;
    ASSERT_EQ(api()->read_bricks(m_world, shape, &brick, 1, nullptr, 0, &bytes), RUBBLE_OK);
    EXPECT_EQ(bytes, RUBBLE_BRICK_BYTES);
    expectRefused(api()->read_bricks(m_world, shape, &brick, 1, &byte, 1, &bytes), RUBBLE_ERROR_CAPACITY, "1024 bytes");
    EXPECT_EQ(byte, 7);
    expectRefused(api()->read_bricks(m_world, shape, &brick, 1, nullptr, 1, &bytes), RUBBLE_ERROR_NULL, "out");
    expectRefused(api()->read_bricks(m_world, shape, nullptr, 1, &byte, 1, &bytes), RUBBLE_ERROR_NULL, "bricks");
    expectRefused(api()->read_bricks(m_world, shape, &brick, 1, &byte, 1, nullptr), RUBBLE_ERROR_NULL, "count");
    expectRefused(api()->read_bricks(m_world, 0, nullptr, 0, nullptr, 0, &bytes), RUBBLE_ERROR_STALE, "shape is 0");
}

TEST_F(AbiShadow, AWorldWithoutTheFlagKeepsNoCopy) {
    const rubble_world other = makeWorld();
    uint32_t count = 0;
    uint64_t version = 0;
    expectRefused(api()->get_shadow_bricks(other, 0, &version, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT,
                  "RUBBLE_WORLD_SHADOW_DATA");
    expectRefused(api()->get_shadow_bricks(m_world, 0, nullptr, nullptr, 0, &count), RUBBLE_ERROR_NULL, "version");
    EXPECT_EQ(api()->destroy_world(other), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
