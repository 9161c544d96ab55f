#include "runtime/core/log.h"

#include <cstdio>
#include <mutex>

namespace rubble {
namespace {

void writeToStderr(void*, LogLevel level, std::string_view message) {
    const char* prefix = level == LogLevel::Error ? "error: " : level == LogLevel::Warning ? "warning: " : "";
    std::fprintf(stderr, "rubble: %s%.*s\n", prefix, int(message.size()), message.data());
}

std::mutex g_mutex;
LogSink g_sink = writeToStderr;
void* g_user = nullptr;

}  // namespace

void setLogSink(LogSink sink, void* user) {
    const std::lock_guard lock(g_mutex);
    g_sink = sink ? sink : writeToStderr;
    g_user = sink ? user : nullptr;
}

void log(LogLevel level, std::string_view message) {
    const std::lock_guard lock(g_mutex);
    g_sink(g_user, level, message);
}

}  // namespace rubble
