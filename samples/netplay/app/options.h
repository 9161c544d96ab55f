#pragma once
#include <memory>
#include <string>

#include "samples/netplay/app/screen.h"
#include "samples/netplay/protocol.h"
#include "samples/netplay/transport.h"

namespace netplay {

/// What `./rubble netplay` was asked to do.
struct Options {
    bool isServer = false;
    std::string host, level;
    uint16_t port = kPort;
    int rows = 2, bots = 0, seconds = 0, latency = 0, frames = 0;
    double loss = 0.0;
    Size size;
    std::string preset = "fast", out = "out/netplay";
};

/// A new connection to the server, over a link as bad as the options say. Throws std::runtime_error if there is no such
/// host.
std::unique_ptr<Transport> connectTo(const Options& options, uint32_t seed);
/// A transport over a link with the options' latency and loss; itself if they ask for none. seed: of what is lost.
std::unique_ptr<Transport> overLink(std::unique_ptr<Transport> transport, const Options& options, uint32_t seed);

}  // namespace netplay
