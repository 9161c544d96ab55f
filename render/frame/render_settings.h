#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/gl_limits.h"
#include "render/gl/host_state.h"
#include "runtime/core/handle.h"

namespace rubble {

/// A camera, the size of its image and the framebuffer that the image goes to.
struct View {
    /// The projection of a host that looks along -z: a perspective, which may be off-centre, reversed or infinite, or
    /// an orthographic one, of which what lies before the near plane is not seen.
    struct Projection {
        glm::dmat4 clipFromEye{1.0};
        bool isZeroToOne = false;  ///< depth of clip space: 0 to 1, else -1 to 1
        /// What the framebuffer holds nearer than the voxels stays, and their depth is written.
        bool composesDepth = false;

        /// Whether it shows the same of all depths.
        bool isOrthographic() const { return clipFromEye[2][3] == 0.0; }
        /// Metres along the view axis at which rays begin: 0, or the near plane of an orthographic one.
        double startDepth() const;
        /// Depth in the window, 0 to 1, of what lies so many metres away along the view axis.
        double windowDepth(double metres) const;
        /// Whether what is nearer has the greater depth in the window.
        bool isReversed() const { return windowDepth(1.0) > windowDepth(2.0); }
    };

    glm::dvec3 position{0.0};              ///< world, metres
    glm::dquat rotation{1, 0, 0, 0};       ///< looks along -z, y up
    float verticalFov = 1.05f;             ///< radians
    glm::ivec2 size{1280, 720};            ///< pixels
    unsigned framebuffer = 0;              ///< GL name
    std::optional<Projection> projection;  ///< none: verticalFov, with square pixels
    /// Whether it composes with the depth of its framebuffer.
    bool composesDepth() const { return projection && projection->composesDepth; }
    bool isLinear = false;          ///< radiance times exposure, not the colours of a display
    bool hasFixedExposure = false;  ///< the environment's; off: adapted to the brightness of the image
    bool isFlipped = false;         ///< the first row of pixels is the top one
    bool cut = false;               ///< the camera jumped: histories of frames before this one are not used
    /// Views that are drawn in turn by one renderer, as those of a split screen, have different slots: each keeps its
    /// own history. Different sizes do so by themselves.
    int slot = 0;
    std::vector<ShapeHandle> hidden;  ///< shapes that are not drawn, but for their shadows
};

/// A clock: seconds since any moment.
using Seconds = double (*)();
/// The clock of the system.
double steadySeconds();

/// How the random numbers of rays are spread over pixels and frames. White noise is for tests of estimators, which need
/// independent samples.
enum class Noise { Blue, White };

/// How full-screen passes are drawn. All give the same image. Compute needs GL 4.3; without it fragments draw, with a
/// warning where Compute was asked for.
enum class Fullscreen {
    Auto,      ///< Compute on a GPU, Fragment on a software renderer
    Fragment,  ///< triangles
    Compute,   ///< compute programs
    Fastest,   ///< each pass alternates between both in its first frames and keeps the faster one
};

/// Quality against speed.
struct RenderSettings {
    int skyRays = 1;            ///< cosine-weighted rays per pixel and frame
    int sunRays = 1;            ///< rays per pixel and frame to random points of the sun's disc
    float skyDistance = 64.0f;  ///< metres: length of sky rays
    /// Metres from the start of a sky ray beyond which any block of 4^3 cells that holds something stops it: a tenth
    /// less to trace, no false light, some false shadow. All other rays are exact.
    float skyExactDistance = 1e30f;
    /// Share of each side of the view that is traced, lit and filtered. Below 1 the temporal pass upsamples; a still
    /// image is as sharp after some frames, a moving one less so. 0.5 takes about a quarter of the time. From
    /// kMinScale to 1; others count as the nearest, with a warning.
    float resolutionScale = 1.0f;
    static constexpr float kMinScale = 0.2f;
    int filterPasses = 4;            ///< iterations of the spatial filter
    bool temporal = true;            ///< temporal accumulation and anti-aliasing
    int historyFrames = 32;          ///< longest history of the accumulation, frames
    bool rejectStaleHistory = true;  ///< history is dropped where the light has changed; off: the change fades in
    int warmUpFrames = 0;            ///< frames drawn unseen before the first one and after each cut: clean stills
    bool sun = true, sky = true, localLights = true, reflections = true, fog = true, glare = true;
    bool bounce = true;  ///< indirect light from what sky and reflection rays hit; off: that is black
    int bounces = 2;     ///< of a sky ray at faces that the last frame does not show, 1 to 16; the rest is estimated
    /// Faces that the last frame does not show have their voxel's colour and local lights. Off: one colour, half the
    /// cost.
    bool bounceColors = true;
    Noise noise = Noise::Blue;  ///< of all light rays
    bool bevel = true;          ///< rounds the edges of near voxels in their shading
    bool refraction = true;     ///< panes shift what is behind them
    Fullscreen fullscreen = Fullscreen::Auto;
    bool detail = true;               ///< grain, joints and pores on the faces of near voxels, by material
    float bloom = 0.04f;              ///< share of the blurred image that is added; 0: none, at no cost
    uint64_t uploadBudget = 4 << 20;  ///< bytes of changed bricks per frame; a level that is loaded is sent at once
    bool passTimes = false;           ///< RenderStats::passMs is filled; a software renderer waits for each pass to end
    bool processorTime = false;       ///< pass times are those of all threads of this process: for a busy machine
    HostState hostState = HostState::Restored;
    /// All programs are built, and drawn with once, before the first frame: no later frame waits for the driver when
    /// something is first seen. Off: those of what most scenes never have are built in the frame that needs them.
    bool compileAhead = false;
    std::string programCache;         ///< a folder for programs as the driver made them; empty: none
    std::optional<GlLimits> limits;   ///< the GL counts as having no more than these; none: as much as it has
    Seconds seconds = steadySeconds;  ///< the clock of what is shown for a time

    /// These settings, with what is out of its range moved to the nearest end. The log says so.
    RenderSettings inRange() const;
    /// "draft", "fast", "balanced" or "accurate"; any other name gives the defaults, which are "balanced".
    static RenderSettings preset(std::string_view name);
    /// "fragment", "compute" or "fastest"; Auto for any other text.
    static Fullscreen fullscreenFromName(std::string_view name);
};

}  // namespace rubble
