#include <bit>

#include "render/gl/framebuffer.h"
#include "render/gl/placeholders.h"
#include "tests/render/gl_calls.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

class BuffersTest : public GlTest {};

std::vector<uint32_t> g_events;  ///< 1: a new store, 2: data written
void noteStore(GLenum, GLsizeiptr, const void*, GLenum) {
    g_events.push_back(1);
}
void noteData(GLenum, GLintptr, GLsizeiptr, const void*) {
    g_events.push_back(2);
}

/// llvmpipe builds programs again for buffers of another kind.
TEST_F(BuffersTest, BuffersOfAllSizesAreOfOneKind) {
    for (uint64_t bytes = 16; bytes < (1u << 22); bytes += bytes / 3 / 16 * 16 + 16) {
        BufferTexture texture(GL_RGBA32F);
        ASSERT_TRUE(texture.reserve(bytes));
        EXPECT_GE(texture.bytes(), bytes);
        EXPECT_FALSE(std::has_single_bit(texture.bytes())) << bytes;
        EXPECT_NE(texture.bytes() % 65536, 0u) << bytes;
    }
}

/// Where a scene lacks a texture its sampler reads one of the same kind.
TEST_F(BuffersTest, AnEmptyTextureIsStoodForByOneOfItsKind) {
    TexelStore store(GlLimits::ofContext());
    const TexelStore::Use use(store);
    const Texture& color = store.placeholders().orOfItsKind(Texture::none(GL_RG8, {640, 64}, Filter::Linear));
    EXPECT_TRUE(color);
    EXPECT_EQ(color.internalFormat(), GLenum(GL_RG8));
    EXPECT_EQ(color.filter(), Filter::Linear);
    EXPECT_FALSE(std::has_single_bit(unsigned(color.size().x)));
    EXPECT_TRUE(std::has_single_bit(unsigned(color.size().y)));
    const GLuint name = color.name();
    EXPECT_EQ(store.placeholders().orOfItsKind(Texture::none(GL_RG8, {320, 16}, Filter::Linear)).name(), name);
    EXPECT_NE(store.placeholders().orOfItsKind(Texture::none(GL_RG8, {320, 16})).name(), name);
    EXPECT_NE(store.placeholders().orOfItsKind(BufferTexture(GL_R32UI)).name(), 0u);
    const Texture real(GL_RG8, {5, 5}, Filter::Linear);
    EXPECT_EQ(store.placeholders().orOfItsKind(real).name(), real.name());
}

/// Data over what a draw still reads would make the driver wait for that draw.
TEST_F(BuffersTest, ARefilledBufferHasANewStore) {
    const std::vector<uint32_t> data(100, 5u);
    BufferTexture texture(GL_R32UI);
    ASSERT_TRUE(texture.refill(std::as_bytes(std::span(data))));
    g_events.clear();
    const GlReplaced store(glad_glBufferData, decltype(glad_glBufferData)(noteStore));
    const GlReplaced write(glad_glBufferSubData, decltype(glad_glBufferSubData)(noteData));
    for (int i = 0; i < 2; ++i) texture.refill(std::as_bytes(std::span(data)));
    EXPECT_EQ(g_events, (std::vector<uint32_t>{1, 2, 1, 2}));
}

TEST_F(BuffersTest, ARefilledBufferHoldsWhatItWasGiven) {
    BufferTexture texture(GL_R32UI);
    for (const uint32_t count : {10u, 2000u, 30u}) {
        std::vector<uint32_t> data(count);
        for (uint32_t i = 0; i < count; ++i) data[i] = i * count;
        ASSERT_TRUE(texture.refill(std::as_bytes(std::span(data))));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_BUFFER, texture.name());
        GLint own = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, 0x8C2D /* GL_TEXTURE_BUFFER_DATA_STORE_BINDING */, &own);
        std::vector<uint32_t> read(count);
        glBindBuffer(GL_ARRAY_BUFFER, GLuint(own));
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(count * 4), read.data());
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        EXPECT_EQ(read, data);
    }
}

/// Before GL 4.1 a framebuffer is incomplete whose read buffer has no attachment.
TEST_F(BuffersTest, AFramebufferOfDepthAloneReadsNoColour) {
    const Texture depth(GL_DEPTH_COMPONENT32F, {8, 8});
    const Framebuffer framebuffer({}, &depth);
    EXPECT_TRUE(framebuffer.isComplete());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    GLint buffer = 1;
    glGetIntegerv(GL_READ_BUFFER, &buffer);
    EXPECT_EQ(buffer, GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace
}  // namespace rubble
