#include "runtime/shadow/shadow_copy.h"

namespace rubble {

void ShadowCopy::follow(std::span<const ShadowPatches> publications) {
    for (const ShadowPatches& each : publications) {
        ++m_version;
        if (each.replacesAll) {
            m_bricks.clear();
            m_changes = {};
            m_first = m_version;
        }
        for (const ShadowPatch& patch : each.patches) {
            const BrickPlace place(patch.brick);
            if (patch.content)
                m_bricks.insert_or_assign(place, patch.content);
            else
                m_bricks.erase(place);
            m_changes.add(place, m_version);
        }
    }
}

const std::vector<BrickPlace>* ShadowCopy::changed(uint64_t since) {
    if (since > m_version || (since && since < m_first)) return nullptr;
    m_found.clear();
    if (since)
        m_changes.since(since, m_found);
    else
        for (const auto& [place, brick] : m_bricks) m_found.push_back(place);
    return &m_found;
}

const ShadowBrick* ShadowCopy::find(const BrickPlace& place) const {
    const auto found = m_bricks.find(place);
    return found == m_bricks.end() ? nullptr : found->second.get();
}

}  // namespace rubble
