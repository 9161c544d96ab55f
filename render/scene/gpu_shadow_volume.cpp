#include "render/scene/gpu_shadow_volume.h"

#include <algorithm>
#include <string>
#include <utility>

#include "render/frame/shader_constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

static_assert(shared::kShadowCell == kShadowCell);

constexpr uint64_t kSlotBytes = sizeof(ShadowWords);

}  // namespace

void GpuShadowVolume::apply(const std::vector<ShadowPatch>& patches, bool replacesAll) {
    if (replacesAll) {
        m_directory.clear();
        m_maxSlots = ~0u;
        m_isSpanLogged = m_isMemoryLogged = false;
    }
    m_directory.reach(patches);
    for (const ShadowPatch& patch : patches) put(patch);
    m_directory.update();
}

void GpuShadowVolume::put(const ShadowPatch& patch) {
    if (m_directory.holds(patch.brick)) return m_directory.set(patch.brick, patch.content);
    if (patch.content && !std::exchange(m_isSpanLogged, true))
        logError("shadow directory: full at " + std::to_string(ShadowDirectory::kMaxSectors) +
                 " sectors of 3.2 m, the most it can span; what lies beyond casts no shadow");
}

/// Makes room for all texels, and for those that rays read behind the last block, whatever they are. Bricks that find
/// none, as the GL's buffer textures end, are removed.
void GpuShadowVolume::reserveTexels() {
    uint64_t bytes = (m_directory.slots() + uint64_t(1)) * kSlotBytes;
    if (m_directory.slots() <= m_maxSlots) {
        if (m_texels.reserve(bytes)) return;
        while (!m_texels.reserve(bytes)) bytes = std::max(m_texels.bytes(), bytes - bytes / 16);
        m_maxSlots = uint32_t(m_texels.bytes() / kSlotBytes) - 1;
    }
    m_directory.removeBeyond(m_maxSlots);
    m_directory.update();
    if (!std::exchange(m_isMemoryLogged, true))
        logError("shadow bricks: full at " + std::to_string(m_texels.bytes()) +
                 " bytes, the largest buffer texture of this GL; further bricks cast no shadow");
}

uint64_t GpuShadowVolume::upload() {
    if (m_directory.hasPlaced()) reserveTexels();
    return m_directory.upload() + uploadTexels();
}

/// Sends texels of bricks, neighbours in one call.
uint64_t GpuShadowVolume::uploadTexels() {
    std::vector<ShadowDirectory::Placed> placed = m_directory.takePlaced();
    std::erase_if(placed, [&](const ShadowDirectory::Placed& brick) { return brick.slot >= m_maxSlots; });
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
    std::vector<ShadowWords> run;
    uint64_t sent = 0;
    for (size_t i = 0; i < placed.size(); ++i) {
        const uint32_t slot = placed[i].slot;
        const uint32_t next = i + 1 < placed.size() ? placed[i + 1].slot : ~0u;
        if (next == slot) continue;
        run.push_back(placed[i].content->texels);
        if (next == slot + 1) continue;
        m_texels.upload((slot + 1 - run.size()) * kSlotBytes, std::as_bytes(std::span(run)));
        sent += run.size() * kSlotBytes;
        run.clear();
    }
    return sent;
}

void GpuShadowVolume::bind(const Program& program) const {
    program.set("uShadowSectors", m_directory.table());
    program.set("uShadowPages", m_directory.pages());
    program.set("uShadowTexels", m_texels);
}

}  // namespace rubble
