#pragma once
#include <memory>
#include <string_view>

#include "render/renderer.h"

namespace rubble {

/// Versions of OpenGL to ask for, best first. The renderer needs 3.3 and can draw by compute from 4.3 on; some drivers
/// provide exactly the version that they are asked for.
struct GlVersion {
    int major, minor;
};
inline constexpr GlVersion kWantedGl[] = {{4, 3}, {3, 3}};

/// A GL core context without a window. It is current on the thread that created it until it is destroyed. It has no
/// framebuffer to show: draw into an Offscreen.
class GlContext {
public:
    enum class Kind {
        Auto,    ///< EGL on a GPU if there is one, else OSMesa, else EGL
        OsMesa,  ///< Mesa's software renderer in this process
        Egl,     ///< EGL on a device, or surfaceless
        EglEs,   ///< the same, but a context of OpenGL ES 3.0, as those of browsers are
    };
    /// Creates a context and makes it current. An error if there is none of that kind.
    static Result<std::unique_ptr<GlContext>> create(Kind kind = Kind::Auto);
    /// The kind of a name, "osmesa", "egl" or "egl-es"; Auto for any other text.
    static Kind kindOf(std::string_view name);

    virtual ~GlContext() = default;
    /// Finds GL functions by name, for Renderer::create().
    virtual GlLoader loader() const = 0;
    /// Makes it current again on this thread, after another one was.
    virtual void makeCurrent() = 0;
};

}  // namespace rubble
