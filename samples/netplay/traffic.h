#pragma once
#include <array>
#include <string>
#include <vector>

#include "samples/netplay/protocol.h"

namespace netplay {

/// Counts the bytes of messages by their kind, and of each second. Headers are counted as 40 bytes a datagram: those of
/// IP, UDP and ENet.
class Traffic {
public:
    /// A message of a kind, the index into Message.
    void add(size_t kind, size_t bytes);
    /// Ends a second.
    void endSecond();
    /// Bytes with headers of the median second; 0 without one.
    uint64_t medianSecond() const;
    /// The same of the second that had the most.
    uint64_t highestSecond() const;
    /// Bytes of a kind, without headers.
    uint64_t bytesOf(size_t kind) const { return m_bytes[kind]; }
    /// A line for each kind that there was, and one for the headers: bytes a second and part of all.
    std::string table() const;

private:
    std::array<uint64_t, kKinds> m_bytes{};
    uint64_t m_headers = 0;
    uint64_t m_thisSecond = 0;
    std::vector<uint64_t> m_seconds;
};

}  // namespace netplay
