#include "samples/netplay/app/options.h"

#include "samples/netplay/enet_transport.h"
#include "samples/netplay/link_conditioner.h"

namespace netplay {

std::unique_ptr<Transport> overLink(std::unique_ptr<Transport> transport, const Options& options, uint32_t seed) {
    if (options.latency == 0 && options.loss == 0.0) return transport;
    const int delay = options.latency * kStepsPerSecond / 1000;
    return std::make_unique<LinkConditioner>(std::move(transport), LinkSettings{delay, options.loss / 100.0, seed});
}

std::unique_ptr<Transport> connectTo(const Options& options, uint32_t seed) {
    return overLink(connectWithEnet(options.host, options.port), options, seed);
}

}  // namespace netplay
