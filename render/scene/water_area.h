#pragma once
#include "render/frame/pixel_rect.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// The pixels that a water may cover: a rectangle around its prism as the camera sees it, larger by what waves add to
/// it. Empty where it is out of view; the whole view where the camera may be in it. origin: of the renderer, world.
PixelRect waterArea(const Water& water, const FrameBlock& block, glm::dvec3 origin);

}  // namespace rubble
