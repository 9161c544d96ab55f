#pragma once
#include <optional>
#include <vector>

#include "render/frame/pixel_rect.h"
#include "render/scene/convex_polygon.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// The pixels that a water may cover: the hull of its prism as the camera sees it, larger by what waves add to it.
/// Empty where it is out of view; the whole view where the camera may be in it.
struct WaterArea {
    ConvexPolygon prism;    ///< in the view, pixels
    ConvexPolygon covered;  ///< the same with room for the jitter of the samples
    PixelRect bounds;       ///< whole pixels around `covered`

    /// Whether a pixel may show both.
    bool overlaps(const WaterArea& other) const;
};

/// origin: of the renderer, world.
WaterArea waterArea(const Water& water, const FrameBlock& block, glm::dvec3 origin);
/// Height in the world of the surface of the water that a place is in; nothing if it is in none.
std::optional<double> waterSurfaceOver(const std::vector<Water>& waters, glm::dvec3 place);

}  // namespace rubble
