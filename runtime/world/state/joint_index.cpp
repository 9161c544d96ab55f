#include "runtime/world/state/joint_index.h"

#include <algorithm>

namespace rubble {
namespace {

bool isBefore(JointHandle a, JointHandle b) {
    return a.slot() < b.slot();
}

void insert(std::vector<JointHandle>& list, JointHandle handle) {
    list.insert(std::lower_bound(list.begin(), list.end(), handle, isBefore), handle);
}

bool winds(const Joint& joint) {
    return joint.kind == JointKind::Rope && joint.motor.mode != MotorMode::Off;
}

bool turns(const Joint& joint) {
    return joint.kind == JointKind::Wheel && joint.steer != joint.steerTarget;
}

}  // namespace

void JointIndex::add(JointHandle handle, const Joint& joint) {
    for (size_t i = 0; i < 2; ++i)
        if (const ShapeHandle shape = joint.ends[i].shape; shape && (i == 0 || shape != joint.ends[0].shape))
            insert(m_byShape[shape.slot()], handle);
    if (joint.kind == JointKind::Rope) insert(m_ropes, handle);
    if (winds(joint)) insert(m_winding, handle);
    if (turns(joint)) insert(m_turning, handle);
    if (joint.hand) insert(m_grabs, handle);
}

void JointIndex::updateDrive(JointHandle handle, const Joint& joint) {
    std::erase(m_winding, handle);
    std::erase(m_turning, handle);
    if (winds(joint)) insert(m_winding, handle);
    if (turns(joint)) insert(m_turning, handle);
}

void JointIndex::remove(JointHandle handle, const Joint& joint) {
    for (const JointEnd& end : joint.ends) {
        const auto found = m_byShape.find(end.shape.slot());
        if (!end.shape || found == m_byShape.end()) continue;
        std::erase(found->second, handle);
        if (found->second.empty()) m_byShape.erase(found);
    }
    std::erase(m_ropes, handle);
    std::erase(m_winding, handle);
    std::erase(m_turning, handle);
    std::erase(m_grabs, handle);
}

void JointIndex::clear() {
    m_byShape.clear();
    m_ropes.clear();
    m_winding.clear();
    m_turning.clear();
    m_grabs.clear();
}

std::span<const JointHandle> JointIndex::of(ShapeHandle shape) const {
    const auto found = m_byShape.find(shape.slot());
    return found == m_byShape.end() ? std::span<const JointHandle>() : found->second;
}

}  // namespace rubble
