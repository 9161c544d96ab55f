#pragma once
#include <memory>
#include <string>

#include "samples/netplay/transport.h"

namespace netplay {

/// Listens on a UDP port of all addresses. Throws std::runtime_error if it is taken. Connects that are not confirmed
/// yet take none of the places of `peers`. port 0: any, see portOf().
/// patient: no connection ends because its other end has not answered in time, for tests on loaded machines.
std::unique_ptr<Transport> listenWithEnet(uint16_t port, size_t peers, bool patient = false);
/// Connects to a server; Event::Kind::Connected says when, Disconnected that it does not answer. Throws
/// std::runtime_error if there is no such host.
std::unique_ptr<Transport> connectWithEnet(const std::string& host, uint16_t port, bool patient = false);
/// The port of a transport of listenWithEnet().
uint16_t portOf(const Transport& listening);
/// Bytes that a transport of this file has sent and got, with the headers of ENet and UDP.
uint64_t bytesOnWire(const Transport& transport);

}  // namespace netplay
