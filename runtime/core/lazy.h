#pragma once
#include <atomic>
#include <memory>

namespace rubble {

/// A value that is computed on first use and cached in an object that several threads share. Two threads may compute it
/// at the same time: the first result is kept, the other one dropped. The value must depend on the object alone.
template <class T>
class Lazy {
public:
    Lazy() = default;
    Lazy(const Lazy&) = delete;
    Lazy& operator=(const Lazy&) = delete;
    ~Lazy() { delete m_value.load(std::memory_order_relaxed); }

    /// [any-thread] The cached value; nullptr if keep() was not called yet.
    const T* find() const { return m_value.load(std::memory_order_acquire); }
    /// [any-thread] Caches a value unless there is one already. Returns the cached one.
    const T& keep(std::unique_ptr<const T> value) {
        const T* expected = nullptr;
        if (m_value.compare_exchange_strong(expected, value.get(), std::memory_order_acq_rel)) return *value.release();
        return *expected;
    }
    /// Drops the value, when the object changes. Only for a thread that holds the object alone.
    void forget() { delete m_value.exchange(nullptr, std::memory_order_relaxed); }

private:
    std::atomic<const T*> m_value = nullptr;
};

}  // namespace rubble
