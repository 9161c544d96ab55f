#include "render/frame/fullscreen_mode.h"

#include "render/gl/gl.h"
#include "runtime/core/log.h"

namespace rubble {

// Only the programs of one method are built: on NVIDIA's driver those of both take twice as long to build, 20 s more,
// and on an H100 only one of thirteen passes is faster by fragments at 1280x720, by 0.01 ms. On llvmpipe passes take
// 0.97 to 3.4 times as long by compute, the whole frame 1.24 to 1.34 times.
Fullscreen supportedFullscreen(Fullscreen wanted) {
    if (wanted == Fullscreen::Auto) return hasCompute() && !isSoftwareGl() ? Fullscreen::Compute : Fullscreen::Fragment;
    if (wanted == Fullscreen::Fragment || hasCompute()) return wanted;
    logWarning(
        "full-screen passes: expected GL 4.3 or newer for compute programs, found an older context; "
        "fragments draw them");
    return Fullscreen::Fragment;
}

ShaderLibrary::Fullscreen programsFor(Fullscreen drawn) {
    if (drawn == Fullscreen::Fastest) return ShaderLibrary::Fullscreen::Both;
    return drawn == Fullscreen::Compute ? ShaderLibrary::Fullscreen::Compute : ShaderLibrary::Fullscreen::Fragment;
}

FullscreenChoice initialChoice(Fullscreen drawn) {
    if (drawn == Fullscreen::Fastest) return FullscreenChoice::fastest();
    return FullscreenChoice(drawn == Fullscreen::Compute ? FullscreenMethod::Compute : FullscreenMethod::Fragment);
}

}  // namespace rubble
