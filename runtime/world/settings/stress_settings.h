#pragma once
#include <cstdint>

namespace rubble {

/// Whether and how what stands on too little breaks. Concerns shapes of static bodies: what holds them up is known,
/// their anchors. Pieces break only when they are struck. Off costs nothing; a shape of its own can be left out by
/// Shape::loadBearing.
struct StressSettings {
    bool on = false;
    double strengthScale =
        0.03;  ///< of all materials under weight: in the real world, 1, almost nothing of this size falls by itself
    int64_t workPerStep = 40'000;    ///< units of about 20 ns; what is left waits for the next step
    uint32_t cracksPerStep = 4;      ///< sections of one shape that break at a time, the most overloaded first
    uint32_t largestShape = 32'768;  ///< bricks; a larger one is left out, and the log says so
    double contactTime =
        0.02;  ///< s that a blow lasts: its force is its impulse over that, against the materials' own strength
    double minImpulse = 50.0;        ///< N s below which a blow is not looked at
    uint32_t minStruckVoxels = 512;  ///< voxels of a piece; a smaller one breaks only where it is hit

    friend bool operator==(const StressSettings&, const StressSettings&) = default;
};

}  // namespace rubble
