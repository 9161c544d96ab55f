#include "samples/netplay/app/participant.h"

#include <fmt/format.h>

namespace netplay {
namespace {

constexpr uint64_t kPatience = 5 * kStepsPerSecond;  // that a server may say nothing, on a link without latency

}  // namespace

Participant::Link Participant::tick(int64_t step) {
    if (client.state() == Client::State::Disconnected && step % kStepsPerSecond == 0)
        client.connect(connectTo(m_options, m_seed += 1000));
    const uint64_t before = client.heard();
    client.tick();
    m_silent = client.heard() == before ? m_silent + 1 : 0;
    const bool isPlaying = client.state() == Client::State::Playing;
    if (client.state() == Client::State::Refused) {
        become(Link::Refused);
    } else if (isPlaying && m_silent <= patience()) {
        become(Link::Playing);
    } else if (m_link == Link::Playing) {
        client.disconnect();
        m_silent = 0;
        become(Link::Lost);
    } else if (m_silent > patience()) {
        become(Link::NoAnswer);
    }
    return m_link;
}

uint64_t Participant::patience() const {
    return kPatience + 4 * uint64_t(m_options.latency) * kStepsPerSecond / 1000;
}

void Participant::become(Link link) {
    if (link == m_link) return;
    m_link = link;
    if (link != Link::Playing) fmt::print(stderr, "netplay: {}\n", words());
}

std::string Participant::words() const {
    const std::string server = fmt::format("{}:{}", m_options.host, m_options.port);
    switch (m_link) {
        case Link::Connecting:
            return "no answer from " + server + " yet";
        case Link::Playing:
            return "";
        case Link::Lost:
            return "connection lost to " + server + "; trying again";
        case Link::NoAnswer:
            return "no answer from " + server + "; is there a server (./rubble netplay --server)?";
        case Link::Refused:
            return server + " has refused: it is full, or of another version";
    }
    return "";
}

}  // namespace netplay
