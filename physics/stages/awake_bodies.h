#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "physics/bodies/dynamic_body.h"

namespace rubble {

/// Which bodies are awake, and which wait to wake until a budget allows it: that of awake debris, or that of wakes in a
/// step.
class AwakeBodies {
public:
    /// The slots of the awake bodies, ascending.
    const std::vector<uint32_t>& slots() const { return m_slots; }
    /// The largest number of awake debris.
    void setDebrisLimit(size_t limit) { m_debrisLimit = limit; }
    /// How many more bodies may wake until this is set again.
    void setWakes(size_t wakes) { m_wakes = wakes; }
    /// See setWakes().
    size_t wakes() const { return m_wakes; }
    /// Takes a place in the budgets for a body that is about to wake; false: there is none.
    bool takePlace(const DynamicBody& body) {
        if (m_wakes == 0 || (body.isDebris && m_debris >= m_debrisLimit)) return false;
        --m_wakes;
        return true;
    }
    /// Adds a body, which waits no longer; does nothing if it is there already.
    void add(DynamicBody& body);
    /// Removes a body; does nothing if it is not there.
    void remove(const DynamicBody& body);
    /// Lets a sleeping body wait for a place in the budgets; false: it does so already.
    bool wait(DynamicBody& body);
    /// Lets a body wait no longer.
    void forget(DynamicBody& body);
    /// The number of bodies that wait.
    size_t waiting() const { return m_waiting[0].size() + m_waiting[1].size(); }
    /// Calls tryWake(slot), which wakes it or returns false, for waiting bodies, debris last, each in the order of
    /// slots, until one has no place.
    template <class F>
    void wakeWaiting(F&& tryWake) {
        for (std::set<uint32_t>& list : m_waiting)
            while (!list.empty() && tryWake(*list.begin())) {
            }
    }

private:
    std::vector<uint32_t> m_slots;                ///< ascending
    std::array<std::set<uint32_t>, 2> m_waiting;  ///< the second of debris
    size_t m_debris = 0, m_debrisLimit = 0;       ///< awake, and allowed
    size_t m_wakes = 0;
};

}  // namespace rubble
