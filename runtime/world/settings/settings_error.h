#pragma once
#include <string>

#include "runtime/world/settings/world_settings.h"

namespace rubble {

/// What is wrong with the numbers of a world's settings, by runtime/core/ranges.h; empty: nothing. Budgets that are
/// whole numbers may have any value, unless work grows faster than they do.
std::string settingsError(const WorldSettings& settings);
/// The same of the bounds alone.
std::string boundsError(const BoundsSettings& settings);

}  // namespace rubble
