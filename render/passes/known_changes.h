#pragma once
#include "render/frame/frame_context.h"
#include "render/gl/program.h"

namespace rubble {

/// Whether anything has changed that setKnownChanges() would set. [render-thread]
bool hasKnownChanges(const FrameContext& frame, int oldestLight = 0);
/// Sets the uniforms of lib/known_changes.glsl: what voxels, looks of shapes and light from sun and sky have changed
/// since the previous frame, and lights that have changed since `oldestLight` frames before it. The program must be in
/// use. [render-thread]
void setKnownChanges(const Program& program, const FrameContext& frame, int oldestLight = 0);
/// Sets the uniforms of lib/change_rays.glsl. The program must be in use. [render-thread]
void setLastConfidence(const Program& program, const FrameContext& frame);

}  // namespace rubble
