#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/bodies/dynamic_body.h"

namespace rubble {

/// Which bodies are awake, and which debris waits to wake until the budget of awake debris allows it.
class AwakeBodies {
public:
    /// The slots of the awake bodies, ascending.
    const std::vector<uint32_t>& slots() const { return m_slots; }
    /// The largest number of awake debris.
    void setDebrisLimit(size_t limit) { m_debrisLimit = limit; }
    /// Whether the budget has a place for this body; always true if it is not debris.
    bool mayWake(const DynamicBody& body) const { return !body.isDebris || m_debris < m_debrisLimit; }
    /// Adds a body; does nothing if it is there already.
    void add(const DynamicBody& body);
    /// Removes a body; does nothing if it is not there.
    void remove(const DynamicBody& body);
    /// Lets a sleeping body wait for a place in the budget.
    void wait(uint32_t slot);
    /// Calls wake(slot) for waiting bodies, in the order of slots, while there are places.
    template <class F>
    void wakeWaiting(F&& wake) {
        size_t done = 0;
        for (; done < m_waiting.size() && m_debris < m_debrisLimit; ++done) wake(m_waiting[done]);
        m_waiting.erase(m_waiting.begin(), m_waiting.begin() + std::ptrdiff_t(done));
    }

private:
    std::vector<uint32_t> m_slots, m_waiting;  ///< ascending
    size_t m_debris = 0, m_debrisLimit = 0;    ///< awake, and allowed
};

}  // namespace rubble
