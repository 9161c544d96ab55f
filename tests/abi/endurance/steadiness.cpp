#include "tests/abi/endurance/steadiness.h"

#include <fmt/format.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <utility>

#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

constexpr int kParts = 12;
constexpr double kMiB = 1024.0 * 1024.0;
constexpr double kLargestGrowth = 0.05;
constexpr double kResidentSlack = 8.0 * kMiB;  ///< what malloc may keep

double processorMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

}  // namespace

size_t residentBytes() {
    size_t total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    return resident * size_t(sysconf(_SC_PAGESIZE));
}

Steadiness::Steadiness(int steps, std::string unit)
    : m_steps(steps), m_unit(std::move(unit)), m_start(processorMilliseconds()), m_allocations(allocationCount()) {
    m_parts.reserve(kParts);
    fmt::print("| {:>9} | ms each | new each | bodies | in use KiB | resident MiB |\n", m_unit);
}

void Steadiness::endStep(size_t liveBodies) {
    const int size = m_steps / kParts;
    m_sum.bodies += double(liveBodies) / size;
    m_sum.bytes += double(allocatedBytes()) / size;
    if (++m_done % size) return;
    m_sum.milliseconds = (processorMilliseconds() - m_start) / size;
    m_sum.allocations = double(allocationCount() - m_allocations) / size;
    m_sum.resident = double(residentBytes());
    fmt::print("| {:9} | {:7.3f} | {:8.2f} | {:6.1f} | {:10.1f} | {:12.1f} |\n", m_done, m_sum.milliseconds,
               m_sum.allocations, m_sum.bodies, m_sum.bytes / 1024.0, m_sum.resident / kMiB);
    std::fflush(stdout);
    if (m_parts.size() < kParts) m_parts.push_back(m_sum);
    m_sum = {};
    m_start = processorMilliseconds();
    m_allocations = allocationCount();
}

Steadiness::Part Steadiness::mean(size_t begin, size_t end) const {
    Part out;
    const auto add = [&](double Part::*member) {
        for (size_t i = begin; i < end; ++i) out.*member += m_parts.at(i).*member / double(end - begin);
    };
    for (double Part::*each : {&Part::milliseconds, &Part::allocations, &Part::bodies, &Part::bytes, &Part::resident})
        add(each);
    return out;
}

int Steadiness::finish(bool timed) const {
    const Part second = mean(3, 6), last = mean(9, 12);
    int failures = 0;
    const auto compare = [&](const char* what, double before, double after, double slack) {
        const double growth = before > 0.0 ? after / before - 1.0 : 0.0;
        const bool isSteady = after <= before * (1.0 + kLargestGrowth) + slack;
        fmt::print("{}: {:+.2f} % from the second quarter to the last{}\n", what, 100.0 * growth,
                   isSteady ? "" : ": FAILED, expected 5 % at most");
        if (!isSteady) ++failures;
    };
    compare("memory in use", second.bytes, last.bytes, 0.0);
    compare("resident memory", second.resident, last.resident, kResidentSlack);
    compare("calls of operator new", second.allocations, last.allocations, 1.0);
    compare("bodies", second.bodies, last.bodies, 0.5);
    if (timed) compare("processor time", second.milliseconds, last.milliseconds, 0.0);
    return failures ? 1 : 0;
}

}  // namespace rubble
