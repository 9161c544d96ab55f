#pragma once
#include <array>
#include <exception>
#include <optional>

#include "render/gl/compatibility_state.h"
#include "render/gl/draw_state.h"
#include "render/gl/host_state.h"
#include "render/gl/transform_feedback.h"

namespace rubble {

/// What of the GL the renderer uses; the rest needs no restoring.
struct GlUse {
    bool images = false;        ///< compute programs may run
    bool sharedTexels = false;  ///< TexelStore::isShared()
    int units = kTextureUnits;  ///< texture units
};

/// What a unit that compute programs store into is bound to. Clang 14 makes no default of it inside GlState.
struct ImageBinding {
    GLint name = 0, level = 0, layered = 0, layer = 0, access = GL_READ_ONLY, format = GL_R8;
};

/// The part of the GL's state that the renderer changes. Not what is on while a host draws: conditional rendering and
/// queries must have ended.
struct GlState {
    static constexpr GLuint kTargets = 6;  ///< targets that passes draw into at once
    static constexpr GLuint kImages = 2;   ///< units that compute programs store into
    static constexpr std::array kSwitches = {
        GLenum(GL_CULL_FACE),       GLenum(GL_DEPTH_TEST),         GLenum(GL_STENCIL_TEST),
        GLenum(GL_COLOR_LOGIC_OP),  GLenum(GL_RASTERIZER_DISCARD), GLenum(GL_POLYGON_OFFSET_FILL),
        GLenum(GL_POLYGON_SMOOTH),  GLenum(GL_DEPTH_CLAMP),        GLenum(GL_SAMPLE_ALPHA_TO_COVERAGE),
        GLenum(GL_SAMPLE_COVERAGE), GLenum(GL_SAMPLE_MASK),        GLenum(GL_FRAMEBUFFER_SRGB),
        GLenum(GL_CLIP_DISTANCE0),  GLenum(GL_CLIP_DISTANCE1),     GLenum(GL_CLIP_DISTANCE2),
        GLenum(GL_CLIP_DISTANCE3),  GLenum(GL_CLIP_DISTANCE4),     GLenum(GL_CLIP_DISTANCE5),
        GLenum(GL_CLIP_DISTANCE6),  GLenum(GL_CLIP_DISTANCE7)};  ///< off in a new context, and while we draw
    static constexpr std::array kUnpack = {GLenum(GL_UNPACK_SWAP_BYTES),   GLenum(GL_UNPACK_ROW_LENGTH),
                                           GLenum(GL_UNPACK_IMAGE_HEIGHT), GLenum(GL_UNPACK_SKIP_ROWS),
                                           GLenum(GL_UNPACK_SKIP_PIXELS),  GLenum(GL_UNPACK_SKIP_IMAGES),
                                           GLenum(GL_UNPACK_ALIGNMENT)};
    static constexpr GLint kUntouched = -1;  ///< a binding that the renderer does not change
    struct Unit {
        GLint texture2D = 0, array = 0, buffer = 0, sampler = 0;
    };

    // The values of a new context.
    GLint drawFramebuffer = 0, readFramebuffer = 0, program = 0, vertexArray = 0, arrayBuffer = 0;
    GLint copyReadBuffer = 0, copyWriteBuffer = 0, unpackBuffer = 0;
    GLint uniformBuffer = 0, uniformBuffer0 = 0;
    GLint64 uniformStart0 = 0, uniformSize0 = 0;  ///< of a range; a size of 0: the whole buffer
    GLint activeTexture = GL_TEXTURE0;
    GLint polygonMode[2] = {GL_FILL, GL_FILL}, clipOrigin = GL_LOWER_LEFT, clipDepth = GL_NEGATIVE_ONE_TO_ONE;
    GLint provokingVertex = GL_LAST_VERTEX_CONVENTION;
    GLint cullFace = GL_BACK, frontFace = GL_CCW, depthFunc = GL_LESS;
    GLdouble depthRange[2] = {0.0, 1.0};
    GLboolean depthMask = GL_TRUE, scissorTest = GL_FALSE;
    std::optional<std::array<GLfloat, 4>> viewport;  ///< none: it is left as it is
    std::optional<std::array<GLint, 4>> scissor;     ///< the same
    Blend blend;                                     ///< of the first target
    std::array<GLboolean, kTargets> blends{};        ///< by target
    std::array<std::array<GLboolean, 4>, kTargets> colorMasks;
    std::array<GLboolean, kSwitches.size()> switches{};
    std::array<GLint, kUnpack.size()> unpack{0, 0, 0, 0, 0, 0, 4};
    std::array<Unit, kTextureUnits> units;
    int unitCount = kTextureUnits;  ///< of `units`, from the first on; the others are left as they are
    std::optional<std::array<ImageBinding, kImages>> images;  ///< none: they are left as they are

    CompatibilityState compatibility;     ///< of a compatibility profile
    TransformFeedback transformFeedback;  ///< paused meanwhile

    /// That of a new context.
    GlState() { colorMasks.fill({GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE}); }
    /// As the GL has it.
    static GlState current(const GlUse& use = {});
    /// Makes it the GL's.
    void set() const;
};

/// Empties the GL's queue of errors.
void dropErrors();

/// Sets what the renderer draws with, and sees to the host's state at the end of its scope: also to its queue of
/// errors, if that ends with an exception.
class GlStateGuard {
public:
    /// Of the context that is current. use: in its scope.
    explicit GlStateGuard(HostState host, const GlUse& use = {});
    ~GlStateGuard();
    GlStateGuard(const GlStateGuard&) = delete;
    GlStateGuard& operator=(const GlStateGuard&) = delete;

private:
    GlState m_after;  ///< what the host gets
    const int m_exceptions = std::uncaught_exceptions();
};

/// Sets how pixels are read into main memory, tightly packed, and restores the host's settings at the end of its scope.
class PixelPackGuard {
public:
    /// Of the context that is current.
    PixelPackGuard();
    ~PixelPackGuard();
    PixelPackGuard(const PixelPackGuard&) = delete;
    PixelPackGuard& operator=(const PixelPackGuard&) = delete;

private:
    static constexpr std::array kPack = {GLenum(GL_PACK_SWAP_BYTES), GLenum(GL_PACK_ROW_LENGTH),
                                         GLenum(GL_PACK_SKIP_ROWS), GLenum(GL_PACK_SKIP_PIXELS),
                                         GLenum(GL_PACK_ALIGNMENT)};
    std::array<GLint, kPack.size()> m_pack{};
    GLint m_buffer = 0;
};

}  // namespace rubble
