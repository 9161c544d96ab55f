#pragma once
#include <map>
#include <span>
#include <vector>

#include "runtime/world/objects/joint.h"

namespace rubble {

/// Which joints hold on to a shape, and which are ropes or grabs: a split costs its own joints, not the world's.
class JointIndex {
public:
    void add(JointHandle handle, const Joint& joint);
    /// As it was added.
    void remove(JointHandle handle, const Joint& joint);
    void clear();
    /// In slot order.
    std::span<const JointHandle> of(ShapeHandle shape) const;
    std::span<const JointHandle> ropes() const { return m_ropes; }
    std::span<const JointHandle> grabs() const { return m_grabs; }

private:
    std::map<uint32_t, std::vector<JointHandle>> m_byShape;
    std::vector<JointHandle> m_ropes, m_grabs;
};

}  // namespace rubble
