#pragma once
#include <string_view>

namespace rubble {

enum class LogLevel { Info, Warning, Error };

/// Receives every message of the library. Called from any thread, one message at a time. It may log itself, which goes
/// to stderr, and set another sink.
using LogSink = void (*)(void* user, LogLevel level, std::string_view message);

/// [any-thread] Sends all later messages to `sink` with `user`, and waits until no other thread is in the sink before.
/// A null sink restores the default (stderr).
void setLogSink(LogSink sink, void* user);
/// While it lives, what its thread logs goes to this sink instead; what the sink logs goes to stderr. Scopes nest.
class LogScope {
public:
    /// Begins; `user` is for the sink.
    LogScope(LogSink sink, void* user);
    ~LogScope();
    LogScope(const LogScope&) = delete;
    LogScope& operator=(const LogScope&) = delete;

private:
    friend void log(LogLevel level, std::string_view message);
    LogScope* m_outer;
    LogSink m_sink;
    void* m_user;
    bool m_inSink = false;
};
/// [any-thread] Sends a message to the sink. The message says what was expected, what was found and where. If another
/// thread is in the sink, that one hands the message over after its own.
void log(LogLevel level, std::string_view message);
/// [any-thread] log() at level Info.
inline void logInfo(std::string_view message) {
    log(LogLevel::Info, message);
}
/// [any-thread] log() at level Warning: the library goes on without what the message names.
inline void logWarning(std::string_view message) {
    log(LogLevel::Warning, message);
}
/// [any-thread] log() at level Error: an operation failed.
inline void logError(std::string_view message) {
    log(LogLevel::Error, message);
}

}  // namespace rubble
