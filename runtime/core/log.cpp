#include "runtime/core/log.h"

#include <condition_variable>
#include <cstdio>
#include <deque>
#include <mutex>
#include <new>
#include <string>
#include <thread>

namespace rubble {
namespace {

void writeToStderr(void*, LogLevel level, std::string_view message) {
    const char* prefix = level == LogLevel::Error ? "error: " : level == LogLevel::Warning ? "warning: " : "";
    std::fprintf(stderr, "rubble: %s%.*s\n", prefix, int(message.size()), message.data());
}

struct Message {
    LogLevel level;
    std::string text;
};

/// The sink, and what waits while a thread is in it. No thread waits for the sink of another one, so that a sink may
/// wait for a thread that logs.
class Log {
public:
    void setSink(LogSink sink, void* user) {
        std::unique_lock lock(m_mutex);
        if (m_inSink != std::this_thread::get_id()) m_idle.wait(lock, [&] { return m_inSink == std::thread::id(); });
        m_sink = sink ? sink : writeToStderr;
        m_user = sink ? user : nullptr;
    }

    void send(LogLevel level, std::string_view text) {
        std::unique_lock lock(m_mutex);
        if (m_inSink == std::this_thread::get_id()) return writeToStderr(nullptr, level, text);
        if (m_inSink != std::thread::id()) return keep(level, text);
        m_inSink = std::this_thread::get_id();
        const Leave leave{*this, lock};
        deliver(lock, level, text);
        while (!m_waiting.empty()) {
            const Message next = std::move(m_waiting.front());
            m_waiting.pop_front();
            deliver(lock, next.level, next.text);
        }
    }

private:
    struct Leave {
        Log& log;
        std::unique_lock<std::mutex>& lock;
        ~Leave() {
            if (!lock.owns_lock()) lock.lock();  // the sink has thrown
            log.m_inSink = std::thread::id();
            log.m_idle.notify_all();
        }
    };
    void keep(LogLevel level, std::string_view text) try {
        m_waiting.push_back({level, std::string(text)});
    } catch (const std::bad_alloc&) {
        writeToStderr(nullptr, level, text);
    }
    void deliver(std::unique_lock<std::mutex>& lock, LogLevel level, std::string_view text) {
        const LogSink sink = m_sink;
        void* const user = m_user;
        lock.unlock();
        sink(user, level, text);
        lock.lock();
    }

    std::mutex m_mutex;
    std::condition_variable m_idle;
    LogSink m_sink = writeToStderr;
    void* m_user = nullptr;
    std::thread::id m_inSink;  ///< the thread that calls the sink; none: no thread does
    std::deque<Message> m_waiting;
};

/// Never destroyed: threads may log while the process ends.
Log& theLog() {
    static Log& log = *new Log;
    return log;
}

}  // namespace

void setLogSink(LogSink sink, void* user) {
    theLog().setSink(sink, user);
}

static thread_local LogScope* t_scope = nullptr;

LogScope::LogScope(LogSink sink, void* user) : m_outer(t_scope), m_sink(sink), m_user(user) {
    t_scope = this;
}

LogScope::~LogScope() {
    t_scope = m_outer;
}

void log(LogLevel level, std::string_view message) {
    LogScope* scope = t_scope;
    if (!scope) return theLog().send(level, message);
    if (scope->m_inSink) return writeToStderr(nullptr, level, message);
    scope->m_inSink = true;
    try {
        scope->m_sink(scope->m_user, level, message);
    } catch (...) {
        scope->m_inSink = false;
        throw;
    }
    scope->m_inSink = false;
}

}  // namespace rubble
