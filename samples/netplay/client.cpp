#include "samples/netplay/client.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samples/netplay/player.h"

namespace netplay {
namespace {

constexpr int kMaxMessagesPerTick = 4096;
constexpr size_t kMaxEarlyBodies = 8192;                   // that poses tell of before edits have made them
constexpr size_t kMaxGameBytes = 4u << 20;                 // of a snapshot; reading it may take 64 times as much
constexpr size_t kMaxWaitingBytes = 128u << 20;            // of steps that are not shown yet
constexpr uint64_t kMaxStepsAhead = 60 * kStepsPerSecond;  // of poses, of the edits that have come

/// Leaves a server that lies, as tick() and show() leave one whose bytes the library refuses.
void expect(bool holds, const char* what) {
    if (!holds) throw rubble::Error(RUBBLE_ERROR_FILE, what);
}

}  // namespace

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
        m_waitingBytes -= m_steps.front().bytes();
    }
    m_alpha = std::clamp(time + 1.0 - double(m_applied), 0.0, 1.0);
} catch (const rubble::Error&) {
    rejoin();
}

void Client::receive() {
    Event event;
    for (int i = 0; i < kMaxMessagesPerTick && m_transport && m_transport->receive(event); ++i) {
        if (event.kind == Event::Kind::Connected) {
            m_server = event.peer;
            m_transport->send(m_server, Delivery::Reliable, encode(Join{kVersion, m_token, m_game, m_received}));
        } else if (event.kind == Event::Kind::Disconnected) {
            if (m_state != State::Refused) m_state = State::Disconnected;
            m_transport.reset();
        } else {
            ++m_heard;
            const std::optional<Message> message = decode(event.bytes, false);
            expect(message.has_value(), "expected a message of the server");
            handle(*message);
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
    expect(snapshot.game.size() <= kMaxGameBytes, "expected a snapshot of at most 4 MB");
    forget();
    m_world.load_game_data(snapshot.game.data(), snapshot.game.size());
    m_applied = m_received = snapshot.step;
    m_clock = {};
    m_hasSequence = false;
    for (const BodyName& each : snapshot.names) name(each);
    m_state = State::Playing;
    ++m_snapshots;
}

void Client::take(EditSteps message) {
    const uint64_t before = message.last - message.deltas.size();
    expect(m_state == State::Playing && before == m_received, "expected the step behind the last one");
    for (auto& delta : message.deltas) m_steps.push_back({++m_received, std::move(delta), {}});
    for (const BodyName& each : message.names)
        if (each.step > before) m_steps[m_steps.size() - 1 - size_t(message.last - each.step)].names.push_back(each);
    for (size_t i = m_steps.size() - message.deltas.size(); i < m_steps.size(); ++i)
        m_waitingBytes += m_steps[i].bytes();
    expect(m_waitingBytes <= kMaxWaitingBytes, "expected poses, which say that steps can be shown");
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
    if (m_state != State::Playing) return;  // they are of a world that is still to come
    expect(poses.step <= m_received || poses.step - m_received <= kMaxStepsAhead, "expected poses of about now");
    noteSequence(poses.sequence);
    m_clock.hear(poses.step);
    m_players = poses.players;
    for (const BodyPose& pose : poses.bodies) {
        if (poses.step <= m_applied && !m_bodies.contains(pose.id)) continue;  // it is gone by now
        Tracked& tracked = m_bodies[pose.id];
        const auto foreseen = tracked.body ? tracked.track.at(m_clock.now()) : std::nullopt;
        tracked.track.add(poses.step, pose);
        m_moving.insert(pose.id);
        if (!foreseen) continue;
        const BodyPose now = *tracked.track.at(m_clock.now());
        const double jump = std::hypot(now.position[0] - foreseen->position[0], now.position[1] - foreseen->position[1],
                                       now.position[2] - foreseen->position[2]);
        ++m_corrections[size_t(std::min(jump * 1000.0, double(m_corrections.size() - 1)))];
    }
    expect(m_bodies.size() <= m_ids.size() + kMaxEarlyBodies, "expected poses of bodies that edits make");
}

/// The body is there from now on, where it was before the step in which it first moved.
void Client::name(const BodyName& name) {
    rubble_body body = 0;
    const auto known = m_bodies.find(name.id);
    expect(known == m_bodies.end() || !known->second.body, "expected a number for one body");
    if (rubble::api().translate_handle(m_world.handle(), name.handle, &body) != RUBBLE_OK) {  // it is gone again
        m_bodies.erase(name.id);
        m_moving.erase(name.id);
        return;
    }
    expect(m_ids.try_emplace(body, name.id).second, "expected one number for a body");
    Tracked& tracked = m_bodies[name.id];
    tracked.body = body;
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
        if (!tracked.body) {  // edits up to its first pose have not made it: it is gone again
            const bool isLate = tracked.track.firstStep() < step;
            if (isLate) m_bodies.erase(id);
            return isLate;
        }
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

void Client::forget() {
    m_steps.clear(), m_bodies.clear(), m_ids.clear(), m_moving.clear(), m_players.clear();
    m_waitingBytes = 0;
}

/// What it has does not fit what comes: it is to begin again, as the same player.
void Client::rejoin() {
    forget();
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
