#pragma once
#include <map>
#include <set>

#include "runtime/core/handle.h"
#include "runtime/destruction/stress_analysis.h"

namespace rubble {

/// The stress analyses of a world's standing shapes, and the cracks that wait for the next step. There is none in a
/// world whose StressSettings are off. What it holds decides what breaks when, so it is part of World::hash(); saving
/// drops it, in the running game too (World::resetCaches()).
class WorldStress {
public:
    struct Entry {
        ShapeHandle shape;
        StressAnalysis analysis;
        PaletteRef palette;  ///< that `entries` were made from
        StrengthTable entries;
        std::vector<StressCrack> cracks;
        std::vector<WeakBrick> weak;  ///< by cellBefore()
    };

    Entry& add(ShapeHandle shape);
    void remove(ShapeHandle shape);
    Entry* find(ShapeHandle shape);
    /// Makes an entry take its turn until it is idle and its cracks are open.
    void wake(ShapeHandle shape) { m_busy.insert(shape.slot()); }
    void sleep(ShapeHandle shape) { m_busy.erase(shape.slot()); }
    bool isBusy() const { return !m_busy.empty(); }
    /// Those that have something to do, in slot order, beginning after the one that was served last.
    std::vector<ShapeHandle> busy() const;
    void served(ShapeHandle shape) { m_lastServed = shape.slot(); }
    /// For another gravity or other settings.
    void restartAll();
    uint64_t hash() const;

private:
    std::map<uint32_t, Entry> m_entries;  ///< by slot
    std::set<uint32_t> m_busy;
    uint32_t m_lastServed = 0;
};

}  // namespace rubble
