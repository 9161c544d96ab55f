#include "render/frame/view_histories.h"

#include <algorithm>
#include <glm/common.hpp>

namespace rubble {
namespace {

int leastDownscaleFor(glm::ivec2 size, const GlLimits& limits) {
    const glm::ivec2 largest = glm::min(glm::ivec2(limits.textureSide), limits.viewport);
    int downscale = 0;
    while (downscale < ViewHistories::kMaxDownscale && glm::any(glm::greaterThan(size >> downscale, largest)))
        ++downscale;
    return downscale;
}

}  // namespace

ViewHistory& ViewHistories::begin(int slot, glm::ivec2 size, const GlLimits& limits) {
    ++m_draws;
    auto found = std::find_if(m_all.begin(), m_all.end(),
                              [&](const ViewHistory& each) { return each.slot == slot && each.size == size; });
    if (found != m_all.end()) {
        m_all.splice(m_all.begin(), m_all, found);
    } else {
        m_all.emplace_front().slot = slot;
        m_all.front().size = size;
        m_all.front().leastDownscale = m_all.front().downscale = leastDownscaleFor(size, limits);
    }
    ViewHistory& view = m_all.front();
    view.lastDraw = m_draws;
    if (view.downscale == view.leastDownscale) view.tryLargerAt = m_draws + kRetryDraws;
    if (m_draws >= view.tryLargerAt) view.downscale = view.leastDownscale;
    size_t sizes = 0;
    std::erase_if(m_all, [&](const ViewHistory& each) {
        return (each.slot == slot && ++sizes > kSizes) || each.lastDraw + kIdleDraws < m_draws;
    });
    return view;
}

uint64_t ViewHistories::bytes() const {
    uint64_t sum = 0;
    for (const ViewHistory& each : m_all) sum += each.bytes();
    return sum;
}

}  // namespace rubble
