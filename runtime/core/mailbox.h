#pragma once
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <optional>
#include <vector>

namespace rubble {

/// An unbounded queue from one thread to another. Values are moved in and out; nothing else is shared.
template <class T>
class Mailbox {
public:
    /// [any-thread] Appends a value. A value posted after close() is dropped.
    void post(T value) {
        {
            const std::lock_guard lock(m_mutex);
            if (m_closed) return;
            m_values.push_back(std::move(value));
        }
        m_ready.notify_one();
    }
    /// [any-thread] Removes the oldest value; none if the queue is empty.
    std::optional<T> tryTake() {
        const std::lock_guard lock(m_mutex);
        return pop();
    }
    /// [any-thread] Removes all values, oldest first, in one step: no other reader gets one from between them.
    std::vector<T> takeAll() {
        const std::lock_guard lock(m_mutex);
        std::vector<T> values(std::make_move_iterator(m_values.begin()), std::make_move_iterator(m_values.end()));
        m_values.clear();
        return values;
    }
    /// [any-thread] Waits for a value and removes it. None once the queue is closed and empty.
    std::optional<T> take() {
        std::unique_lock lock(m_mutex);
        m_ready.wait(lock, [&] { return m_closed || !m_values.empty(); });
        return pop();
    }
    /// [any-thread] Accepts no more values and wakes all threads that wait in take().
    void close() {
        {
            const std::lock_guard lock(m_mutex);
            m_closed = true;
        }
        m_ready.notify_all();
    }
    /// [any-thread] Values in the queue now.
    size_t size() const {
        const std::lock_guard lock(m_mutex);
        return m_values.size();
    }

private:
    std::optional<T> pop() {
        if (m_values.empty()) return std::nullopt;
        std::optional<T> value(std::move(m_values.front()));
        m_values.pop_front();
        return value;
    }
    mutable std::mutex m_mutex;
    std::condition_variable m_ready;
    std::deque<T> m_values;
    bool m_closed = false;
};

}  // namespace rubble
