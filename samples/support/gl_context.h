#pragma once
#include <memory>
#include <string_view>

#include "render/renderer.h"

namespace rubble {

/// A GL 3.3 core context without a window, current on the thread that made it until it is destroyed. Draw into an Offscreen.
class GlContext {
public:
    enum class Kind {
        Auto,    ///< EGL on a GPU if there is one, else OSMesa, else EGL
        OsMesa,  ///< Mesa's software renderer in this process
        Egl,     ///< a device or surfaceless display
    };
    static Result<std::unique_ptr<GlContext>> create(Kind kind = Kind::Auto);
    /// "auto", "osmesa" or "egl"; Auto for any other text.
    static Kind kindOf(std::string_view name);

    virtual ~GlContext() = default;
    virtual GlLoader loader() const = 0;
    virtual const char* name() const = 0;
};

}  // namespace rubble
