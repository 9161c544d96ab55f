#pragma once
#include "render/frame/frame_context.h"
#include "render/gl/program.h"

namespace rubble {

/// Sets the uniforms of lib/known_changes.glsl: voxels that have changed since the previous frame, and lights that have
/// changed since `oldestLight` frames before it. The program must be in use. [render-thread]
void setKnownChanges(const Program& program, const FrameContext& frame, int oldestLight = 0);
/// Sets the uniforms of lib/change_rays.glsl. The program must be in use. [render-thread]
void setChangeRays(const Program& program, const FrameContext& frame);

}  // namespace rubble
