#pragma once
#include <string_view>

namespace rubble {

enum class LogLevel { Info, Warning, Error };

/// Receives every message of the library. Called from any thread, one message at a time.
using LogSink = void (*)(void* user, LogLevel level, std::string_view message);

/// [any-thread] Where messages go; a null sink restores the default (stderr).
void setLogSink(LogSink sink, void* user);
/// [any-thread]
void log(LogLevel level, std::string_view message);
inline void logInfo(std::string_view message) {
    log(LogLevel::Info, message);
}
inline void logWarning(std::string_view message) {
    log(LogLevel::Warning, message);
}
inline void logError(std::string_view message) {
    log(LogLevel::Error, message);
}

}  // namespace rubble
