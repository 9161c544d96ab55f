#pragma once
#include "render/frame_context.h"

namespace rubble {

/// Sets the samplers of lib/bounce.glsl. The program must be in use.
void bindBounce(const Program& program, const FrameContext& frame);

}  // namespace rubble
