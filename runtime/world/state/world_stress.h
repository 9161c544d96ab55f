#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/stress_analysis.h"

namespace rubble {

/// The strength that fire has left to a brick, rounded up to sixteenths of 256: so a fire does not restart the analysis
/// for every spark.
inline int quantizedStrength(int left) {
    return (left + 15) / 16 * 16;
}

/// The stress analyses of a world's standing shapes, and the cracks that open in the next step. It decides what breaks
/// when, so it is part of World::hash(). Saving drops it, in the running game too (World::resetCaches()).
class WorldStress {
public:
    struct Entry {
        ShapeHandle shape;
        StressAnalysis analysis;
        PaletteRef palette;               ///< that `entries` were made from
        StrengthTable entries;            ///< strengths by palette entry
        std::vector<StressCrack> cracks;  ///< open in the next step
        std::vector<WeakBrick> weak;      ///< bricks that fire has weakened, by cellBefore()
    };

    /// Starts the analysis of a shape.
    Entry& add(ShapeHandle shape);
    /// Ends the analysis of a shape, if there is one.
    void remove(ShapeHandle shape);
    /// The analysis of a shape; null if there is none. Stays where it is until it is removed.
    Entry* find(ShapeHandle shape);
    /// Gives an analysis work until it is idle and its cracks are open.
    void wake(ShapeHandle shape) { m_busy.insert(shape.slot()); }
    /// Ends the work of an analysis.
    void sleep(ShapeHandle shape) { m_busy.erase(shape.slot()); }
    /// Whether any analysis has work to do.
    bool isBusy() const { return !m_busy.empty(); }
    /// Analyses with work to do, in slot order, beginning after the one that was served last.
    std::vector<ShapeHandle> busy() const;
    /// Notes that an analysis had its turn.
    void served(ShapeHandle shape) { m_lastServed = shape.slot(); }
    /// Starts all analyses again, for another gravity.
    void restartAll();
    /// A hash of all that decides what breaks when.
    uint64_t hash() const;

private:
    std::map<uint32_t, Entry> m_entries;  ///< by slot
    std::set<uint32_t> m_busy;
    uint32_t m_lastServed = 0;
};

}  // namespace rubble
