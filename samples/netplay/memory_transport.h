#pragma once
#include <memory>

#include "samples/netplay/transport.h"

namespace netplay {

/// Connections within one program, for tests and benchmarks: what is sent has arrived, in order.
class MemoryNetwork {
public:
    /// A network without ends.
    MemoryNetwork();
    ~MemoryNetwork();
    /// The one that others connect to; to be called once.
    std::unique_ptr<Transport> listen();
    /// Another end; the network must outlive it.
    std::unique_ptr<Transport> connect();

private:
    struct State;
    class End;
    std::shared_ptr<State> m_state;
};

}  // namespace netplay
