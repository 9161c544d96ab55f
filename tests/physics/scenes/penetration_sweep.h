#pragma once
#include <string>
#include <vector>

#include "tests/physics/baseline/overlap.h"

namespace rubble::known {

/// One engine with one set of settings on the pit of Voronoi pieces.
struct PenetrationPoint {
    std::string engine;  ///< "rubble" or "bullet" (compounds, two friction directions)
    int substeps = 0, iterations = 0;
    double stepMs = 0.0;  ///< thread's processor time, mean of the last quarter of the steps
    Overlaps overlaps;    ///< at the end, with the height of the pile
};
/// Speed against penetration: Rubble with 1 to 12 substeps, Bullet with 1, 2 and 4 substeps of 10 iterations and with
/// 30 iterations, nothing asleep. 1,000 pieces and 480 steps take some ten minutes, nearly all of them Bullet's.
std::vector<PenetrationPoint> sweepPenetration(int pieces, int steps);

}  // namespace rubble::known
