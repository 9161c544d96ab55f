#include "physics/stages/awake_bodies.h"

#include <utility>

#include "physics/math/sorted_slots.h"

namespace rubble {

void AwakeBodies::add(DynamicBody& body) {
    forget(body);
    m_debris += insertSorted(m_slots, body.handle().slot()) && body.isDebris;
}

void AwakeBodies::remove(const DynamicBody& body) {
    m_debris -= eraseSorted(m_slots, body.handle().slot()) && body.isDebris;
}

bool AwakeBodies::wait(DynamicBody& body) {
    if (std::exchange(body.waits, true)) return false;
    m_waiting[body.isDebris].insert(body.handle().slot());
    return true;
}

void AwakeBodies::forget(DynamicBody& body) {
    if (std::exchange(body.waits, false)) m_waiting[body.isDebris].erase(body.handle().slot());
}

}  // namespace rubble
