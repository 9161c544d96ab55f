#include "runtime/world/state/debris_queue.h"

#include <bit>

namespace rubble {

DebrisQueue::Key DebrisQueue::keyOf(const Debris& piece) {
    return {piece.rest, int(std::bit_width(piece.voxels)), piece.createdStep, piece.body.slot()};
}

void DebrisQueue::set(const Debris& piece) {
    const uint32_t slot = piece.body.slot();
    if (m_pieces.size() <= slot) m_pieces.resize(slot + 1);
    decltype(m_order)::node_type node;  // to be used again
    if (m_pieces[slot].body) node = m_order.extract(keyOf(m_pieces[slot]));
    remove(m_pieces[slot].body);
    m_pieces[slot] = piece;
    if (node)
        node.value() = keyOf(piece), m_order.insert(std::move(node));
    else
        m_order.insert(keyOf(piece));
    if (piece.rest == RestState::Asleep) m_asleep.emplace(piece.restingSince, slot);
    m_awake += piece.rest == RestState::Awake;
    m_voxels += piece.voxels;
}

void DebrisQueue::remove(BodyHandle body) {
    if (!body || !contains(body)) return;
    const uint32_t slot = body.slot();
    const Debris piece = std::exchange(m_pieces[slot], {});
    m_order.erase(keyOf(piece));
    m_asleep.erase({piece.restingSince, slot});
    m_awake -= piece.rest == RestState::Awake;
    m_voxels -= piece.voxels;
}

std::optional<BodyHandle> DebrisQueue::asleepSince(uint64_t step) const {
    if (m_asleep.empty() || m_asleep.begin()->first > step) return std::nullopt;
    return m_pieces[m_asleep.begin()->second].body;
}

}  // namespace rubble
