#pragma once
#include <vector>

#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// Steps of a small scene in which every pass has something to draw, with the targets and kinds of textures that it may
/// have in a game: drivers finish programs in their first draws with these, and such draws shall not be a game's.
std::vector<FrameSnapshot> warmUpSteps();
/// A view of all of it, from `position` along -z.
inline constexpr glm::dvec3 kWarmUpPosition{0.4, 1.0, 3.0};
/// Of the image, in pixels: neither it nor its halves down to the last level of bloom have a side that is a power of
/// two, as few views do; llvmpipe tells such textures apart.
inline constexpr int kWarmUpSide = 81;

}  // namespace rubble
