// Runs a fuzzer without libFuzzer: a number of inputs that follow from a seed.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "runtime/core/random.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

unsigned long long seed = 1, first = 0, input = 0;

void sayInput() {
    std::fprintf(stderr, "input %llu of seed %llu: repeat it with --seed %llu --first %llu --inputs 1\n", input, seed,
                 seed, input);
}

void onAbort(int) {
    sayInput();
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
}

}  // namespace

// Called by the sanitizers when they have found something.
extern "C" void __asan_on_error() {
    sayInput();
}
extern "C" void __ubsan_on_report() {
    sayInput();
}

int main(int argc, char** argv) {
    unsigned long long inputs = 1000;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view name = argv[i];
        unsigned long long& value = name == "--seed" ? seed : name == "--first" ? first : inputs;
        value = std::strtoull(argv[i + 1], nullptr, 10);
    }
    std::signal(SIGABRT, onAbort);
    for (input = first; input < first + inputs; ++input) {
        rubble::Random random(seed, input);
        std::vector<uint8_t> bytes(random.below(64));
        for (uint8_t& byte : bytes) byte = uint8_t(random.below(256));
        for (int i = 0; i < 8; ++i) bytes.push_back(uint8_t(input >> 8 * i));  // no two inputs are equal
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::printf("%llu inputs of seed %llu, from %llu on\n", inputs, seed, first);
    return 0;
}
