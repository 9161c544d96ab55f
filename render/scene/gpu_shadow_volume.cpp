#include "render/scene/gpu_shadow_volume.h"

#include <algorithm>
#include <glm/common.hpp>
#include <string>

#include "render/frame/shader_constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

static_assert(shared::kShadowCell == kShadowCell);

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

}  // namespace

bool GpuShadowVolume::holds(glm::ivec3 brick) const {
    const glm::ivec3 at = brick - m_low * kSectorBricks;
    return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, bricks()));
}

void GpuShadowVolume::apply(const std::vector<ShadowPatch>& patches, bool replacesAll) {
    if (replacesAll) {
        m_low = m_count = m_occupiedLow = m_occupiedHigh = glm::ivec3(0);
        m_skips.reset(glm::ivec3(0));
        m_directory.resize(0);
        m_slots = {};
        m_waiting.clear();
        m_fullLogged = false;
    }
    growTo(patches);
    for (const ShadowPatch& patch : patches) put(patch);
    updateSkips();
}

/// Makes the directory's box contain the bricks of these patches. A box that grows does so by at least a quarter, so
/// that a body that flies away does not cause a new directory at each step.
void GpuShadowVolume::growTo(const std::vector<ShadowPatch>& patches) {
    glm::ivec3 low = m_low, high = m_low + m_count;
    bool isNew = m_count.x == 0;
    for (const ShadowPatch& patch : patches) {
        if (!patch.content) continue;
        const glm::ivec3 sector = patch.brick >> 2;
        const glm::ivec3 nextLow = isNew ? sector : glm::min(low, sector),
                         nextHigh = isNew ? sector + 1 : glm::max(high, sector + 1);
        if (volume((nextHigh - nextLow) * kSectorBricks) > kMaxBricks) continue;
        low = nextLow;
        high = nextHigh;
        isNew = false;
    }
    if (low == m_low && high == m_low + m_count) return;
    const glm::ivec3 oldBricks = bricks(), oldLow = m_low * kSectorBricks;
    if (m_count.x) {
        const glm::ivec3 margin = m_count / 4;
        const glm::ivec3 wideLow = low - margin * glm::ivec3(glm::lessThan(low, m_low));
        const glm::ivec3 wideHigh = high + margin * glm::ivec3(glm::greaterThan(high, m_low + m_count));
        if (volume((wideHigh - wideLow) * kSectorBricks) <= kMaxBricks) low = wideLow, high = wideHigh;
    }
    std::vector<Entry> old(m_directory.size());
    for (size_t i = 0; i < old.size(); ++i) old[i] = m_directory[i];
    m_low = low;
    m_count = high - low;
    const size_t size = size_t(volume(bricks()));
    m_skips.reset(bricks());
    m_directory.resize(size);
    for (size_t i = 0; i < size; ++i) m_directory.change(i) = Entry(~0u, 0, 0, 0);
    for (size_t i = 0; i < old.size(); ++i) {
        if (isEmpty(old[i])) continue;
        const int n = int(i);
        const glm::ivec3 at(n % oldBricks.x, n / oldBricks.x % oldBricks.y, n / oldBricks.x / oldBricks.y);
        const glm::ivec3 position = oldLow + at - m_low * kSectorBricks;
        m_directory.change(m_skips.indexOf(position)) = old[i];
        m_skips.set(position, true);
    }
}

void GpuShadowVolume::put(const ShadowPatch& patch) {
    if (!holds(patch.brick)) {
        if (patch.content && !m_fullLogged)
            logError("shadow directory: full at " + std::to_string(kMaxBricks) +
                     " bricks, the most it can span; what lies beyond casts no shadow");
        m_fullLogged = m_fullLogged || patch.content;
        return;
    }
    const glm::ivec3 position = patch.brick - m_low * kSectorBricks;
    const size_t index = m_skips.indexOf(position);
    m_skips.set(position, bool(patch.content));
    const Entry old = m_directory[index];
    if (!patch.content) {
        if (isEmpty(old)) return;
        m_slots.free(old.x >> 4);
        m_directory.change(index) = Entry(~0u, 0, 0, 0);  // until updateSkips()
        return;
    }
    growOccupied(patch);
    const uint32_t slot = isEmpty(old) ? m_slots.allocate() : old.x >> 4;
    m_waiting.push_back({slot, patch.content});
    const Entry entry(slot << 4, uint32_t(patch.content->occupied), uint32_t(patch.content->occupied >> 32), 0);
    if (entry != old) m_directory.change(index) = entry;
}

/// Extends the occupied box by those layers of the brick's words that hold anything.
void GpuShadowVolume::growOccupied(const ShadowPatch& patch) {
    constexpr uint64_t kLayer[] = {0x1111111111111111, 0x000f000f000f000f, 0x000000000000ffff};
    glm::ivec3 low = patch.brick * kBrickWords, high = low + kBrickWords;
    const bool isNew = m_occupiedLow == m_occupiedHigh;
    if (!isNew && glm::all(glm::lessThanEqual(m_occupiedLow, low)) &&
        glm::all(glm::greaterThanEqual(m_occupiedHigh, high)))
        return;
    const auto holds = [&](int axis, int layer) {
        return (patch.content->occupied & kLayer[axis] << (layer << (2 * axis))) != 0;
    };
    for (int axis = 0; axis < 3; ++axis) {
        int first = 0, last = kBrickWords - 1;
        while (first < last && !holds(axis, first)) ++first;
        while (last > first && !holds(axis, last)) --last;
        high[axis] = low[axis] + last + 1;
        low[axis] += first;
    }
    m_occupiedLow = isNew ? low : glm::min(m_occupiedLow, low);
    m_occupiedHigh = isNew ? high : glm::max(m_occupiedHigh, high);
}

void GpuShadowVolume::updateSkips() {
    for (const size_t index : m_skips.update())
        if (m_skips.at(index)) m_directory.change(index) = Entry(m_skips.at(index), 0, 0, 0);
}

uint64_t GpuShadowVolume::upload() {
    return m_directory.upload() + uploadTexels();
}

/// Sends waiting texels, neighbours in one call. Of several for one slot the last one counts.
uint64_t GpuShadowVolume::uploadTexels() {
    constexpr uint64_t kBytes = sizeof(ShadowWords);
    if (!m_texels.reserve(m_slots.end() * kBytes) && !m_fullLogged) {
        logError("shadow bricks: full at " + std::to_string(m_texels.bytes()) +
                 " bytes, the largest buffer texture of this GL; further bricks cast no shadow");
        m_fullLogged = true;
    }
    std::stable_sort(m_waiting.begin(), m_waiting.end(),
                     [](const Waiting& a, const Waiting& b) { return a.slot < b.slot; });
    std::vector<ShadowWords> run;
    uint64_t sent = 0;
    for (size_t i = 0; i < m_waiting.size(); ++i) {
        const uint32_t slot = m_waiting[i].slot;
        const uint32_t next = i + 1 < m_waiting.size() ? m_waiting[i + 1].slot : ~0u;
        if (next == slot || (slot + 1) * kBytes > m_texels.bytes()) continue;
        run.push_back(m_waiting[i].content->texels);
        if (next == slot + 1 && (next + 1) * kBytes <= m_texels.bytes()) continue;
        m_texels.upload((slot + 1 - run.size()) * kBytes, std::as_bytes(std::span(run)));
        sent += run.size() * kBytes;
        run.clear();
    }
    m_waiting.clear();
    return sent;
}

void GpuShadowVolume::bind(const Program& program) const {
    program.set("uShadowDirectory", m_directory.texture());
    program.set("uShadowTexels", m_texels);
}

}  // namespace rubble
