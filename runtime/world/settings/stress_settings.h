#pragma once
#include <cstdint>

namespace rubble {

/// Whether standing shapes break under their own weight and under impacts. It concerns shapes of static bodies, whose
/// supports are known: their anchors. Pieces break only when they are struck. Off costs nothing; Shape::loadBearing
/// leaves out a single shape.
struct StressSettings {
    bool on = false;
    /// Multiple of all materials' strengths under weight. At 1, the real world, almost nothing of this size falls by
    /// itself.
    double strengthScale = 0.03;
    int64_t workPerStep = 40'000;    ///< units of about 20 ns; the rest waits for the next step
    uint32_t cracksPerStep = 4;      ///< sections of one shape that break at a time, the most overloaded first
    uint32_t largestShape = 32'768;  ///< bricks; a larger shape is not analysed, which is logged
    double contactTime = 0.02;       ///< s: an impact's force is its impulse over that, against unscaled strengths
    double minImpulse = 50.0;        ///< N s below which an impact loads nothing
    uint32_t minStruckVoxels = 512;  ///< of a piece; a smaller one breaks only where it is hit

    friend bool operator==(const StressSettings&, const StressSettings&) = default;
};

}  // namespace rubble
