#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/world/settings/bounds_settings.h"
#include "runtime/world/settings/debris_settings.h"
#include "runtime/world/settings/fire_settings.h"
#include "runtime/world/settings/paint_settings.h"
#include "runtime/world/settings/split_settings.h"
#include "runtime/world/settings/stress_settings.h"

namespace rubble {

/// How accurately bodies move, at what cost: see fastPhysics().
enum class PhysicsPreset : uint8_t {
    Given,  ///< as the physics of the world were made
    Fast,
    Balanced,
    Accurate
};

/// How a world breaks, burns and remembers. Budgets count work, never time: results are the same on every machine.
struct WorldSettings {
    uint64_t minPieceVoxels = 1;      ///< smaller pieces are removed
    double impactThreshold = 2000.0;  ///< N s below which an impact breaks nothing
    double impactSpeed = 0.8;    ///< m/s that an impact must change the heavier body by: weight at rest breaks nothing
    double impactRadius = 0.25;  ///< metres of a hole at the threshold; grows with the root of the impulse
    double impactRadiusLimit = 0.6;  ///< metres, the largest such hole
    size_t impactsPerStep = 8;       ///< impacts that break something in one step, the hardest first
    size_t undoMarks = 0;            ///< marks that can be undone; 0: no history, at no cost
    bool keepOrigins = false;        ///< notes say of all pieces what they came off, not only of those that have notes
    PhysicsPreset physics = PhysicsPreset::Given;
    BoundsSettings bounds;
    DebrisSettings debris;
    PaintSettings paint;
    FireSettings fire;
    StressSettings stress;
    SplitSettings split;

    /// A hash of all fields but undoMarks, which change nothing in the world.
    uint64_t hash() const;
    friend bool operator==(const WorldSettings&, const WorldSettings&) = default;
};

}  // namespace rubble
