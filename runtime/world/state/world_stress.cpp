#include "runtime/world/state/world_stress.h"

#include "runtime/core/hash.h"

namespace rubble {

WorldStress::Entry& WorldStress::add(ShapeHandle shape) {
    Entry& entry = m_entries[shape.slot()];
    entry = {};
    entry.shape = shape;
    wake(shape);
    return entry;
}

void WorldStress::remove(ShapeHandle shape) {
    if (!find(shape)) return;
    sleep(shape);
    m_entries.erase(shape.slot());
}

WorldStress::Entry* WorldStress::find(ShapeHandle shape) {
    const auto found = m_entries.find(shape.slot());
    return found != m_entries.end() && found->second.shape == shape ? &found->second : nullptr;
}

std::vector<ShapeHandle> WorldStress::busy() const {
    std::vector<ShapeHandle> out;
    out.reserve(m_busy.size());
    for (auto slot = m_busy.upper_bound(m_lastServed); slot != m_busy.end(); ++slot)
        out.push_back(m_entries.at(*slot).shape);
    for (auto slot = m_busy.begin(); slot != m_busy.end() && *slot <= m_lastServed; ++slot)
        out.push_back(m_entries.at(*slot).shape);
    return out;
}

void WorldStress::restartAll() {
    for (auto& [slot, entry] : m_entries) {
        entry.analysis.restart();
        m_busy.insert(slot);
    }
}

uint64_t WorldStress::hash() const {
    uint64_t out = hashValue(m_lastServed);
    for (const auto& [slot, entry] : m_entries)
        for (const WeakBrick& weak : entry.weak)
            out = hashValue(weak.left, hashBytes(&weak.brick, sizeof weak.brick, hashValue(slot, out)));
    for (const uint32_t slot : m_busy) {
        const Entry& entry = m_entries.at(slot);
        out = hashValue(slot, out);
        out = hashValue(entry.analysis.hash(), out);
        out = hashValue(uint64_t(entry.cracks.size()), out);
    }
    return out;
}

}  // namespace rubble
