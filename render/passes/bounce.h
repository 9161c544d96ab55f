#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Sets the samplers of lib/bounce.glsl. The program must be in use. detailed: places that no picture shows have their voxels' colours and
/// are lit by lamps.
void bindBounce(const Program& program, const FrameContext& frame, bool detailed = true);

}  // namespace rubble
