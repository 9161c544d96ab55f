#include "physics/solver/steady_bodies.h"

#include <algorithm>

namespace rubble {

void SteadyBodies::begin(ContactSet& set, std::span<const SolverBody> bodies) {
    m_before.resize(bodies.size());
    for (size_t i = 1; i < bodies.size(); ++i)
        set.states[i].isSteady = !bodies[i].conservesMomentum && !set.states[i].isJointed;
    for (const PairConstraints& pair : set.pairs)
        if (pair.isFollowed) set.stateA(pair).isSteady = set.stateB(pair).isSteady = false;
    m_steady = 0;
}

void SteadyBodies::startSubstep(ContactSet& set, const glm::vec3& fall, bool isFirst) {
    size_t steady = 0;
    for (size_t i = 1; i < set.states.size(); ++i) {
        SolverState& state = set.states[i];
        const Velocity gain{state.v - m_before[i].linear, state.w - m_before[i].angular};
        state.v += fall * state.gravityScale;
        m_before[i] = {state.v, state.w};
        if (isFirst || !state.isSteady) continue;
        state.v += gain.linear, state.w += gain.angular;
        ++steady;
    }
    if (steady != m_steady) markGroups(set);
    m_steady = steady;
}

void SteadyBodies::markGroups(ContactSet& set) {
    const auto isSteady = [&](int body) { return !body || set.states[size_t(body)].isSteady; };
    for (PairGroup& group : set.groups)
        group.isSteady = std::all_of(std::begin(group.a), std::end(group.a), isSteady) &&
                         std::all_of(std::begin(group.b), std::end(group.b), isSteady);
}

}  // namespace rubble
