#include "samples/netplay/link_conditioner.h"

#include <algorithm>
#include <utility>

namespace netplay {

constexpr size_t kDatagram = 1300;  // bytes of a message in one

LinkConditioner::LinkConditioner(std::unique_ptr<Transport> inner, const LinkSettings& settings)
    : m_inner(std::move(inner)), m_settings(settings), m_random(settings.seed) {}

bool LinkConditioner::receive(Event& event) {
    if (!m_inner->receive(event)) return false;
    if (event.kind == Event::Kind::Disconnected) m_reliable.erase(event.peer), m_unreliable.erase(event.peer);
    return true;
}

bool LinkConditioner::isLost() {
    const bool lost = double(m_random()) < m_settings.loss * 4294967296.0;
    m_lost += lost;
    return lost;
}

uint64_t LinkConditioner::delayOf(size_t bytes) {
    uint64_t longest = 0;
    for (size_t datagrams = bytes / kDatagram + 1; datagrams-- > 0;) {
        uint64_t delay = uint64_t(m_settings.delay);
        while (isLost()) delay += 2 * uint64_t(m_settings.delay) + 2;
        longest = std::max(longest, delay);
    }
    return longest;
}

void LinkConditioner::send(Peer peer, Delivery delivery, std::span<const uint8_t> bytes) {
    if (delivery == Delivery::Unreliable && isLost()) return;
    const bool isReliable = delivery == Delivery::Reliable;
    auto& queue = (isReliable ? m_reliable : m_unreliable)[peer];
    uint64_t due = m_step + (isReliable ? delayOf(bytes.size()) : uint64_t(m_settings.delay));
    if (!queue.empty()) due = std::max(due, queue.back().due);
    queue.push_back({due, delivery, false, {bytes.begin(), bytes.end()}});
}

void LinkConditioner::drop(Peer peer) {
    auto& queue = m_reliable[peer];
    queue.push_back({queue.empty() ? m_step : queue.back().due, Delivery::Reliable, true, {}});
}

void LinkConditioner::handOver(Peer peer, const Waiting& message) {
    if (message.drops)
        m_inner->drop(peer);
    else
        m_inner->send(peer, message.delivery, message.bytes);
}

void LinkConditioner::release() {
    for (auto* queues : {&m_reliable, &m_unreliable})
        for (auto& [peer, queue] : *queues)
            for (; !queue.empty() && queue.front().due <= m_step; queue.pop_front()) handOver(peer, queue.front());
}

void LinkConditioner::tick() {
    release();
    ++m_step;
    m_inner->tick();
}

}  // namespace netplay
