// What libFuzzer and driver.cpp call, for fuzzers that need no more than random decisions.
#include "runtime/core/log.h"
#include "tests/fuzz/decisions.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    rubble::setLogSink([](void*, rubble::LogLevel, std::string_view) {}, nullptr);
    rubble::Decisions decisions(data, size);
    rubble::fuzz(decisions);
    return 0;
}
