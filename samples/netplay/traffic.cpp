#include "samples/netplay/traffic.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace netplay {

constexpr size_t kHeader = 40, kDatagram = 1300;

void Traffic::add(size_t kind, size_t bytes) {
    const size_t headers = (bytes / kDatagram + 1) * kHeader;
    m_bytes[kind] += bytes;
    m_headers += headers;
    m_thisSecond += bytes + headers;
}

void Traffic::endSecond() {
    m_seconds.push_back(std::exchange(m_thisSecond, 0));
}

uint64_t Traffic::medianSecond() const {
    std::vector<uint64_t> sorted = m_seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[sorted.size() / 2];
}

uint64_t Traffic::highestSecond() const {
    return m_seconds.empty() ? 0 : *std::max_element(m_seconds.begin(), m_seconds.end());
}

std::string Traffic::table() const {
    const double all = double(std::accumulate(m_bytes.begin(), m_bytes.end(), m_headers));
    const double seconds = double(std::max<size_t>(m_seconds.size(), 1));
    std::string out = fmt::format("{:<10}{:>12}{:>8}\n", "kind", "bytes/s", "part");
    const auto addLine = [&](const char* name, uint64_t bytes) {
        if (bytes)
            out +=
                fmt::format("{:<10}{:>12.0f}{:>7.1f}%\n", name, double(bytes) / seconds, 100.0 * double(bytes) / all);
    };
    for (size_t kind = 0; kind < kKinds; ++kind) addLine(kKindNames[kind], m_bytes[kind]);
    addLine("headers", m_headers);
    out += fmt::format("{:<10}{:>12.0f}   median second {}, highest {}\n", "all", all / seconds, medianSecond(),
                       highestSecond());
    return out;
}

}  // namespace netplay
