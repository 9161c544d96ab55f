// What a random host with physics of its own calls.
#include "tests/fuzz/random_host.h"

namespace rubble {

void RandomHost::callHostPhysics() {
    rubble_rigid_body rigids[16];
    rubble_body_box boxes[64];
    rubble_body_impulse impulses[4];
    uint32_t count = 0, layers = 0;
    api().get_layers(&layers);
    api().get_rigid_bodies(m_world, whole(2), rigids, m_decisions.below(17), &count);
    api().get_body_boxes(m_world, any(bodies()), boxes, 64, &count);
    api().get_body_impulses(m_world, impulses, 4, &count);
    std::vector<rubble_body_state> states(m_decisions.below(4));
    for (rubble_body_state& state : states) {
        const uint64_t body = any(bodies());
        if (api().get_body_state(m_world, body, &state) != RUBBLE_OK || m_decisions.oneIn(4)) {
            state = {}, state.body = body, place(state.position), rotation(state.rotation);
        }
        state.flags = m_decisions.oneIn(4) ? whole(4) : state.flags & RUBBLE_BODY_ASLEEP;
        for (double& each : state.position) each += number(0.3);
        fill(state.velocity, 20.0);
    }
    const rubble_result moved = api().set_body_states(m_world, states.data(), uint32_t(states.size()));
    std::vector<rubble_impact> impacts(m_decisions.below(3));
    for (rubble_impact& impact : impacts) {
        impact = {};
        impact.body = any(bodies()), impact.other = m_decisions.oneIn(2) ? 0 : any(bodies());
        place(impact.position), fill(impact.normal, 1.0);
        impact.impulse = number(1e5), impact.speed = number(30.0);
    }
    const rubble_result hit = api().report_impacts(m_world, impacts.data(), uint32_t(impacts.size()));
    if (!m_isHostMoved && (moved == RUBBLE_OK || hit == RUBBLE_OK)) fail("the host moves a world that moves itself");
    if (m_isHostMoved && moved == RUBBLE_OK && !states.empty()) {
        m_hasLoaded = true;  // at once
        reached("bodies moved by the host");
    }
    if (m_isHostMoved && hit == RUBBLE_OK && !impacts.empty()) reached("impacts of the host");
}

}  // namespace rubble
