#include "render/gl/shared_texels.h"

#include <map>

#include "render/scene/staged_buffer.h"
#include "runtime/core/random.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

class SharedTexelsTest : public GlTest {
protected:
    static constexpr int kSideBits = 4;
    /// Layers of 16 x 16 texels.
    static GlLimits limits(int layers) {
        GlLimits limits;
        limits.textureSide = 1 << kSideBits;
        limits.arrayLayers = layers;
        return limits;
    }
    /// All texels of one number, as they lie.
    static std::vector<uint32_t> read(const SharedTexels& texels) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texels.name());
        GLint size[3] = {};
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &size[0]);
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_HEIGHT, &size[1]);
        glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH, &size[2]);
        std::vector<uint32_t> all(size_t(size[0]) * size_t(size[1]) * size_t(size[2]));
        glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, all.data());
        return all;
    }
};

TEST_F(SharedTexelsTest, ArraysKeepWhatTheyHoldWhileTheyGrowAndOthersComeAndGo) {
    TexelStore store(limits(64));
    const TexelStore::Use use(store);
    ASSERT_TRUE(store.isShared());
    struct Array {
        BufferTexture texture{GL_R32UI};
        std::vector<uint32_t> held;
    };
    std::map<uint32_t, Array> arrays;
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        Array& array = arrays[random.below(6)];
        if (array.held.size() > 600) array = {};
        const size_t before = array.held.size(), count = 1 + random.below(90);
        const size_t first = before ? random.below(uint32_t(before)) : 0;
        array.held.resize(std::max(before, first + count));
        for (size_t k = first; k < first + count; ++k) array.held[k] = random.below(~0u);
        ASSERT_TRUE(array.texture.reserve(array.held.size() * 4));
        array.texture.upload(first * 4, std::as_bytes(std::span(array.held).subspan(first, count)));
        const std::vector<uint32_t> all = read(*store.of(GL_R32UI));
        for (const auto& [number, each] : arrays)
            for (size_t k = 0; k < each.held.size(); ++k)
                ASSERT_EQ(all[size_t(each.texture.firstTexel()) + k], each.held[k])
                    << "array " << number << ", texel " << k << ", round " << i;
    }
    EXPECT_GT(read(*store.of(GL_R32UI)).size(), 256u) << "there is one layer: nothing was tried";
}

TEST_F(SharedTexelsTest, AFullTextureLeavesArraysAsTheyWere) {
    TexelStore store(limits(2));
    const TexelStore::Use use(store);
    BufferTexture texture{GL_R32UI};
    const std::vector<uint32_t> held(100, 7u);
    ASSERT_TRUE(texture.refill(std::as_bytes(std::span(held))));
    EXPECT_FALSE(texture.reserve(4 * 600)) << "two layers hold 512 texels";
    EXPECT_TRUE(texture.reserve(4 * 200));
    EXPECT_EQ(read(*store.of(GL_R32UI))[size_t(texture.firstTexel()) + 99], 7u);
}

/// An array that the GL has no room for was once cut off in main memory too, and then written beyond its end.
TEST_F(SharedTexelsTest, AStagedArrayBeyondTheRoomKeepsItsElements) {
    TexelStore store(limits(2));
    const TexelStore::Use use(store);
    StagedBuffer<uint32_t> buffer(GL_R32UI, "numbers");
    buffer.resize(100);
    buffer.change(99) = 1;
    EXPECT_GT(buffer.upload(), 0u);
    buffer.resize(5000);
    buffer.change(4999) = 2;
    buffer.change(3) = 3;
    buffer.upload();
    buffer.change(4999) += 1;
    buffer.upload();
    EXPECT_EQ(buffer.size(), 5000u);
    EXPECT_EQ(buffer[4999], 3u);
    EXPECT_LE(buffer.held(), 512u);
    EXPECT_GE(buffer.held(), 100u);
}

TEST_F(SharedTexelsTest, AStagedArrayThatShrinksSendsOnlyWhatIsLeft) {
    StagedBuffer<uint32_t> buffer(GL_R32UI, "numbers");
    buffer.resize(5000);
    buffer.change(4999) = 1;
    buffer.resize(10);
    EXPECT_EQ(buffer.upload(), 0u);
    buffer.change(3) = 3;
    buffer.resize(5000);
    buffer.change(4999) = 2;
    EXPECT_EQ(buffer.upload(), 64 * sizeof(uint32_t) + 8 * sizeof(uint32_t)) << "a page, and the last one's 8 elements";
}

}  // namespace
}  // namespace rubble
