#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/world/settings/debris_settings.h"
#include "runtime/world/settings/fire_settings.h"
#include "runtime/world/settings/paint_settings.h"
#include "runtime/world/settings/split_settings.h"
#include "runtime/world/settings/stress_settings.h"

namespace rubble {

/// How a world breaks.
struct WorldSettings {
    uint64_t minPieceVoxels = 1;      ///< smaller pieces vanish: they count as removed
    double impactThreshold = 2000.0;  ///< N s below which an impact breaks nothing
    double impactSpeed = 0.8;         ///< m/s that an impact must cost the heavier body: weight at rest breaks nothing
    double impactRadius = 0.25;       ///< metres that an impact at the threshold takes out of soft materials
    double impactRadiusLimit = 0.6;   ///< metres
    size_t impactsPerStep = 8;        ///< how many impacts break something in one step, the hardest first
    size_t undoMarks = 0;             ///< how many marks can be undone; 0: nothing is remembered, and nothing paid
    DebrisSettings debris;
    PaintSettings paint;
    FireSettings fire;
    StressSettings stress;
    SplitSettings split;
};

}  // namespace rubble
