#pragma once
#include <atomic>
#include <memory>

namespace rubble {

/// A value worked out when first asked for, beside an object that threads share. Any thread may ask; of several that
/// worked it out at once, one is kept, so the value must depend on nothing but the object.
template <class T>
class Lazy {
public:
    Lazy() = default;
    Lazy(const Lazy&) = delete;
    Lazy& operator=(const Lazy&) = delete;
    ~Lazy() { delete m_value.load(std::memory_order_relaxed); }

    /// nullptr if nobody has asked yet.
    const T* find() const { return m_value.load(std::memory_order_acquire); }
    const T& keep(std::unique_ptr<const T> value) {
        const T* expected = nullptr;
        if (m_value.compare_exchange_strong(expected, value.get(), std::memory_order_acq_rel)) return *value.release();
        return *expected;
    }
    /// For the only holder of the object, when it changes.
    void forget() { delete m_value.exchange(nullptr, std::memory_order_relaxed); }

private:
    std::atomic<const T*> m_value = nullptr;
};

}  // namespace rubble
