#include "samples/netplay/body_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netplay {

void BodyTable::follow(const rubble::World& world) {
    const rubble_events events = world.get_events();
    for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i)
        if (const auto gone = m_ids.find(events.bodies_destroyed[i]); gone != m_ids.end()) {
            m_bodies.erase(gone->second);
            m_ids.erase(gone);
        }
    m_moved.clear();
    rubble_row_list list{};
    list.kind = RUBBLE_ROWS_MOVED_BODIES;
    for (const rubble_body_state& state : world.read_rows<rubble_body_state>(list)) {
        const auto [named, isNew] = m_ids.try_emplace(state.body, m_next);
        TrackedBody& body = m_bodies[named->second];
        if (isNew) {
            m_newNames.push_back({m_next++, state.body, events.step});
            body.firstStep = events.step;
        }
        body.handle = state.body;
        body.pose.id = named->second;
        std::copy_n(state.position, 3, body.pose.position.begin());
        std::copy_n(state.rotation, 4, body.pose.rotation.begin());
        body.pose.isAsleep = state.flags & (RUBBLE_BODY_ASLEEP | RUBBLE_BODY_STATIC);
        body.movedStep = events.step;
        body.speed = std::hypot(state.velocity[0], state.velocity[1], state.velocity[2]);
        m_moved.push_back(body.pose.id);
    }
}

const TrackedBody* BodyTable::find(uint32_t id) const {
    const auto found = m_bodies.find(id);
    return found == m_bodies.end() ? nullptr : &found->second;
}

std::vector<uint32_t> BodyTable::all() const {
    std::vector<uint32_t> out;
    for (const auto& [id, body] : m_bodies) out.push_back(id);
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<BodyName> BodyTable::names() const {
    std::vector<BodyName> out;
    for (const uint32_t id : all()) out.push_back({id, m_bodies.at(id).handle, m_bodies.at(id).firstStep});
    return out;
}

std::vector<BodyName> BodyTable::takeNewNames() {
    return std::exchange(m_newNames, {});
}

}  // namespace netplay
