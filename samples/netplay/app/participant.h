#pragma once
#include <rubble/rubble.hpp>
#include <string>

#include "samples/netplay/app/options.h"
#include "samples/netplay/client.h"

namespace netplay {

/// A client with its world, which connects again where it has lost the server.
class Participant {
public:
    /// How it is with its server. Lost: it had played, and tries again.
    enum class Link : uint8_t { Connecting, Playing, Lost, NoAnswer, Refused };

    /// seed: of the link, unlike that of others.
    Participant(const Options& options, const rubble_world_settings& settings, uint32_t seed)
        : world(settings), m_options(options), m_seed(seed) {}

    /// One step, with a new connection each second while there is none. Says on standard error what becomes of it.
    Link tick(int64_t step);
    /// What the last tick() came to.
    Link link() const { return m_link; }
    /// Of the link, for a player to read.
    std::string words() const;

    rubble::World world;
    Client client{world};

private:
    void become(Link link);
    uint64_t patience() const;

    const Options& m_options;
    uint32_t m_seed;
    uint64_t m_silent = 0;  ///< steps since the server was last heard, or first called
    Link m_link = Link::Connecting;
};

}  // namespace netplay
