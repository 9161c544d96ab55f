#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generated/paths.h"
#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "tests/reference/views.h"
#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {

/// A renderer with given settings that draws a still view of a scene and measures its time.
class LightBench {
public:
    /// Applies the snapshot. Frames have `size` pixels.
    LightBench(const FrameSnapshot& snapshot, const View& view, glm::ivec2 size, const RenderSettings& settings,
               const std::string& shaderFolder = RUBBLE_SOURCE_DIR "/shaders");

    /// Draws this many frames of the view.
    void draw(int frames = 1);
    /// Applies the next snapshot of the scene.
    void apply(FrameSnapshot&& snapshot) { m_renderer->apply(std::move(snapshot)); }
    /// Pixels of a target of the renderer as it is now. Ends the program if there is no such target.
    FloatImage read(const char* target) const;
    /// Processor time of a frame over all threads, in milliseconds: the minimum of the frames drawn.
    double ms() const { return m_minMs; }
    /// Time of a pass by the clock, in milliseconds: the minimum of the frames drawn.
    double ms(std::string_view pass) const;
    /// Forgets the minima so far.
    void resetTimes() { m_minPassMs.clear(), m_minMs = 1e30; }
    /// Counts and times of the last frame.
    const RenderStats& stats() const { return m_renderer->stats(); }

private:
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_target;
    View m_view;
    std::vector<std::pair<std::string, double>> m_minPassMs;
    double m_minMs = 1e30;
};

/// Difference of a frame from the reference: as displayed (FLIP), and of the radiance (relative MSE).
struct Difference {
    double flip = 0.0, relative = 0.0;
};
/// `exposureOfLevel`: the environment's exposure, before automatic exposure.
Difference differenceOf(const FloatImage& referenceImage, const FloatImage& drawn, float exposureOfLevel);

/// A view and its reference image.
struct ReferenceView {
    reference::SceneView scene;
    FloatImage referenceImage;
};
/// The street in the evening at a size. Its reference is path traced; later runs read it from a file.
ReferenceView streetReference(const Options& options, glm::ivec2 size);

}  // namespace rubble::tradeoff
