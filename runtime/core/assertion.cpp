#include "runtime/core/assertion.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace rubble {
namespace {

std::atomic<AssertionHandler> g_handler = nullptr;

}  // namespace

void setAssertionHandler(AssertionHandler handler) {
    g_handler = handler;
}

void failAssertion(const char* condition, const char* file, int line) {
    while (std::strncmp(file, "../", 3) == 0) file += 3;  // the compiler names files from its build folder on
    char message[512];                                    // no memory is taken: there may be none
    std::snprintf(message, sizeof message, "%s:%d: assertion failed: %s", file, line, condition);
    if (const AssertionHandler handler = g_handler) handler(message);
    std::fprintf(stderr, "rubble: %s\n", message);
    std::abort();
}

}  // namespace rubble
