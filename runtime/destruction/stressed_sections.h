#pragma once
#include <vector>

#include "runtime/core/index_map.h"
#include "runtime/destruction/cross_section.h"

namespace rubble {

/// A section with its load and its strength.
struct StressedSection {
    Section section;
    SectionForce load;  ///< the moment about the low corner of the section's brick
    SectionStrength strength;
    bool canBreak = true;
    double ownUtilization = 0.0;  ///< stress over strength, by beam theory on the section's own cells
};

/// All sections of a shape. The plane of a beam's cross-section runs through several bricks, so its stress is computed
/// over a window: a section together with those that are connected to it in the same plane of the bricks around it.
/// Within a window beam theory holds wherever the borders of bricks are; farther away, stresses are not related.
class StressedSections {
public:
    static constexpr int kWindowRadius = 3;  ///< bricks on each side of a section that belong to its window

    /// Removes all sections.
    void clear();
    /// Adds a section. `load` is about the centroid of the section's own cells, of which `shape` are the moments of
    /// area. Returns its own utilization.
    double add(const Section& section, const SectionShape& shape, const SectionForce& load,
               const SectionStrength& strength, bool canBreak);
    /// Number of sections.
    size_t size() const { return m_sections.size(); }
    const StressedSection& operator[](size_t i) const { return m_sections[i]; }
    /// The utilization of a section as a part of its window.
    SectionUtilization windowUtilization(size_t index);

private:
    /// A section that may belong to a window.
    struct Member {
        uint32_t index;
        int u, v;           ///< bricks from that of the window's section
        bool isIn = false;  ///< connected to the window's section
    };

    std::vector<StressedSection> m_sections;
    std::vector<uint32_t> m_previous;  ///< by section: the one before it in the same plane and brick
    IndexMap m_inPlane;                ///< by plane of a brick: the last one
    std::vector<Member> m_members;     ///< of a window
    std::vector<SectionTile> m_tiles;
};

}  // namespace rubble
