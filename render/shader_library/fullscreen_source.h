#pragma once
#include <string>
#include <vector>

#include "render/shader_library/shader_source.h"

namespace rubble {

/// How a shader that covers its targets is drawn.
enum class FullscreenMethod { Fragment, Compute };

/// How an output of the shader is combined with what the target holds. All but Replace are for RGBA16F targets.
enum class Merge {
    Replace,
    Color,  ///< rgb replaced, alpha kept
    Alpha,  ///< alpha replaced, rgb kept
    Add,    ///< new + old
    Over,   ///< new + new alpha * old
};

/// The state in which a full-screen shader is drawn.
struct FullscreenKind {
    bool surfacesOnly = false;      ///< draws only where a depth buffer is nearer than the far plane
    std::vector<Merge> merge = {};  ///< by target; Replace for those that are not listed
    /// The vertex shader of the fragment program. This one draws a triangle at the far plane, where a depth test can
    /// tell pixels with a surface from those of the sky.
    std::string vertexFile = "lib/fullscreen_far.vert";
    /// How output `target` is combined.
    Merge mergeOf(size_t target) const { return target < merge.size() ? merge[target] : Merge::Replace; }
};

/// Pixels across and up that a workgroup of a compute program covers. Wider groups are no faster.
inline constexpr int kGroupWidth = 8, kGroupHeight = 8;

/// Turns a full-screen shader of passes/ into the source of a fragment or a compute program. The shader writes its `out
/// vec4`s, reads `uv` and gl_FragCoord, and may discard in main(). Both programs compute `uv` alike, so they write the
/// same numbers. Lines keep their numbers, for ShaderSource::explain().
ShaderSource asFullscreen(ShaderSource source, const FullscreenKind& kind, FullscreenMethod method);

}  // namespace rubble
