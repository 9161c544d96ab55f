#include "render/scene/brick_atlas.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "runtime/core/assertion.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr size_t kBricksPerCall = 1024;  ///< what is gathered for a call stays in the processor's cache

/// The 4x4x4 voxels at (x, y, z) * 4 of a brick as one word: bit x + 4 y + 16 z.
uint64_t wordOf(const Brick& brick, int x, int y, int z) {
    uint64_t word = 0;
    for (int dz = 0; dz < 4; ++dz) {
        // Four rows of eight bits, of which four count, moved together.
        uint64_t rows = brick.occupancy[size_t(z * 4 + dz)] >> (x * 4 + y * 32) & 0x0f0f0f0f;
        rows = (rows | rows >> 4) & 0x00ff00ff;
        rows = (rows | rows >> 8) & 0xffff;
        word |= rows << (dz * 16);
    }
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
        entry = {brick, m_slots.allocate(), 0};
        m_bySlot.resize(std::max<size_t>(m_bySlot.size(), entry.slot + 1));
        m_bySlot[entry.slot] = brick.get();
        m_pending.push_back(entry.slot);
        ++m_queued;
        if (brick->paint) ensurePaint().put(entry.slot, *brick);
    }
    ++entry.references;
    return entry.slot;
}

void BrickAtlas::release(const Brick* brick) {
    const auto found = m_entries.find(brick);
    RUBBLE_ASSERT(found != m_entries.end() && "a brick released more often than acquired");
    if (--found->second.references) return;
    m_bySlot[found->second.slot] = nullptr;
    m_slots.free(found->second.slot);
    if (m_paint) m_paint->remove(found->second.slot);
    m_entries.erase(found);
}

PaintAtlas& BrickAtlas::ensurePaint() {
    if (!m_paint) m_paint = std::make_unique<PaintAtlas>();
    return *m_paint;
}

uint64_t BrickAtlas::upload(uint64_t budgetBytes) {
    return uploadBricks(budgetBytes) + (m_paint ? m_paint->upload(m_slots.end()) : 0);
}

uint64_t BrickAtlas::uploadBricks(uint64_t budgetBytes) {
    const size_t count = size_t(std::min<uint64_t>(m_pending.size(), budgetBytes / kBrickBytes));
    if (count == 0) return 0;
    std::vector<uint32_t> slots(m_pending.begin(), m_pending.begin() + std::ptrdiff_t(count));
    m_pending.erase(m_pending.begin(), m_pending.begin() + std::ptrdiff_t(count));
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    std::erase_if(slots, [&](uint32_t slot) { return !m_bySlot[slot]; });
    if (!m_words.reserve(m_slots.end() * kWordBytes) || !m_indices.reserve(m_slots.end() * kIndexBytes)) {
        if (!m_full)
            logError("brick atlas: full at " + std::to_string(bytes()) +
                     " bytes, as the GL has no room for more; further bricks are not drawn");
        m_full = true;
        std::erase_if(slots, [&](uint32_t slot) { return slot >= room(); });
    }
    send(slots);
    return slots.size() * kBrickBytes;
}

/// Sends ascending slots; neighbours in one call, as far as kBricksPerCall goes.
void BrickAtlas::send(const std::vector<uint32_t>& slots) {
    std::vector<std::array<uint64_t, 8>> words(std::min(slots.size(), kBricksPerCall));
    std::vector<BrickIndices> indices(words.size());
    for (size_t i = 0, count = 0; i < slots.size(); i += count) {
        const uint32_t first = slots[i];
        for (count = 0; count < words.size() && i + count < slots.size() && slots[i + count] == first + count;
             ++count) {
            const Brick& brick = *m_bySlot[slots[i + count]];
            for (int w = 0; w < 8; ++w) words[count][size_t(w)] = wordOf(brick, w & 1, w >> 1 & 1, w >> 2);
            expandBrick(&brick, indices[count]);
        }
        m_words.upload(first * kWordBytes, std::as_bytes(std::span(words).first(count)));
        m_indices.upload(first * kIndexBytes, std::as_bytes(std::span(indices).first(count)));
    }
}

}  // namespace rubble
