#pragma once
#include "render/frame/render_settings.h"
#include "render/gl/program.h"

namespace rubble {

/// Sets the uniforms of lib/show.glsl that turn linear depths into depths of the host's window. Without a projection
/// depth is not tested, so any do. The program must be in use.
inline void setHostDepth(const Program& program, const View& view) {
    const View::Projection projection = view.projection.value_or(View::Projection{});
    const glm::dmat4& p = projection.clipFromEye;
    const double start = projection.startDepth();  // linear depths are from there
    program.set("uClipOfDepth", glm::vec4(-p[2][2], p[3][2] - p[2][2] * start, -p[2][3], p[3][3] - p[2][3] * start));
    program.set("uWindowOfClip", projection.isZeroToOne ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.5f));
    program.set("uFarthest", projection.isReversed() ? 0.0f : 1.0f);
}

}  // namespace rubble
