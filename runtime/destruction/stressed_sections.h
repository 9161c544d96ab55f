#pragma once
#include <unordered_map>
#include <vector>

#include "runtime/destruction/cross_section.h"

namespace rubble {

/// A section with what it carries and withstands.
struct StressedSection {
    Section section;
    SectionForce load;  ///< the moment about the low corner of the section's brick
    SectionStrength strength;
    bool canBreak = true;
    double ownUtilization = 0.0;  ///< stress over strength by beam theory for this section ownUtilization
};

/// All sections of a shape. A stress is judged over a window: the section together with those in the same plane that
/// touch it in the bricks around. Within that, beam theory holds wherever the bricks lie; beyond it, stresses are
/// local.
class StressedSections {
public:
    static constexpr int kWindowRadius = 3;  ///< bricks on each side of one that belong to its window

    void clear();
    /// `load` about the centroid of the section's own cells.
    /// Returns its stress over strength, ownUtilization.
    double add(const Section& section, const SectionShape& shape, const SectionForce& load,
               const SectionStrength& strength, bool canBreak);
    size_t size() const { return m_sections.size(); }
    const StressedSection& operator[](size_t i) const { return m_sections[i]; }
    /// How a section is used as a part of its window.
    SectionUtilization windowUtilization(size_t stressed) const;

private:
    std::vector<StressedSection> m_sections;
    std::vector<uint32_t> m_next;                      ///< the next one in the same plane of the same brick
    std::unordered_map<uint64_t, uint32_t> m_inPlane;  ///< the last one; looked up, never iterated
};

}  // namespace rubble
