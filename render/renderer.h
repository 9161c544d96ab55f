#pragma once
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/float_image.h"
#include "runtime/core/result.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// Looks up a GL function in the context that is current.
using GlLoader = void* (*)(const char* name);

/// Which picture of the world: a camera and a size in pixels.
struct View {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1, 0, 0, 0};  ///< looks along -z, y up
    float verticalFov = 1.05f;        ///< radians
    glm::ivec2 size{1280, 720};
    unsigned framebuffer = 0;  ///< GL name of the target
    bool cut = false;          ///< the camera jumped: history is forgotten
};

/// How the rays of a pixel are spread. White noise has no order over pixels or time: what estimators are tested with.
enum class Noise { Blue, White };

/// What draws the passes that cover the whole view: the same picture either way. Compute needs GL 4.3; without it
/// fragments draw, with a warning where compute was asked for by name.
enum class Fullscreen {
    Auto,      ///< Fastest on a GPU, Fragment on a software renderer
    Fragment,  ///< triangles
    Compute,   ///< compute programs
    Fastest,   ///< each pass draws its first pictures both ways by turns and stays with what was faster
};

/// Quality against speed. Presets "fast", "balanced", "accurate".
struct RenderSettings {
    int skyRays = 1;  ///< cosine-weighted rays a pixel
    int sunRays = 1;
    float skyDistance = 64.0f;  ///< metres
    /// Metres from where sky rays start beyond which a block of 4^3 voxels with anything in it stops them: a tenth less
    /// to trace, no false light, some false shadow. All other rays are exact, whatever the preset.
    float skyExactDistance = 1e30f;
    /// Of each side of the view: what is traced, lit and filtered. Below 1 the temporal pass brings it to the view's
    /// size, over several pictures as sharp as that; what moves is less so. 0.5 costs about a quarter.
    float resolutionScale = 1.0f;
    int filterPasses = 4;            ///< of the spatial filter
    bool temporal = true;            ///< reprojected accumulation and TAA
    int historyFrames = 32;          ///< how many pictures the accumulation remembers
    bool rejectStaleHistory = true;  ///< memory is cut where the light has changed; off: it fades
    int warmUpFrames = 0;            ///< drawn unseen before the first picture and after each cut: clean stills
    bool sun = true, sky = true, localLights = true, reflections = true, fog = true, glare = true;
    bool bounce = true;  ///< what sky and mirror rays hit shines back; off: it is black
    int bounces = 2;  ///< of a sky ray off faces that the last picture does not show, 1 or more; after the last one the
                      ///< light is guessed
    bool bounceColors = true;   ///< what sky rays hit unseen has its voxel's colour and lamps' light; off: one colour
                                ///< for all, at half the cost
    Noise noise = Noise::Blue;  ///< of light's rays
    bool bevel = true;          ///< rounds the edges of near voxels in light
    bool refraction = true;     ///< panes shift what is behind them
    Fullscreen fullscreen = Fullscreen::Auto;
    bool detail = true;  ///< grain, joints and pores on the faces of near voxels, by material
    float bloom = 0.04f;
    uint64_t uploadBudget = 4 << 20;  ///< bytes of changed bricks sent a frame; a level that is loaded is sent at once
    bool processorTime =
        false;  ///< figures' times are of this process's threads, all together: for benchmarks on a busy machine
    static RenderSettings preset(std::string_view name);
    /// "fragment", "compute" or "fastest"; Auto for any other text.
    static Fullscreen fullscreenFromName(std::string_view name);
};

struct RenderFigures {
    int drawCalls = 0;
    int bodyDraws = 0;          ///< of those, the ones that draw voxel bodies
    uint64_t uploadBytes = 0;   ///< to the GL since the last figures
    uint64_t waitingBytes = 0;  ///< of changed bricks over the budget: what has changed is drawn as it was
    uint64_t textureBytes = 0;  ///< held now
    int shapes = 0;
    int bricks = 0;
    std::vector<std::pair<const char*, double>>
        passMs;  ///< in the order drawn; with GL_TIME_ELAPSED where it is honest, else after glFinish
    std::vector<const char*> computePasses;  ///< of these passes, the ones that draw full-screen programs by compute
    int computePrograms = 0;                 ///< held now
};

/// The deferred ray-traced renderer: a list of passes. [render-thread] All calls with the same GL context current.
class Renderer {
public:
    /// shaderFolder: where shaders/ lies. Fails with what is missing of GL or which shader line is wrong.
    static Result<std::unique_ptr<Renderer>> create(GlLoader loader, const std::string& shaderFolder,
                                                    const RenderSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    void apply(FrameSnapshot&& snapshot);
    /// alpha in [0, 1]: how far between the previous and current poses. A view without pixels draws nothing. What the
    /// GL cannot make in the view's size is drawn smaller and scaled, with a warning; what cannot be drawn at all is
    /// said by lastError().
    void draw(const View& view, float alpha);
    /// Why the last draw() drew nothing ("the GL context was lost: ..."); empty if it did.
    const std::string& lastError() const;
    /// Builds programs anew whose files have changed on disk. One that fails keeps its last good program; a red dot in
    /// the picture's corner says so until it is mended, a green one for a second that it is. True if any was built.
    bool reloadShaders();
    /// Of shaders that do not build as they lie on disk: with file and line.
    std::vector<std::string> shaderErrors() const;
    /// Which intermediate target draw() shows: "final" (default), "albedo", "normal", "depth", ... ; false if there is
    /// none such.
    bool showPass(std::string_view name);
    std::vector<std::string> passNames() const;
    /// What the last draw() left in a colour target of this name ("noisyLight", "accumulatedLight", "radiance",
    /// "depth", ...): not mapped for the eye. Waits for the GL. For tests and measurements.
    Result<FloatImage> readTarget(std::string_view name) const;
    const RenderFigures& figures() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble
