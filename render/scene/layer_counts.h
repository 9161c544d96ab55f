#pragma once
#include <cstdint>
#include <vector>

namespace rubble {

/// The range of the layers along an axis that hold anything. It grows and shrinks with what is added and removed, at a
/// cost that does not depend on how much there is.
class LayerCounts {
public:
    /// One thing more in a layer.
    void add(int layer);
    /// One thing less. The layer must hold one.
    void remove(int layer);
    /// The first layer that holds anything; 0 if none does.
    int low() const { return m_low; }
    /// One more than the last.
    int high() const { return m_high; }

private:
    uint32_t& at(int layer);

    std::vector<uint32_t> m_counts;  ///< by layer
    int m_first = 0;                 ///< the layer of m_counts[0]
    int m_low = 0, m_high = 0;
};

}  // namespace rubble
