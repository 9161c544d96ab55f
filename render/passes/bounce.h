#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// What rays through lib/bounce.glsl are for.
enum class BounceRays {
    Diffuse,  ///< averaged over the hemisphere and over time: RenderSettings says how long and how detailed their paths
              ///< are, and what the last frame shows counts by its diffuse part
    Mirrored,  ///< single rays of reflections: they see highlights, and paths end at the first hit
};

/// Sets the samplers and uniforms of lib/bounce.glsl. The program must be in use.
void bindBounce(const Program& program, const FrameContext& frame, BounceRays rays);

}  // namespace rubble
