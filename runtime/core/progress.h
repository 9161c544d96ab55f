#pragma once
#include <atomic>

namespace rubble {

/// While it lives, the work of its thread says in `to` how far it is: 0 to 1. Scopes do not nest.
class ProgressScope {
public:
    /// Begins; `to` must outlive it.
    explicit ProgressScope(std::atomic<double>& to) { current() = &to; }
    ~ProgressScope() { current() = nullptr; }
    ProgressScope(const ProgressScope&) = delete;
    ProgressScope& operator=(const ProgressScope&) = delete;

    /// What this thread's work reports to; null: nobody asks.
    static std::atomic<double>*& current() {
        thread_local std::atomic<double>* to = nullptr;
        return to;
    }
};

/// [any-thread] Says how far the work of this thread is; costs nothing where nobody asks.
inline void reportProgress(double share) {
    if (std::atomic<double>* to = ProgressScope::current()) to->store(share, std::memory_order_relaxed);
}

}  // namespace rubble
