// Runs a fuzzer without libFuzzer: a number of inputs that follow from a seed, or as many as fit into some seconds.
#include <malloc.h>
#include <sys/resource.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <vector>

#include "runtime/core/random.h"
#include "tests/fuzz/stages.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

using Clock = std::chrono::steady_clock;

unsigned long long seed = 1, first = 0, inputs = 1000, seconds = 0, input = 0;

void sayInput() {
    std::fprintf(stderr, "input %llu of seed %llu: repeat it with --seed %llu --first %llu --inputs 1\n", input, seed,
                 seed, input);
}

void onAbort(int) {
    sayInput();
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
}

long peakMib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss >> 10;
}

/// How fast it goes, in processor time, and which input is the slowest.
class Progress {
public:
    void begin() { m_inputStart = std::clock(); }
    void end() {
        const std::clock_t took = std::clock() - m_inputStart;
        if (took > m_slowest) m_slowest = took, m_slowestInput = input;
        const auto now = Clock::now();
        if (now - m_lastLine > std::chrono::seconds(10)) print(), m_lastLine = now;
    }
    /// Whether the seconds that it may take are over.
    bool isOver() const { return seconds > 0 && Clock::now() - m_start > std::chrono::seconds(seconds); }
    /// Says it.
    void print() const {
        const unsigned long long done = input - first;
        std::printf("%s: %llu inputs of seed %llu, from %llu on; %.0f a second; the slowest: %llu, %.0f ms; %ld MiB\n",
                    program_invocation_short_name, done, seed, first,
                    double(done) * CLOCKS_PER_SEC / double(std::clock()), m_slowestInput,
                    1e3 * double(m_slowest) / CLOCKS_PER_SEC, peakMib());
        std::fflush(stdout);
    }

private:
    Clock::time_point m_start = Clock::now(), m_lastLine = m_start;
    std::clock_t m_inputStart = 0, m_slowest = 0;
    unsigned long long m_slowestInput = 0;
};

}  // namespace

// Called by the sanitizers when they have found something.
extern "C" void __asan_on_error() {
    sayInput();
}
extern "C" void __ubsan_on_report() {
    sayInput();
}
// Freed memory is kept from use for a short time only, so that the processor's caches hold it; no input needs much.
extern "C" const char* __asan_default_options() {
    return "quarantine_size_mb=8:malloc_context_size=6:max_allocation_size_mb=1024:detect_container_overflow=1";
}

int main(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view name = argv[i];
        unsigned long long& value = name == "--seed"      ? seed
                                    : name == "--first"   ? first
                                    : name == "--seconds" ? seconds
                                                          : inputs;
        value = std::strtoull(argv[i + 1], nullptr, 10);
    }
    if (seconds > 0) inputs = ~0ull;
    // Freed memory is kept: worlds come and go with each input, and new pages would cost a fifth of the time.
    mallopt(M_MMAP_THRESHOLD, 32 << 20), mallopt(M_TRIM_THRESHOLD, 1 << 30), mallopt(M_TOP_PAD, 16 << 20);
    std::signal(SIGABRT, onAbort);
    Progress progress;
    for (input = first; input - first < inputs && !progress.isOver(); ++input) {
        rubble::Random random(seed, input);
        std::vector<uint8_t> bytes(random.below(64));
        for (uint8_t& byte : bytes) byte = uint8_t(random.below(256));
        for (int i = 0; i < 8; ++i) bytes.push_back(uint8_t(input >> 8 * i));  // no two inputs are equal
        progress.begin();
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        progress.end();
    }
    progress.print();
    std::fputs(rubble::stageReport(input - first).c_str(), stdout);
    return 0;
}
