#include "runtime/world/queries/ray_order.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>

namespace rubble {
namespace {

constexpr uint32_t kCells = 16;  ///< along the longest side
constexpr uint32_t kPlaces = 8 * kCells * kCells * kCells;

/// The bits of a number below kCells with two zeros after each.
constexpr std::array<uint32_t, kCells> kSpread = [] {
    std::array<uint32_t, kCells> out{};
    for (uint32_t i = 0; i < kCells; ++i)
        for (uint32_t bit = 0; bit < 4; ++bit) out[i] |= (i >> bit & 1) << 3 * bit;
    return out;
}();

/// A cell of a side; 0 for what is no number.
uint32_t cellOf(double place) {
    return place > 0.0 ? uint32_t(std::min(place, double(kCells - 1))) : 0;
}

/// Where rays begin, as cells of a grid, and where they go, as octants.
class Grid {
public:
    explicit Grid(std::span<const RayQuery> rays) {
        glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
        for (const RayQuery& ray : rays) low = glm::min(low, ray.origin), high = glm::max(high, ray.origin);
        const glm::dvec3 size = high - low;
        const double side = std::max({size.x, size.y, size.z});
        m_low = low;
        m_cellsPerMetre = side > 0.0 ? kCells / side : 0.0;
    }
    /// The place of a ray: below kPlaces.
    uint32_t placeOf(const RayQuery& ray) const {
        const glm::dvec3 cell = (ray.origin - m_low) * m_cellsPerMetre;
        const uint32_t onCurve =
            kSpread[cellOf(cell.x)] | kSpread[cellOf(cell.y)] << 1u | kSpread[cellOf(cell.z)] << 2u;
        const uint32_t octant = uint32_t(ray.direction.x < 0.0) | uint32_t(ray.direction.y < 0.0) << 1 |
                                uint32_t(ray.direction.z < 0.0) << 2;
        return onCurve << 3 | octant;
    }

private:
    glm::dvec3 m_low{0.0};
    double m_cellsPerMetre = 0.0;
};

}  // namespace

/// A counting sort.
std::vector<uint32_t> coherentOrder(std::span<const RayQuery> rays) {
    const Grid grid(rays);
    std::vector<uint16_t> places(rays.size());
    std::vector<uint32_t> next(kPlaces + 1);
    for (size_t i = 0; i < rays.size(); ++i) {
        places[i] = uint16_t(grid.placeOf(rays[i]));
        ++next[places[i] + 1u];
    }
    for (size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    std::vector<uint32_t> order(rays.size());
    for (size_t i = 0; i < rays.size(); ++i) order[next[places[i]]++] = uint32_t(i);
    return order;
}

}  // namespace rubble
