#pragma once
#include <numbers>

namespace rubble {

inline constexpr double kPi = std::numbers::pi;

/// Steps of the World in a second of game time: each is exactly 1/60 s.
inline constexpr int kStepsPerSecond = 60;

}  // namespace rubble
