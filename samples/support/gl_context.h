#pragma once
#include <memory>
#include <string_view>

#include "render/renderer.h"

namespace rubble {

/// Core contexts are asked for in this order: the renderer needs 3.3, and draws by compute from 4.3 on. Some drivers
/// give just what they are asked for.
struct GlVersion {
    int major, minor;
};
inline constexpr GlVersion kWantedGl[] = {{4, 3}, {3, 3}};

/// A GL core context without a window, current on the thread that made it until it is destroyed. Draw into an
/// Offscreen.
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
