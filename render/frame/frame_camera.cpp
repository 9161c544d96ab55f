#include "render/frame/frame_camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame/shader_constants.h"

namespace rubble {
namespace {

constexpr float kNear = 0.05f;
constexpr float kFar = shared::kSkyDepth;  ///< as lib/frame.glsl takes it
// Frames until jitter repeats, where display and render size are the same. With fewer traced pixels it takes as many
// more frames until every part of a displayed pixel has been sampled.
constexpr float kBaseJitterPeriod = 16.0f;

/// The first two dimensions of Sobol's sequence (Sobol 1967). Of any aligned power of two of its points, each row and
/// each column of a grid of as many cells holds exactly one.
glm::vec2 sobolPoint(uint32_t index) {
    uint32_t x = 0, y = 0;
    for (uint32_t inX = 1u << 31, inY = 1u << 31; index; index >>= 1, inX >>= 1, inY ^= inY >> 1)
        if (index & 1) x ^= inX, y ^= inY;
    return glm::vec2(x >> 8, y >> 8) / float(1 << 24);
}

/// What a view shows of the plane at depth 1, in the eye's space.
struct Window {
    glm::vec2 middle{0.0f}, half{1.0f};  ///< half: of its size
    bool isOrthographic = false;         ///< it shows the same of all planes
    float start = 0.0f;                  ///< depth at which rays begin
};

Window windowOf(const View& view) {
    if (view.projection) {
        const glm::dmat4& p = view.projection->clipFromEye;
        const glm::dvec2 half(1.0 / p[0][0], 1.0 / p[1][1]);
        if (!view.projection->isOrthographic()) return {glm::dvec2(p[2][0], p[2][1]) * half, half};
        return {-glm::dvec2(p[3][0], p[3][1]) * half, half, true, float(view.projection->startDepth())};
    }
    const float tangent = std::tan(view.verticalFov * 0.5f);
    return {glm::vec2(0.0f), glm::vec2(tangent * (float(view.size.x) / float(view.size.y)), tangent)};
}

/// From the space of a camera whose rays begin at depth 0; an orthographic one stands in the middle of its window.
/// Jitter shifts clip space by -2 jitter: what lies at pixel centre + jitter comes to the centre.
glm::mat4 projection(const Window& window, glm::vec2 jitterUv) {
    const glm::vec2 half = window.half;
    if (window.isOrthographic) {
        glm::mat4 p = glm::ortho(-half.x, half.x, -half.y, half.y, 0.0f, kFar);
        p[3][0] -= jitterUv.x * 2.0f;
        p[3][1] -= jitterUv.y * 2.0f;
        return p;
    }
    const glm::vec2 low = kNear * (window.middle - half), high = kNear * (window.middle + half);
    glm::mat4 p = glm::frustum(low.x, high.x, low.y, high.y, kNear, kFar);
    p[2][0] += jitterUv.x * 2.0f;
    p[2][1] += jitterUv.y * 2.0f;
    return p;
}

}  // namespace

void FrameCamera::begin(const View& view, glm::ivec2 renderSize, bool jittered, glm::dvec3 originWorld,
                        FrameBlock& block) {
    const Window window = windowOf(view);
    const bool cut = view.cut || m_frame == 0 || renderSize != m_lastSize || originWorld != m_lastOrigin ||
                     window.isOrthographic != m_wasOrthographic;
    if (view.cut) m_frame = 0;  // the same noise after each cut: a still does not depend on earlier frames
    const glm::vec2 size(renderSize), display(view.size);
    const int period = int(kBaseJitterPeriod * display.x * display.y / (size.x * size.y));
    const glm::vec2 jitter =
        jittered ? (sobolPoint(uint32_t(m_frame % period)) + 0.5f / float(period) - 0.5f) / size : glm::vec2(0.0f);

    const glm::mat3 axes = glm::mat3_cast(glm::quat(view.rotation));
    glm::vec3 position(view.position - originWorld);
    if (window.isOrthographic) position += axes * glm::vec3(window.middle, -window.start);
    const glm::mat4 toCamera = glm::translate(glm::mat4(glm::transpose(axes)), -position);
    const glm::mat4 plain = projection(window, glm::vec2(0.0f)) * toCamera;

    block.viewProjection = projection(window, jitter) * toCamera;
    block.viewProjectionPlain = plain;
    block.previousViewProjection = cut ? plain : m_lastViewProjection;
    block.cameraPosition = glm::vec4(position, kNear);
    block.previousCameraPosition = cut ? glm::vec4(position, 0.0f) : m_lastPosition;
    block.cameraRight = glm::vec4(axes[0], window.half.x);
    block.cameraUp = glm::vec4(axes[1], window.half.y);
    block.cameraForward = glm::vec4(-axes[2], kFar);
    block.viewMiddle =
        window.isOrthographic ? glm::vec4(-axes[2], 1.0f) : glm::vec4(axes * glm::vec3(window.middle, -1.0f), 0.0f);
    const glm::vec4 right(axes[0] * window.half.x, 0.0f), up(axes[1] * window.half.y, 0.0f);
    block.previousViewMiddle = cut ? block.viewMiddle : m_lastMiddle;
    block.previousCameraRight = cut ? right : m_lastRight;
    block.previousCameraUp = cut ? up : m_lastUp;
    block.targetSize = glm::vec4(size, 1.0f / size);
    block.displaySize = glm::vec4(display, 1.0f / display);
    block.jitter = glm::vec4(jitter, cut ? jitter : m_lastJitter);
    // Roberts' R1 and R2 sequences: extremelearning.com.au/unreasonable-effectiveness-of-quasirandom-sequences.
    const float n = float(m_frame % 4096);
    block.noiseOffset = glm::fract(n * glm::vec4(0.7548776662f, 0.5698402910f, 0.6180339887f, 0.8191725134f));
    block.counters = glm::ivec4(m_frame, cut ? 0 : 1, 0, 0);

    m_lastViewProjection = plain;
    m_lastPosition = glm::vec4(position, 0.0f);
    m_lastMiddle = block.viewMiddle;
    m_lastRight = right;
    m_lastUp = up;
    m_wasOrthographic = window.isOrthographic;
    m_lastJitter = jitter;
    m_lastSize = renderSize;
    m_lastOrigin = originWorld;
    ++m_frame;
}

}  // namespace rubble
