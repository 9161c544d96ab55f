#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/float_image.h"
#include "render/frame/render_settings.h"
#include "render/frame/render_stats.h"
#include "render/overlay/overlay_item.h"
#include "runtime/core/result.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// Looks up a GL function in the current context.
using GlLoader = void* (*)(const char* name);

/// The deferred ray-traced renderer. [render-thread] All calls need the same GL context to be current; they leave its
/// state as it was.
class Renderer {
public:
    /// shaderFolder: where shaders/ lies, for those who change it; empty: the library's own. An error says what is
    /// missing of GL, or which line of a shader is wrong.
    static Result<std::unique_ptr<Renderer>> create(GlLoader loader, const std::string& shaderFolder,
                                                    const RenderSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Whether a GL context is current on the calling thread. There must have been a renderer.
    static bool hasContext();

    /// Brings the GPU's copy of the world up to date. Changes over the upload budget wait for later frames.
    void apply(FrameSnapshot&& snapshot);
    /// Draws a frame. alpha: 0 to 1 between the previous and the current poses. A view of no size draws nothing. Where
    /// the GL has no room for the view's size, a smaller image is drawn and scaled up, with a warning.
    void draw(const View& view, float alpha);
    /// Why the last draw() drew nothing, e.g. because the GL context was lost; empty if it did.
    const std::string& lastError() const;
    /// Rebuilds the programs whose files have changed on disk. One that fails keeps its last good program, and a red
    /// dot in the corner of the image says so; a green one shows a success for a second. True if any was rebuilt.
    bool reloadShaders();
    /// The errors of shaders that do not build as they are on disk, with file and line.
    std::vector<std::string> shaderErrors() const;
    /// Chooses what draw() shows: "final" (the default) or an intermediate target of passNames(). False if there is
    /// none of that name.
    bool showPass(std::string_view name);
    /// Draws these items over the image of each draw() from now on, in their order; nothing costs nothing. An error
    /// says which one names a font that cannot be read or an image that is not there: then all is as before.
    Result<Done> setOverlay(std::vector<OverlayItem> items);
    /// Gives an image a name for items, or replaces it; without pixels takes it away.
    void setOverlayImage(const std::string& name, OverlayImage image);
    /// Width and height of a text of an overlay. [any-thread]
    static Result<glm::vec2> measureText(const std::string& font, float fontSize, float width, std::string_view text);
    /// The names that showPass() knows.
    std::vector<std::string> passNames() const;
    /// The values that the last draw() left in a colour target ("noisyLight", "radiance", "depth", ...:
    /// render/frame/targets.h). Waits for the GL. For tests and measurements.
    Result<FloatImage> readTarget(std::string_view name) const;
    /// What the last draw() cost.
    const RenderStats& stats() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble
