// The parts of the GPU scene that need no image.
#include <map>
#include <set>

#include "render/gl/state_guard.h"
#include "render/scene/brick_atlas.h"
#include "runtime/core/blue_noise.h"
#include "runtime/core/index_allocator.h"
#include "runtime/core/random.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

TEST(RangeAllocator, NeverOverlapAndMergeWhenFreed) {
    RangeAllocator ranges;
    Random random(4);
    std::map<uint32_t, uint32_t> held;
    for (int i = 0; i < 5000; ++i) {
        if (held.empty() || random.below(2)) {
            const uint32_t count = 1 + random.below(20);
            const uint32_t start = ranges.allocate(count);
            const auto after = held.lower_bound(start);
            ASSERT_TRUE(after == held.end() || start + count <= after->first);
            ASSERT_TRUE(after == held.begin() || std::prev(after)->first + std::prev(after)->second <= start);
            held[start] = count;
        } else {
            const auto one = std::next(held.begin(), int(random.below(uint32_t(held.size()))));
            ranges.free(one->first, one->second);
            held.erase(one);
        }
    }
    for (const auto& [start, count] : held) ranges.free(start, count);
    EXPECT_EQ(ranges.allocate(ranges.end()), 0u) << "all gaps have become one";
}

TEST(BlueNoise, IsUniformAndWithoutClumps) {
    const std::vector<uint8_t> tile = makeBlueNoise();
    std::vector<int> counts(256);
    for (uint8_t value : tile) ++counts[value];
    for (int count : counts) EXPECT_EQ(count, kBlueNoiseSize * kBlueNoiseSize / 256);
    // Neighbours of blue noise differ more than those of white noise, whose mean difference is a third of the range.
    double difference = 0.0;
    for (int y = 0; y < kBlueNoiseSize; ++y)
        for (int x = 0; x < kBlueNoiseSize; ++x) {
            const int here = y * kBlueNoiseSize + x, right = y * kBlueNoiseSize + (x + 1) % kBlueNoiseSize;
            difference += std::abs(int(tile[size_t(here)]) - int(tile[size_t(right)]));
        }
    EXPECT_GT(difference / double(tile.size()), 256.0 / 3 * 1.15);
}

class BrickAtlasTest : public GlTest {};

TEST_F(BrickAtlasTest, SharedBricksAreSentOnceAndFreedWithTheirLastUser) {
    BrickAtlas atlas;
    BrickIndices indices{};
    indices[0] = 1;
    const BrickRef one = makeBrick(indices);
    const uint32_t slot = atlas.acquire(one);
    EXPECT_EQ(atlas.acquire(one), slot);
    EXPECT_EQ(atlas.upload(), 576u);
    EXPECT_EQ(atlas.upload(), 0u);
    atlas.release(one.get());
    EXPECT_EQ(atlas.bricks(), 1);
    atlas.release(one.get());
    EXPECT_EQ(atlas.bricks(), 0);
    EXPECT_EQ(one.use_count(), 1) << "the atlas released it";
}

class StateGuardTest : public GlTest {};

TEST_F(StateGuardTest, RestoresTheHostsState) {
    GLuint texture, buffer;
    glGenTextures(1, &texture);
    glGenBuffers(1, &buffer);
    glActiveTexture(GL_TEXTURE20);
    glBindTexture(GL_TEXTURE_2D, texture);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    glViewport(1, 2, 3, 4);
    {
        const GlStateGuard guard(HostState::Restored);
        // Not glIsEnabled(): NVIDIA answers that by the last call without an index.
        EXPECT_FALSE(glIsEnabledi(GL_BLEND, 0)) << "passes start from a known state";
        glActiveTexture(GL_TEXTURE20);
        glBindTexture(GL_TEXTURE_2D, 0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        glDepthFunc(GL_LEQUAL);
        glViewport(0, 0, 16, 16);
        glActiveTexture(GL_TEXTURE0);
    }
    GLint value[4];
    const auto get = [&](GLenum name) {
        glGetIntegerv(name, value);
        return value[0];
    };
    EXPECT_EQ(get(GL_ACTIVE_TEXTURE), GL_TEXTURE20);
    EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), GLint(texture));
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), GLint(buffer));
    EXPECT_TRUE(glIsEnabled(GL_BLEND));
    EXPECT_EQ(get(GL_BLEND_DST_RGB), GL_ONE);
    EXPECT_EQ(get(GL_DEPTH_WRITEMASK), GL_FALSE);
    EXPECT_EQ(get(GL_DEPTH_FUNC), GL_GREATER);
    EXPECT_EQ(get(GL_VIEWPORT), 1);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDeleteTextures(1, &texture);
    glDeleteBuffers(1, &buffer);
}

TEST_F(StateGuardTest, RestoresImageBindings) {
    if (!hasCompute()) GTEST_SKIP() << "no GL 4.3";
    const Texture first(GL_RGBA32F, {4, 4}), second(GL_R32F, {4, 4}), ours(GL_RGBA16F, {4, 4});
    glBindImageTexture(0, first.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, second.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    {
        const GlStateGuard guard(HostState::Restored, {.images = true});
        for (const GLuint unit : {0u, 1u})
            glBindImageTexture(unit, ours.name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA16F);
    }
    const auto get = [](GLenum name, GLuint unit) {
        GLint value = -1;
        glGetIntegeri_v(name, unit, &value);
        return value;
    };
    EXPECT_EQ(get(GL_IMAGE_BINDING_NAME, 0), GLint(first.name()));
    EXPECT_EQ(get(GL_IMAGE_BINDING_ACCESS, 0), GL_READ_WRITE);
    EXPECT_EQ(get(GL_IMAGE_BINDING_FORMAT, 0), GL_RGBA32F);
    EXPECT_EQ(get(GL_IMAGE_BINDING_NAME, 1), GLint(second.name()));
    EXPECT_EQ(get(GL_IMAGE_BINDING_FORMAT, 1), GL_R32F);
    for (const GLuint unit : {0u, 1u}) glBindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
}

}  // namespace
}  // namespace rubble
