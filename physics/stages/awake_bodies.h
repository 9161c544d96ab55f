#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
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
    /// Adds a body; does nothing if it is there already.
    void add(const DynamicBody& body);
    /// Removes a body; does nothing if it is not there.
    void remove(const DynamicBody& body);
    /// Lets a sleeping body wait for a place in the budgets.
    void wait(const DynamicBody& body);
    /// The number of bodies that wait; some may have woken or gone meanwhile.
    size_t waiting() const { return m_waiting[0].size() + m_waiting[1].size(); }
    /// Calls f(slot) for bodies that wait, in that order.
    template <class F>
    void forEachWaiting(F&& f) const {
        for (const std::vector<uint32_t>& list : m_waiting)
            for (const uint32_t slot : list) f(slot);
    }
    /// Calls tryWake(slot) for waiting bodies, debris last, each in the order of slots, until it returns false.
    template <class F>
    void wakeWaiting(F&& tryWake) {
        for (std::vector<uint32_t>& list : m_waiting) {
            size_t done = 0;
            while (done < list.size() && tryWake(list[done])) ++done;
            list.erase(list.begin(), list.begin() + std::ptrdiff_t(done));
        }
    }

private:
    std::vector<uint32_t> m_slots;                   ///< ascending
    std::array<std::vector<uint32_t>, 2> m_waiting;  ///< ascending; the second of debris
    size_t m_debris = 0, m_debrisLimit = 0;          ///< awake, and allowed
    size_t m_wakes = 0;
};

}  // namespace rubble
