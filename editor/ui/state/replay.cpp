#include "editor/ui/state/replay.h"

#include <algorithm>

namespace editor {
namespace {

constexpr size_t kMaxSteps = 3600;               ///< a minute
constexpr size_t kMaxBytes = size_t(512) << 20;  ///< of all steps

}  // namespace

void Replay::begin(rubble::World& world) {
    m_starts.clear();
    m_steps.clear();
    m_isRunning = true;
    rewind(world, 0);
}

void Replay::rewind(rubble::World& world, size_t steps) {
    if (!m_isRunning || steps > m_steps.size()) return;
    m_steps.resize(steps);
    std::erase_if(m_starts, [&](const Start& each) { return each.step >= steps; });
    m_starts.push_back({steps, world.save_game_data()});
    m_bytes = 0;
    for (const Start& each : m_starts) m_bytes += each.game.size();
    for (const std::vector<uint8_t>& each : m_steps) m_bytes += each.size();
    m_isLoaded = false;
    m_place = 0;
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
    const auto start = std::find_if(m_starts.rbegin(), m_starts.rend(), [&](const Start& s) { return s.step < place; });
    if (!m_isLoaded || place < m_place || start->step > m_place) {
        m_world->load_game_data(start->game.data(), start->game.size());
        m_isLoaded = true;
        m_place = start->step;
    }
    for (; m_place < place; ++m_place) m_world->apply_deltas(m_steps[m_place].data(), m_steps[m_place].size());
    ++m_version;
}

}  // namespace editor
