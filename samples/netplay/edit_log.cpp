#include "samples/netplay/edit_log.h"

#include <algorithm>
#include <utility>

namespace netplay {
namespace {

constexpr size_t kMaxBytes = 16u << 20;        // of messages that are kept
constexpr size_t kCheapJoinBytes = 64u << 10;  // of messages behind a snapshot for which none is made

}  // namespace

EditLog::EditLog(rubble::World& world, BodyTable& bodies) : m_world(world), m_bodies(bodies) {
    makeSnapshot();
}

void EditLog::makeSnapshot() {
    m_world.keep_deltas(RUBBLE_DELTAS_EDITS);  // what loads the game can follow from here on, and so can all others
    Snapshot snapshot;
    snapshot.game = m_world.save_game_data();
    snapshot.step = m_last = m_snapshotStep = m_world.get_events().step;
    snapshot.names = m_bodies.names();
    m_snapshot = std::make_shared<std::vector<uint8_t>>(encode(snapshot));
    m_bytesBehindSnapshot = 0;
}

void EditLog::follow() {
    m_open.deltas.push_back(m_world.take_deltas());
}

SharedBytes EditLog::closeMessage() {
    if (m_open.deltas.empty()) return nullptr;
    EditSteps message = std::exchange(m_open, {});
    message.last = m_last + message.deltas.size();
    message.names = m_bodies.takeNewNames();
    Entry entry{m_last, message.last, std::make_shared<std::vector<uint8_t>>(encode(message))};
    m_last = message.last;
    m_bytes += entry.message->size();
    m_bytesBehindSnapshot += entry.message->size();
    m_entries.push_back(entry);
    forgetOldest();
    return entry.message;
}

void EditLog::forgetOldest() {
    while (m_bytes > kMaxBytes && m_entries.front().last <= m_snapshotStep) {
        m_bytes -= m_entries.front().message->size();
        m_entries.pop_front();
    }
    if (m_bytes > 2 * kMaxBytes) makeSnapshot();
}

SharedBytes EditLog::snapshot() {
    if (m_bytesBehindSnapshot > std::max(m_snapshot->size(), kCheapJoinBytes)) makeSnapshot();
    return m_snapshot;
}

bool EditLog::has(uint64_t step) const {
    return step == m_last ||
           std::any_of(m_entries.begin(), m_entries.end(), [&](const Entry& entry) { return entry.before == step; });
}

std::vector<SharedBytes> EditLog::since(uint64_t step) const {
    std::vector<SharedBytes> out;
    for (const Entry& entry : m_entries)
        if (entry.before >= step) out.push_back(entry.message);
    return out;
}

}  // namespace netplay
