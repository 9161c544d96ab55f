#include "render/scene/water_outlines.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <string>

#include "render/frame/shader_constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr float kMargin = 1e-3f;  ///< metres added to boxes, more than rounding takes

/// The smallest box around sides, as its centre and half its size.
class SideBox {
public:
    void add(glm::vec4 side) {
        m_low = glm::min(m_low, glm::min(glm::vec2(side.x, side.y), glm::vec2(side.z, side.w)));
        m_high = glm::max(m_high, glm::max(glm::vec2(side.x, side.y), glm::vec2(side.z, side.w)));
    }
    glm::vec4 texel() const { return {(m_low + m_high) * 0.5f, (m_high - m_low) * 0.5f + kMargin}; }

private:
    glm::vec2 m_low{std::numeric_limits<float>::max()}, m_high{-std::numeric_limits<float>::max()};
};

void addOutline(std::vector<glm::vec4>& texels, const GroundPolygon& outline, glm::dvec3 origin) {
    const size_t count = outline.size();
    const auto sideAt = [&](size_t i) {
        const GroundPoint &a = outline[i], &b = outline[(i + 1) % count];
        return glm::vec4(a.x - origin.x, a.z - origin.z, b.x - origin.x, b.z - origin.z);
    };
    const auto addBox = [&](size_t first, size_t last) {
        SideBox box;
        for (size_t i = first; i < last; ++i) box.add(sideAt(i));
        texels.push_back(box.texel());
    };
    constexpr size_t kRun = shared::kOutlineSides, kGroup = shared::kOutlineRuns * kRun;
    for (size_t i = 0; i < count; ++i) {
        if (i % kGroup == 0) addBox(i, std::min(i + kGroup, count));
        if (i % kRun == 0) addBox(i, std::min(i + kRun, count));
        texels.push_back(sideAt(i));
    }
}

}  // namespace

uint64_t WaterOutlines::update(const std::vector<Water>& waters, glm::dvec3 origin) {
    m_texels.clear();
    m_ends.clear();
    for (const Water& water : waters) {
        addOutline(m_texels, water.outline, origin);
        m_ends.push_back(int(m_texels.size()));
    }
    findCovers(waters, origin);
    if (waters.empty()) return 0;
    if (m_texture.refill(std::as_bytes(std::span(m_texels)))) return m_texels.size() * sizeof(glm::vec4);
    m_ends.assign(waters.size(), 0);
    if (!m_fullLogged)
        logWarning("waters: the GL has no room for their " + std::to_string(m_texels.size()) +
                   " sides and boxes; none is drawn");
    m_fullLogged = true;
    return 0;
}

/// Finds for each water those to which what it shares with them belongs: the ones with a higher surface, or before it.
void WaterOutlines::findCovers(const std::vector<Water>& waters, glm::dvec3 origin) {
    m_covers.assign(waters.size(), {});
    std::vector<WorldBox> boxes;
    for (const Water& water : waters) boxes.push_back(water.bounds());
    for (size_t i = 0; i < waters.size(); ++i)
        for (size_t k = 0; k < waters.size(); ++k) {
            const Water& other = waters[k];
            const bool isCover = other.surface > waters[i].surface || (other.surface == waters[i].surface && k < i);
            if (!isCover || !boxes[i].overlaps(boxes[k]) || m_covers[i].size() == shared::kMaxWaterCovers) continue;
            m_covers[i].emplace_back(k == 0 ? 0 : m_ends[k - 1], m_ends[k], other.surface - origin.y,
                                     other.surface - other.depth - origin.y);
        }
}

void WaterOutlines::bind(const Program& program, size_t water) const {
    const std::vector<glm::vec4>& covers = m_covers[water];
    program.set("uCoverCount", int(covers.size()));
    if (!covers.empty()) program.set("uCovers[0]", std::span<const glm::vec4>(covers));
    program.set("uOutline", m_texture);
    program.set("uOutlineFirst", water == 0 ? 0 : m_ends[water - 1]);
    program.set("uOutlineEnd", m_ends[water]);
}

}  // namespace rubble
