#include "render/scene/gpu_shadow_volume.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/frame/shader_constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

static_assert(shared::kShadowCell == kShadowCell);

constexpr uint64_t kSlotBytes = sizeof(ShadowWords);
constexpr size_t kSlotsPerCall = (512 << 10) / kSlotBytes;  ///< what is gathered for a call stays in the cache

}  // namespace

void GpuShadowVolume::apply(const std::vector<ShadowPatch>& patches, bool replacesAll) {
    if (replacesAll) {
        m_directory.clear();
        m_slots = {};
        m_maxSlots = ~0u;
        m_waiting.clear();
        m_isSpanLogged = m_isMemoryLogged = false;
    }
    m_directory.reach(patches);
    for (const ShadowPatch& patch : patches) put(patch);
    m_directory.update();
    if (m_directory.beyond() && !std::exchange(m_isSpanLogged, true)) logSpan();
}

void GpuShadowVolume::logSpan() const {
    const glm::dvec3 middle = glm::dvec3(m_directory.middle()) * (double(kShadowCell) * ShadowDirectory::kSectorCells);
    const auto metres = [&](int axis) { return std::to_string(std::llround(middle[axis])); };
    logError("shadow directory: full at " + std::to_string(ShadowDirectory::kMaxSectors) +
             " sectors of 6.4 m, the most it can span; " + std::to_string(m_directory.beyond()) +
             " bricks of 1.6 m cast no shadow, those farthest from the middle of most, (" + metres(0) + ", " +
             metres(1) + ", " + metres(2) + ") m");
}

void GpuShadowVolume::remove(glm::ivec3 brick) {
    const ShadowDirectory::Brick old = m_directory.find(brick);
    if (!old.occupied) return;
    m_slots.free(old.slot);
    m_directory.set(brick, {});
}

void GpuShadowVolume::put(const ShadowPatch& patch) {
    if (!patch.content) return remove(patch.brick);
    const ShadowDirectory::Brick old = m_directory.find(patch.brick);
    const uint32_t slot = old.occupied ? old.slot : m_slots.allocate();
    if (slot >= m_maxSlots) return m_slots.free(slot);
    m_waiting.push_back({slot, patch.content});
    m_directory.set(patch.brick, {slot, patch.content->occupied});
}

/// Makes room for all texels. Bricks that find none, as the GL's buffer textures end, are removed.
void GpuShadowVolume::reserveTexels() {
    uint64_t bytes = std::min(m_slots.end(), m_maxSlots) * kSlotBytes;
    if (m_texels.reserve(bytes)) return;
    while (!m_texels.reserve(bytes)) bytes = std::max(m_texels.bytes(), bytes - bytes / 16);
    m_maxSlots = uint32_t(m_texels.bytes() / kSlotBytes);
    std::vector<glm::ivec3> beyond;
    m_directory.forEach([&](glm::ivec3 brick, const ShadowDirectory::Brick& content) {
        if (content.slot >= m_maxSlots) beyond.push_back(brick);
    });
    for (const glm::ivec3 brick : beyond) remove(brick);
    m_directory.update();
    if (!std::exchange(m_isMemoryLogged, true))
        logError("shadow bricks: full at " + std::to_string(m_texels.bytes()) +
                 " bytes, the largest buffer texture of this GL; further bricks cast no shadow");
}

uint64_t GpuShadowVolume::upload() {
    reserveTexels();
    return m_directory.upload() + uploadTexels();
}

/// Sends waiting texels, neighbours in one call as far as kSlotsPerCall goes. Of several for one slot the last one
/// counts.
uint64_t GpuShadowVolume::uploadTexels() {
    std::erase_if(m_waiting, [&](const Waiting& waiting) { return waiting.slot >= m_maxSlots; });
    std::stable_sort(m_waiting.begin(), m_waiting.end(),
                     [](const Waiting& a, const Waiting& b) { return a.slot < b.slot; });
    std::vector<ShadowWords> run;
    uint64_t sent = 0;
    for (size_t i = 0; i < m_waiting.size(); ++i) {
        const uint32_t slot = m_waiting[i].slot;
        const uint32_t next = i + 1 < m_waiting.size() ? m_waiting[i + 1].slot : ~0u;
        if (next == slot) continue;
        run.push_back(m_waiting[i].content->texels);
        if (next == slot + 1 && run.size() < kSlotsPerCall) continue;
        m_texels.upload((slot + 1 - run.size()) * kSlotBytes, std::as_bytes(std::span(run)));
        sent += run.size() * kSlotBytes;
        run.clear();
    }
    m_waiting.clear();
    return sent;
}

void GpuShadowVolume::bind(const Program& program) const {
    program.set("uShadowTable", m_directory.table());
    program.set("uShadowBricks", m_directory.texels());
    program.set("uShadowTexels", m_texels);
}

}  // namespace rubble
