#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/core/start_thread.h"

namespace rubble {

/// A simple ParallelFor with threads. The calling thread works too, and waits for no thread that has not begun: on a
/// busy machine it does all of the work itself.
class ThreadPool {
public:
    /// Starts threads - 1 workers, or as many as the system gives. `threads`: with the calling thread.
    explicit ThreadPool(int threads) {
        for (int i = 1; i < threads; ++i) {
            std::thread thread = startThread([this] { serve(); });
            if (!thread.joinable()) return;
            m_threads.push_back(std::move(thread));
        }
    }
    ~ThreadPool() {
        {
            const std::lock_guard lock(m_mutex);
            m_isOver = true;
        }
        m_wake.notify_all();
        for (std::thread& thread : m_threads) thread.join();
    }
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Calls body(i) for i in [0, count) on all threads; returns when all calls have returned. Throws what one of them
    /// has thrown; the calls that had not begun then are left out.
    void run(size_t count, const std::function<void(size_t)>& body) {
        {
            const std::lock_guard lock(m_mutex);
            m_body = &body;
            m_left.store(uint64_t(count) << 32);
            m_round.store(m_round + 1);
        }
        m_wake.notify_all();
        work(body, true);
        {
            const std::lock_guard lock(m_mutex);
            m_body = nullptr;  // nobody joins any more
        }
        spinWhile([&] { return m_busy > 0; });
        std::unique_lock lock(m_mutex);
        m_done.wait(lock, [&] { return m_busy == 0; });
        if (m_thrown) std::rethrow_exception(std::exchange(m_thrown, nullptr));
    }

private:
    /// Waits for a short time before a thread sleeps: work comes in bursts, and waking takes longer than most of it. By
    /// the clock, because on a busy machine a single yield() may take as long as a frame.
    template <class Condition>
    static void spinWhile(Condition condition) {
        constexpr auto kLongest = std::chrono::milliseconds(1);
        const auto start = std::chrono::steady_clock::now();
        while (condition() && std::chrono::steady_clock::now() - start < kLongest) std::this_thread::yield();
    }
    /// The calling thread takes the first of the calls that are left, the others the last: where the same items come
    /// again and again, they stay with a thread, in whose cache they are.
    void work(const std::function<void(size_t)>& body, bool fromFront) try {
        for (uint64_t left = m_left;;) {
            const uint64_t from = left & 0xffffffff, to = left >> 32;
            if (from >= to) return;
            if (!m_left.compare_exchange_weak(left, fromFront ? left + 1 : left - (uint64_t(1) << 32))) continue;
            body(fromFront ? from : to - 1);
            left = m_left;
        }
    } catch (...) {
        const std::lock_guard lock(m_mutex);
        if (!m_thrown) m_thrown = std::current_exception();
        m_left = 0;
    }
    void serve() {
        for (uint64_t seen = 0;;) {
            spinWhile([&] { return m_round == seen && !m_isOver; });
            const std::function<void(size_t)>* body;
            {
                std::unique_lock lock(m_mutex);
                m_wake.wait(lock, [&] { return m_round != seen || m_isOver; });
                if (m_isOver) return;
                seen = m_round;
                body = m_body;
                if (!body) continue;
                ++m_busy;
            }
            work(*body, false);
            const std::lock_guard lock(m_mutex);
            if (--m_busy == 0) m_done.notify_one();
        }
    }

    std::mutex m_mutex;
    std::condition_variable m_wake, m_done;
    const std::function<void(size_t)>* m_body = nullptr;  ///< null: there is no work
    std::exception_ptr m_thrown;                          ///< the first
    /// Of the calls that have not begun: the first, and above 32 bits the one after the last.
    std::atomic<uint64_t> m_left = 0;
    std::atomic<size_t> m_busy = 0;  ///< threads that have begun
    std::atomic<uint64_t> m_round = 0;
    std::atomic<bool> m_isOver = false;
    std::vector<std::thread> m_threads;
};

}  // namespace rubble
