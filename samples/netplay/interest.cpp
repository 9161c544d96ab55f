#include "samples/netplay/interest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netplay {
namespace {

/// How much priority a body gains in a message: its speed as seen from there, and a little for what stands still.
double urgency(const TrackedBody& body, const Vec3& viewer) {
    const double distance = std::hypot(body.pose.position[0] - viewer[0], body.pose.position[1] - viewer[1],
                                       body.pose.position[2] - viewer[2]);
    return (0.5 + std::min(body.speed, 20.0)) / (5.0 + distance);
}

}  // namespace

void Interest::restart(const BodyTable& bodies) {
    m_priorities.clear();
    for (Packet& packet : m_packets) packet.bodies.clear();
    for (const uint32_t id : bodies.all()) m_priorities[id] = 0.0;
}

void Interest::follow(const BodyTable& bodies) {
    for (const uint32_t id : bodies.moved()) m_priorities.try_emplace(id, 0.0);
}

std::vector<BodyPose> Interest::choose(const BodyTable& bodies, const Vec3& viewer, size_t count, uint16_t sequence) {
    std::vector<std::pair<double, const TrackedBody*>> order;
    for (auto entry = m_priorities.begin(); entry != m_priorities.end();) {
        const TrackedBody* body = bodies.find(entry->first);
        if (!body) {
            entry = m_priorities.erase(entry);
            continue;
        }
        entry->second += urgency(*body, viewer);
        order.emplace_back(entry->second, body);
        ++entry;
    }
    const auto isMoreUrgent = [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second->pose.id < b.second->pose.id;
    };
    if (order.size() > count) {
        std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(), isMoreUrgent);
        order.resize(count);
    }
    std::sort(order.begin(), order.end(),
              [](const auto& a, const auto& b) { return a.second->pose.id < b.second->pose.id; });
    Packet& packet = m_packets[sequence % m_packets.size()];
    packet = {sequence, {}};
    std::vector<BodyPose> out;
    for (const auto& [priority, body] : order) {
        m_priorities[body->pose.id] = 0.0;
        packet.bodies.push_back({body->pose.id, body->movedStep});
        out.push_back(body->pose);
    }
    return out;
}

void Interest::acknowledge(const BodyTable& bodies, uint16_t sequence) {
    Packet& packet = m_packets[sequence % m_packets.size()];
    if (packet.sequence != sequence) return;
    for (const Sent& sent : std::exchange(packet.bodies, {})) {
        const TrackedBody* body = bodies.find(sent.id);
        if (!body || body->movedStep == sent.movedStep) m_priorities.erase(sent.id);
    }
}

void Interest::acknowledge(const BodyTable& bodies, uint16_t newest, uint32_t older) {
    acknowledge(bodies, newest);
    for (uint16_t i = 0; i < 32; ++i)
        if (older >> i & 1) acknowledge(bodies, uint16_t(newest - 1 - i));
}

}  // namespace netplay
