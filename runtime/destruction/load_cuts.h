#pragma once
#include <unordered_map>
#include <vector>

#include "runtime/destruction/load_section.h"

namespace rubble {

/// A section with what it carries and withstands.
struct LoadCut {
    Section section;
    SectionForce load;  ///< the moment about the low corner of the section's brick
    SectionStrength strength;
    bool canBreak = true;
    double alone = 0.0;  ///< stress over strength by beam theory for this section alone
};

/// All sections of a shape. A stress is judged over a window: the section together with those in the same plane that touch
/// it in the bricks around. Within that, beam theory holds wherever the bricks lie; beyond it, stresses are local.
class LoadCuts {
public:
    static constexpr int kReach = 3;  ///< bricks on each side of one that belong to its window

    void clear();
    /// `load` about the centroid of the section's own cells.
    /// Returns its stress over strength, alone.
    double add(const Section& section, const SectionShape& shape, const SectionForce& load, const SectionStrength& strength, bool canBreak);
    size_t size() const { return m_cuts.size(); }
    const LoadCut& operator[](size_t i) const { return m_cuts[i]; }
    /// How a section is used as a part of its window.
    SectionUse use(size_t cut) const;

private:
    std::vector<LoadCut> m_cuts;
    std::vector<uint32_t> m_next;                      ///< the next one in the same plane of the same brick
    std::unordered_map<uint64_t, uint32_t> m_inPlane;  ///< the last one; looked up, never iterated
};

}  // namespace rubble
