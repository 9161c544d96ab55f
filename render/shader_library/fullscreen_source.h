#pragma once
#include <vector>

#include "render/shader_library/shader_source.h"

namespace rubble {

/// What draws a shader that covers its targets.
enum class FullscreenMethod { Fragment, Compute };

/// What becomes of what a target holds. The others than Replace are for RGBA16F.
enum class Merge {
    Replace,
    Color,  ///< the alpha stays
    Alpha,  ///< the colour stays
    Add,
    Over,  ///< new + new alpha x old
};

/// How a shader that covers its targets is drawn, besides what it says itself.
struct FullscreenKind {
    bool limited = false;           ///< only where a depth buffer shows a surface
    std::vector<Merge> merge = {};  ///< by target; those that are not listed are replaced
    /// Of the fragment program. The triangle lies at the far plane, where a depth test can tell pixels with a surface
    /// from those of the sky.
    std::string vertexFile = "lib/fullscreen_far.vert";
    Merge mergeOf(size_t target) const { return target < merge.size() ? merge[target] : Merge::Replace; }
};

/// Pixels across and up that a compute program works on together.
inline constexpr int kGroupWidth = 8, kGroupHeight = 8;  // wider is no faster

/// One text, two programs. A shader of passes/ writes its `out vec4`s, reads `uv` and gl_FragCoord, and may discard in
/// main(). This puts around it what either program needs, with the same number for `uv` in both. Lines keep their
/// places, for explain().
ShaderSource asFullscreen(ShaderSource source, const FullscreenKind& kind, FullscreenMethod by);

}  // namespace rubble
