#pragma once
#include <span>

#include "runtime/world/edits/edit.h"
#include "runtime/world/impacts/impact.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// The edits that impacts cause by their force, for the next step: breaks where they hit, and loads on the struck
/// shapes while StressSettings are on. Only the hardest WorldSettings::impactsPerStep count; impacts that cost the
/// heavier body less than WorldSettings::impactSpeed do nothing, so weight at rest breaks nothing.
Edits impactDamage(const WorldData& world, std::span<const Impact> impacts);

}  // namespace rubble
