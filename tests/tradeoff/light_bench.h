#pragma once
#include <memory>

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "tests/reference/views.h"
#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {

/// What a renderer with some settings draws of a scene, and what it takes.
class LightBench {
public:
    /// Keeps the snapshot; everything is drawn at this size.
    LightBench(const FrameSnapshot& snapshot, const View& view, glm::ivec2 size, const RenderSettings& settings,
               const std::string& shaderFolder = RUBBLE_SOURCE_DIR "/shaders");

    /// Draws `frames` frames of the still view.
    void draw(int frames = 1);
    void apply(FrameSnapshot&& snapshot) { m_renderer->apply(std::move(snapshot)); }
    FloatImage read(const char* target) const;
    /// Processor time of a frame over all threads, the least of those drawn.
    double ms() const { return m_minMs; }
    /// The least that a pass took, by the clock.
    double ms(std::string_view pass) const;
    void resetTimes() { m_minPassMs.clear(), m_minMs = 1e30; }
    const RenderFigures& figures() const { return m_renderer->figures(); }

private:
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_target;
    View m_view;
    std::vector<std::pair<std::string, double>> m_minPassMs;
    double m_minMs = 1e30;
};

/// How a frame differs from the referenceImage as radiance and as it is shown.
struct Difference {
    double flip = 0.0, relative = 0.0;
};
Difference differenceOf(const FloatImage& referenceImage, const FloatImage& drawn, float exposureOfLevel);

/// The first tuning view (the street in the evening) and its referenceImage, from the cache if an earlier run made it.
struct ReferenceView {
    reference::SceneView scene;
    FloatImage referenceImage;
};
ReferenceView streetReference(const Options& options, glm::ivec2 size);

}  // namespace rubble::tradeoff
