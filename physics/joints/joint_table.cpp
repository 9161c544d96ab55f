#include "physics/joints/joint_table.h"

#include <algorithm>

#include "physics/math/sorted_slots.h"

namespace rubble {
namespace {

std::pair<uint32_t, uint32_t> inOrder(uint32_t a, uint32_t b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
}

}  // namespace

JointProxy& JointTable::add(std::unique_ptr<JointProxy> joint) {
    JointProxy& proxy = *joint;
    const uint32_t slot = proxy.handle.slot();
    if (m_joints.size() <= slot) m_joints.resize(slot + 1);
    m_joints[slot] = std::move(joint);
    ++m_count;
    if (proxy.joint.kind == JointKind::Rope) insertSorted(m_ropes, slot);
    for (const BodyHandle body : proxy.bodies) {
        if (!body) continue;
        if (m_ofBody.size() <= body.slot()) m_ofBody.resize(body.slot() + 1);
        insertSorted(m_ofBody[body.slot()], slot);
    }
    if (!proxy.joint.collides && proxy.objects[0] != JointProxy::kNothing && proxy.objects[1] != JointProxy::kNothing) {
        const auto pair = inOrder(proxy.objects[0], proxy.objects[1]);
        m_nonColliding.insert(std::lower_bound(m_nonColliding.begin(), m_nonColliding.end(), pair), pair);
    }
    return proxy;
}

std::unique_ptr<JointProxy> JointTable::remove(uint32_t slot) {
    if (!at(slot)) return nullptr;
    std::unique_ptr<JointProxy> proxy = std::move(m_joints[slot]);
    --m_count;
    eraseSorted(m_ropes, slot);
    for (const BodyHandle body : proxy->bodies)
        if (body) eraseSorted(m_ofBody[body.slot()], slot);
    const auto pair = inOrder(proxy->objects[0], proxy->objects[1]);
    const auto found = std::lower_bound(m_nonColliding.begin(), m_nonColliding.end(), pair);
    if (!proxy->joint.collides && found != m_nonColliding.end() && *found == pair) m_nonColliding.erase(found);
    return proxy;
}

void JointTable::removeNonColliding(std::vector<ObjectPair>& pairs) const {
    if (m_nonColliding.empty()) return;
    std::erase_if(pairs, [&](const ObjectPair& pair) {
        return std::binary_search(m_nonColliding.begin(), m_nonColliding.end(),
                                  std::pair(pair.first->number, pair.second->number));
    });
}

}  // namespace rubble
