#include "render/scene/water_area.h"

#include <array>
#include <limits>

#include "render/frame/frame_block.h"
#include "render/frame/shader_constants.h"

namespace rubble {
namespace {

constexpr float kNearest = 0.01f;  ///< linear depth, metres: what is nearer covers all that it could

/// The smallest rectangle around edges of a solid, in clip space / w.
class Bounds {
public:
    explicit Bounds(const glm::mat4& viewProjection) : m_viewProjection(viewProjection) {}

    /// Adds what lies before the camera of an edge.
    void addEdge(glm::vec3 from, glm::vec3 to) {
        const glm::vec4 a = m_viewProjection * glm::vec4(from, 1.0f), b = m_viewProjection * glm::vec4(to, 1.0f);
        if (a.w >= kNearest) addPoint(a);
        if (b.w >= kNearest) addPoint(b);
        if ((a.w < kNearest) != (b.w < kNearest)) addPoint(glm::mix(a, b, (kNearest - a.w) / (b.w - a.w)));
    }
    PixelRect pixels(glm::ivec2 size) const {
        const glm::vec2 full(size);
        const auto pixel = [&](glm::vec2 place) { return glm::clamp((place * 0.5f + 0.5f) * full, -1.0f, 1e6f); };
        constexpr int kJitter = 1;  // the prism is drawn up to half a pixel beside its place
        return {glm::max(glm::ivec2(glm::floor(pixel(m_low))) - kJitter, glm::ivec2(0)),
                glm::min(glm::ivec2(glm::ceil(pixel(m_high))) + kJitter, size)};
    }

private:
    void addPoint(glm::vec4 clip) {
        const glm::vec2 place = glm::vec2(clip) / clip.w;
        m_low = glm::min(m_low, place);
        m_high = glm::max(m_high, place);
    }
    const glm::mat4& m_viewProjection;
    glm::vec2 m_low{std::numeric_limits<float>::max()}, m_high{-std::numeric_limits<float>::max()};
};

}  // namespace

PixelRect waterArea(const Water& water, const FrameBlock& block, glm::dvec3 origin) {
    const double over = 2.0 * std::abs(double(water.waves.height)) + double(shared::kWaterPort);
    const double top = water.surface + over - origin.y, bottom = water.surface - water.depth - origin.y;
    Bounds bounds(block.viewProjectionPlain);
    for (size_t i = 0; i < water.outline.size(); ++i) {
        const GroundPoint a = water.outline[i], b = water.outline[(i + 1) % water.outline.size()];
        const auto at = [&](GroundPoint p, double height) { return glm::vec3(p.x - origin.x, height, p.z - origin.z); };
        bounds.addEdge(at(a, bottom), at(a, top));
        bounds.addEdge(at(a, bottom), at(b, bottom));
        bounds.addEdge(at(a, top), at(b, top));
    }
    return bounds.pixels(glm::ivec2(block.targetSize));
}

}  // namespace rubble
