#include "render/scene/water_area.h"

#include <glm/matrix.hpp>

#include "render/frame/frame_block.h"
#include "render/frame/shader_constants.h"

namespace rubble {
namespace {

constexpr double kNearest = 0.01;  ///< linear depth, metres: what is nearer covers all that it could
constexpr double kJitter = 1.0;    ///< pixels: the prism is drawn up to half a pixel beside its place
constexpr double kTouch = 1e-3;    ///< pixels

/// What is seen of the edges of a solid.
class Outline {
public:
    Outline(const glm::mat4& viewProjection, glm::dvec2 size) : m_viewProjection(viewProjection), m_size(size) {}

    /// Adds what lies before the camera of an edge.
    void addEdge(glm::dvec3 from, glm::dvec3 to) {
        const glm::dvec4 a = m_viewProjection * glm::dvec4(from, 1.0), b = m_viewProjection * glm::dvec4(to, 1.0);
        if (a.w >= kNearest) addPoint(a);
        if ((a.w < kNearest) != (b.w < kNearest)) addPoint(glm::mix(a, b, (kNearest - a.w) / (b.w - a.w)));
    }
    WaterArea area() && {
        const ConvexPolygon hull = ConvexPolygon::around(std::move(m_points));
        WaterArea area{
            hull.clipped(glm::dvec2(0.0), m_size), hull.widened(kJitter).clipped(glm::dvec2(0.0), m_size), {}};
        for (const glm::dvec2 corner : area.covered.corners())
            area.bounds = area.bounds.merged({glm::ivec2(glm::floor(corner)), glm::ivec2(glm::floor(corner)) + 1});
        area.bounds.high = glm::min(area.bounds.high, glm::ivec2(m_size));
        return area;
    }

private:
    void addPoint(glm::dvec4 clip) { m_points.push_back((glm::dvec2(clip) / clip.w * 0.5 + 0.5) * m_size); }

    glm::dmat4 m_viewProjection;
    glm::dvec2 m_size;
    std::vector<glm::dvec2> m_points;
};

}  // namespace

bool WaterArea::overlaps(const WaterArea& other) const {
    return bounds.overlaps(other.bounds) && prism.overlaps(other.prism, kTouch);
}

WaterArea waterArea(const Water& water, const FrameBlock& block, glm::dvec3 origin) {
    const double over = 2.0 * std::abs(double(water.waves.height)) + double(shared::kWaterPort);
    const double top = water.surface + over - origin.y, bottom = water.surface - water.depth - origin.y;
    Outline outline(block.viewProjectionPlain, glm::dvec2(block.targetSize));
    for (size_t i = 0; i < water.outline.size(); ++i) {
        const GroundPoint a = water.outline[i], b = water.outline[(i + 1) % water.outline.size()];
        const auto at = [&](GroundPoint p, double height) {
            return glm::dvec3(p.x - origin.x, height, p.z - origin.z);
        };
        outline.addEdge(at(a, bottom), at(a, top));
        outline.addEdge(at(a, top), at(b, top));
        outline.addEdge(at(b, bottom), at(a, bottom));
    }
    return std::move(outline).area();
}

std::optional<double> waterSurfaceOver(const std::vector<Water>& waters, glm::dvec3 place) {
    for (const Water& water : waters)
        if (water.contains(place)) return water.surface;
    return {};
}

}  // namespace rubble
