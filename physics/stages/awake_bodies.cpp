#include "physics/stages/awake_bodies.h"

#include "physics/math/sorted_slots.h"

namespace rubble {

void AwakeBodies::add(const DynamicBody& body) {
    m_debris += insertSorted(m_slots, body.handle().slot()) && body.isDebris;
}

void AwakeBodies::remove(const DynamicBody& body) {
    m_debris -= eraseSorted(m_slots, body.handle().slot()) && body.isDebris;
}

void AwakeBodies::wait(const DynamicBody& body) {
    insertSorted(m_waiting[body.isDebris], body.handle().slot());
}

}  // namespace rubble
