#include "render/scene/layer_counts.h"

#include <algorithm>

namespace rubble {

/// The count of a layer; what is between it and the counted layers is counted too from now on.
uint32_t& LayerCounts::at(int layer) {
    if (m_counts.empty()) m_first = layer;
    if (layer < m_first) {
        const int more = std::max(m_first - layer, int(m_counts.size()) / 4);  // many small growths move it seldom
        m_counts.insert(m_counts.begin(), size_t(more), 0);
        m_first -= more;
    }
    if (layer - m_first >= int(m_counts.size())) m_counts.resize(size_t(layer - m_first) + 1, 0);
    return m_counts[size_t(layer - m_first)];
}

void LayerCounts::add(int layer) {
    if (at(layer)++) return;
    const bool isFirst = m_low == m_high;
    m_low = isFirst ? layer : std::min(m_low, layer);
    m_high = isFirst ? layer + 1 : std::max(m_high, layer + 1);
}

void LayerCounts::remove(int layer) {
    if (--at(layer)) return;
    while (m_low < m_high && !at(m_low)) ++m_low;
    while (m_low < m_high && !at(m_high - 1)) --m_high;
    if (m_low == m_high) *this = {};
}

}  // namespace rubble
