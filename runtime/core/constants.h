#pragma once
#include <numbers>

namespace rubble {

inline constexpr double kPi = std::numbers::pi;
inline constexpr float kPiF = std::numbers::pi_v<float>;

}  // namespace rubble
