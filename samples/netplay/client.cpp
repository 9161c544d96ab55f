#include "samples/netplay/client.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/netplay/player.h"

namespace netplay {

void Client::connect(std::unique_ptr<Transport> transport) {
    m_transport = std::move(transport);
    m_server = 0;
    m_state = State::Joining;
    m_hasSequence = false;
}

void Client::disconnect() {
    m_transport.reset();
    m_state = State::Disconnected;
}

void Client::tick() {
    ++m_ticks;
    try {
        if (m_transport) receive();
    } catch (const rubble::Error&) {  // this is not, or no longer, the server's world
        rejoin();
    }
    if (m_state == State::Playing) m_clock.tick(m_received);
    show(0.0);
    if (m_transport) {
        send();
        m_transport->tick();
    }
}

/// The world is at the end of the step that is shown, its bodies where they are then.
void Client::show(double partOfStep) try {
    if (m_state != State::Playing) return;
    const double time = std::min(m_clock.now() + partOfStep, double(m_received));
    for (; !m_steps.empty() && double(m_steps.front().step) < time + 1.0; m_steps.pop_front()) {
        moveBodies(m_steps.front().step);
        apply(m_steps.front());
    }
    m_alpha = std::clamp(time + 1.0 - double(m_applied), 0.0, 1.0);
} catch (const rubble::Error&) {
    rejoin();
}

void Client::receive() {
    Event event;
    while (m_transport && m_transport->receive(event)) {
        if (event.kind == Event::Kind::Connected) {
            m_server = event.peer;
            m_transport->send(m_server, Delivery::Reliable, encode(Join{kVersion, m_token, m_game, m_received}));
        } else if (event.kind == Event::Kind::Disconnected) {
            if (m_state != State::Refused) m_state = State::Disconnected;
            m_transport.reset();
        } else if (const std::optional<Message> message = decode(event.bytes, false)) {
            handle(*message);
        } else {
            rejoin();
        }
    }
}

void Client::handle(const Message& message) {
    if (std::holds_alternative<Refused>(message)) m_state = State::Refused;
    if (const auto* welcome = std::get_if<Welcome>(&message)) {
        m_token = welcome->token, m_game = welcome->game, m_player = welcome->player;
        if (welcome->isResumed) m_state = State::Playing;
    }
    if (const auto* snapshot = std::get_if<Snapshot>(&message)) take(*snapshot);
    if (const auto* steps = std::get_if<EditSteps>(&message)) take(*steps);
    if (const auto* poses = std::get_if<Poses>(&message)) take(*poses);
}

void Client::take(const Snapshot& snapshot) {
    m_steps.clear(), m_bodies.clear(), m_ids.clear(), m_moving.clear();
    m_world.load_game_data(snapshot.game.data(), snapshot.game.size());
    m_applied = m_received = snapshot.step;
    m_clock = {};
    for (const BodyName& each : snapshot.names) name(each);
    m_state = State::Playing;
    ++m_snapshots;
}

void Client::take(EditSteps message) {
    const uint64_t before = message.last - message.deltas.size();
    if (before != m_received) return rejoin();
    for (auto& delta : message.deltas) m_steps.push_back({++m_received, std::move(delta), {}});
    for (const BodyName& each : message.names)
        if (each.step > before) m_steps[m_steps.size() - 1 - size_t(message.last - each.step)].names.push_back(each);
}

void Client::noteSequence(uint16_t sequence) {
    const auto ahead = int16_t(sequence - m_input.newest);
    if (!std::exchange(m_hasSequence, true)) {
        m_input.newest = sequence, m_input.older = 0;
    } else if (ahead > 0) {
        const uint64_t arrived = (uint64_t(m_input.older) << 1 | 1) << std::min<int>(ahead - 1, 33);
        m_input.newest = sequence, m_input.older = uint32_t(arrived);
    } else if (ahead < 0 && ahead >= -32) {
        m_input.older |= 1u << (-ahead - 1);
    }
}

void Client::take(const Poses& poses) {
    noteSequence(poses.sequence);
    m_clock.hear(poses.step);
    m_players = poses.players;
    for (const BodyPose& pose : poses.bodies) {
        Tracked& tracked = m_bodies[pose.id];
        const auto foreseen = tracked.body ? tracked.track.at(m_clock.now()) : std::nullopt;
        tracked.track.add(poses.step, pose);
        m_moving.insert(pose.id);
        if (!foreseen) continue;
        const BodyPose now = *tracked.track.at(m_clock.now());
        const double jump = std::hypot(now.position[0] - foreseen->position[0], now.position[1] - foreseen->position[1],
                                       now.position[2] - foreseen->position[2]);
        ++m_corrections[std::min(size_t(jump * 1000.0), m_corrections.size() - 1)];
    }
}

/// The body is there from now on, where it was before the step in which it first moved.
void Client::name(const BodyName& name) {
    Tracked& tracked = m_bodies[name.id];
    if (rubble::api().translate_handle(m_world.handle(), name.handle, &tracked.body) != RUBBLE_OK) {
        tracked.body = 0;  // it is gone again
        return;
    }
    m_ids[tracked.body] = name.id;
    const rubble_body_state state = m_world.get_body_state(tracked.body);
    BodyPose pose;
    pose.id = name.id;
    std::copy_n(state.position, 3, pose.position.begin());
    std::copy_n(state.rotation, 4, pose.rotation.begin());
    tracked.track.add(name.step - 1, pose);
}

/// Bodies go where they are after a step, which follows.
void Client::moveBodies(uint64_t step) {
    const double time = double(step);
    std::vector<rubble_body_state> states;
    std::erase_if(m_moving, [&](uint32_t id) {
        Tracked& tracked = m_bodies[id];
        if (!tracked.body) return false;
        const std::optional<BodyPose> pose = tracked.track.at(time);
        if (!pose) return false;
        rubble_body_state state = m_world.get_body_state(tracked.body);
        tracked.track.forgetBefore(time);
        if (state.flags & RUBBLE_BODY_STATIC) return true;
        std::copy(pose->position.begin(), pose->position.end(), state.position);
        std::copy(pose->rotation.begin(), pose->rotation.end(), state.rotation);
        state.flags = pose->isAsleep ? RUBBLE_BODY_ASLEEP : 0;
        states.push_back(state);
        return tracked.track.isAtRest(time);
    });
    m_world.set_body_states(states.data(), uint32_t(states.size()));
}

void Client::apply(const Step& step) {
    m_world.apply_deltas(step.delta.data(), step.delta.size());
    m_applied = step.step;
    forgetDestroyed();
    for (const BodyName& each : step.names) name(each);
}

void Client::forgetDestroyed() {
    const rubble_events events = m_world.get_events();
    for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i) {
        const auto found = m_ids.find(events.bodies_destroyed[i]);
        if (found == m_ids.end()) continue;
        m_bodies.erase(found->second);
        m_moving.erase(found->second);
        m_ids.erase(found);
    }
}

/// What it has does not fit what comes: it is to begin again, as the same player.
void Client::rejoin() {
    m_game = m_received = 0;
    disconnect();
}

void Client::move(const Vec3& velocity) {
    for (size_t i = 0; i < 3; ++i)
        m_input.velocity[i] = int8_t(std::clamp(std::lround(velocity[i] / kPlayerSpeed * 127.0), -127l, 127l));
}

void Client::ask(Tool tool, const Vec3& direction) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (!(length > 0.0)) return;
    Ask ask{tool, {}};
    for (size_t i = 0; i < 3; ++i) ask.direction[i] = int16_t(std::lround(direction[i] / length * 32767.0));
    m_asks.push_back(ask);
}

void Client::send() {
    if (m_state != State::Playing) return m_asks.clear();
    for (const Ask& ask : std::exchange(m_asks, {})) m_transport->send(m_server, Delivery::Reliable, encode(ask));
    if (m_ticks % kStepsPerPoses == 0) m_transport->send(m_server, Delivery::Unreliable, encode(m_input));
}

}  // namespace netplay
