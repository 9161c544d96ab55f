#pragma once
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// A small scene in which every pass has something to draw: drivers finish programs in their first draws, and these
/// shall not be a game's.
FrameSnapshot warmUpScene();
/// A brick of the shadow volume far away, for its paged part.
FrameSnapshot outsideOfWarmUpScene();
/// A view of all of it, from `position` along -z.
inline constexpr glm::dvec3 kWarmUpPosition{0.4, 1.0, 3.0};

}  // namespace rubble
