#pragma once
#include <rubble/rubble.hpp>

namespace netplay {

/// Builds a yard into an empty world, and steps it once: a floor of concrete, 64 by 64 metres around the origin with
/// its top at height 0, and on it houses of brick in rows. What leaves it becomes dust. rows: 1 to 4; that many houses
/// in each of as many rows.
void buildYard(rubble::World& world, int rows);

/// The half of the yard's side, metres.
inline constexpr double kYardHalf = 32.0;
/// How high a house is, metres.
inline constexpr double kHouseHeight = 8.0;
/// Where the middle of a house is along x (row, 0 on) and z (column): metres.
double housePlace(int index, int rows);

}  // namespace netplay
