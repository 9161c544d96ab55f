#include "editor/ui/state/replay.h"

#include <algorithm>

namespace editor {
namespace {

constexpr size_t kMaxSteps = 3600;               ///< a minute
constexpr size_t kMaxBytes = size_t(512) << 20;  ///< of all steps

}  // namespace

void Replay::begin(rubble::World& world) {
    m_steps.clear();
    m_start = world.save_game_data();
    m_bytes = m_start.size();
    m_isLoaded = false;
    m_place = 0;
    m_isRunning = true;
    ++m_version;
}

void Replay::add(const std::vector<uint8_t>& step) {
    if (!m_isRunning) return;
    m_bytes += step.size();
    m_steps.push_back(step);
    if (m_steps.size() >= kMaxSteps || m_bytes >= kMaxBytes) end();
}

void Replay::seek(size_t place) {
    place = std::min(place, m_steps.size());
    if (place == 0 || (m_isLoaded && place == m_place)) return;
    if (!m_world) {
        rubble_world_settings settings{};
        settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
        m_world = std::make_unique<rubble::World>(settings);
    }
    if (!m_isLoaded || place < m_place) {
        m_world->load_game_data(m_start.data(), m_start.size());
        m_isLoaded = true;
        m_place = 0;
    }
    for (; m_place < place; ++m_place) m_world->apply_deltas(m_steps[m_place].data(), m_steps[m_place].size());
    ++m_version;
}

}  // namespace editor
