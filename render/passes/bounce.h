#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// What rays are for. Gathered ones are averaged over the hemisphere and over time: RenderSettings says how far their
/// paths go and in what detail, and places that the picture shows shine alike to all sides. Mirrored ones see their
/// highlights too, and paths end where they meet something.
enum class BounceRays { Gathered, Mirrored };

/// Sets the samplers and uniforms of lib/bounce.glsl. The program must be in use.
void bindBounce(const Program& program, const FrameContext& frame, BounceRays rays);

}  // namespace rubble
