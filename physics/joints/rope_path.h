#pragma once
#include <array>
#include <limits>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// A place at which a rope lies on something.
struct RopeBend {
    glm::dvec3 position{0.0};  ///< world
    BodyHandle body;           ///< that it lies on; empty: something static
    glm::dvec3 inBody{0.0};    ///< its position in the frame of that body's centre of mass
};

/// Metres from end to end over the bends.
double pathLength(const std::array<glm::dvec3, 2>& ends, const std::vector<RopeBend>& bends);

/// The slack that a rope has after its path was measured again, metres. slack: until now, below 0 if it is too long;
/// none: infinity. measured: its length less the new path. See rope_path.cpp for the rule.
double slackAfter(double slack, double measured, double seconds);

}  // namespace rubble
