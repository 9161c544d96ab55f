#include "render/scene/brick_atlas.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr size_t kWordBytes = 64, kIndexBytes = kBrickVoxels;

/// The 4x4x4 voxels at (x, y, z) * 4 of a brick as one word: bit x + 4 y + 16 z.
uint64_t wordOf(const Brick& brick, int x, int y, int z) {
    uint64_t word = 0;
    for (int dz = 0; dz < 4; ++dz)
        for (int dy = 0; dy < 4; ++dy) word |= (brick.occupancy[size_t(z * 4 + dz)] >> (x * 4 + (y * 4 + dy) * 8) & 15) << (dy * 4 + dz * 16);
    return word;
}

}  // namespace

uint32_t BrickAtlas::occupiedWords(const Brick& brick) {
    uint32_t mask = 0;
    for (int i = 0; i < 8; ++i) mask |= uint32_t(wordOf(brick, i & 1, i >> 1 & 1, i >> 2) != 0) << i;
    return mask;
}

uint32_t BrickAtlas::acquire(const BrickRef& brick) {
    const auto [found, isNew] = m_entries.try_emplace(brick.get());
    Entry& entry = found->second;
    if (isNew) {
        entry = {brick, m_slots.take(), 0};
        m_bySlot.resize(std::max<size_t>(m_bySlot.size(), entry.slot + 1));
        m_bySlot[entry.slot] = brick.get();
        m_pending.push_back(entry.slot);
        if (brick->paint) needPaint().put(entry.slot, *brick);
    }
    ++entry.references;
    return entry.slot;
}

void BrickAtlas::release(const Brick* brick) {
    const auto found = m_entries.find(brick);
    assert(found != m_entries.end() && "a brick released more often than acquired");
    if (--found->second.references) return;
    m_bySlot[found->second.slot] = nullptr;
    m_slots.give(found->second.slot);
    if (m_paint) m_paint->remove(found->second.slot);
    m_entries.erase(found);
}

PaintAtlas& BrickAtlas::needPaint() {
    if (!m_paint) m_paint = std::make_unique<PaintAtlas>();
    return *m_paint;
}

uint64_t BrickAtlas::upload() {
    return uploadBricks() + (m_paint ? m_paint->upload(m_slots.end()) : 0);
}

uint64_t BrickAtlas::uploadBricks() {
    if (m_pending.empty()) return 0;
    std::sort(m_pending.begin(), m_pending.end());
    m_pending.erase(std::unique(m_pending.begin(), m_pending.end()), m_pending.end());
    std::erase_if(m_pending, [&](uint32_t slot) { return !m_bySlot[slot]; });
    if (!m_words.reserve(m_slots.end() * kWordBytes) || !m_indices.reserve(m_slots.end() * kIndexBytes)) {
        if (!m_full) logError("brick atlas: full at " + std::to_string(bytes()) + " bytes, the largest buffer texture of this GL");
        m_full = true;
        const uint64_t room = std::min(m_words.bytes() / kWordBytes, m_indices.bytes() / kIndexBytes);
        std::erase_if(m_pending, [&](uint32_t slot) { return slot >= room; });
    }
    std::vector<uint64_t> words;
    std::vector<uint8_t> indices;
    for (size_t i = 0; i < m_pending.size();) {
        const size_t first = i;
        words.clear();
        indices.clear();
        for (; i < m_pending.size() && m_pending[i] == m_pending[first] + (i - first); ++i) {
            const Brick& brick = *m_bySlot[m_pending[i]];
            for (int w = 0; w < 8; ++w) words.push_back(wordOf(brick, w & 1, w >> 1 & 1, w >> 2));
            BrickIndices expanded;
            expandBrick(&brick, expanded);
            indices.insert(indices.end(), expanded.begin(), expanded.end());
        }
        m_words.upload(m_pending[first] * kWordBytes, std::as_bytes(std::span(words)));
        m_indices.upload(m_pending[first] * kIndexBytes, std::as_bytes(std::span(indices)));
    }
    const uint64_t sent = m_pending.size() * (kWordBytes + kIndexBytes);
    m_pending.clear();
    return sent;
}

}  // namespace rubble
