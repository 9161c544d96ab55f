#include "tests/tradeoff/light_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "generated/paths.h"
#include "samples/support/gl_context.h"
#include "tests/reference/display.h"
#include "tests/reference/exr_file.h"
#include "tests/reference/flip.h"
#include "tests/reference/relative_error.h"

namespace rubble::tradeoff {
namespace {

/// Processor time of all threads of this process: other load on the machine is not counted.
double processorMs() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// The one context of this process: software GL, so that all machines measure the same renderer.
GlContext& context() {
    static const auto made = [] {
        auto context = GlContext::create(GlContext::Kind::OsMesa);
        if (!context) fmt::print("{}\n", context.error()), std::exit(1);
        return std::move(*context);
    }();
    return *made;
}

}  // namespace

LightBench::LightBench(const FrameSnapshot& snapshot, const View& view, glm::ivec2 size, const RenderSettings& settings,
                       const std::string& shaderFolder)
    : m_view(view) {
    RenderSettings timed = settings;
    timed.passTimes = true;
    auto made = Renderer::create(context().loader(), shaderFolder, timed);
    if (!made) fmt::print("{}\n", made.error()), std::exit(1);
    m_renderer = std::move(*made);
    m_renderer->apply(FrameSnapshot(snapshot));
    m_target = std::make_unique<Offscreen>(size);
    m_view.size = size;
    m_view.framebuffer = m_target->framebuffer();
}

void LightBench::draw(int frames) {
    for (int i = 0; i < frames; ++i) {
        const double begin = processorMs();
        m_renderer->draw(m_view, 1.0f);
        m_minMs = std::min(m_minMs, processorMs() - begin);
        for (const auto& [pass, ms] : m_renderer->stats().passMs) {
            const auto found =
                std::find_if(m_minPassMs.begin(), m_minPassMs.end(),
                             [name = std::string(pass)](const auto& each) { return each.first == name; });
            if (found == m_minPassMs.end())
                m_minPassMs.emplace_back(pass, ms);
            else
                found->second = std::min(found->second, ms);
        }
    }
}

FloatImage LightBench::read(const char* target) const {
    auto image = m_renderer->readTarget(target);
    if (!image) fmt::print("{}\n", image.error()), std::exit(1);
    return std::move(*image);
}

double LightBench::ms(std::string_view pass) const {
    for (const auto& each : m_minPassMs)
        if (each.first == pass) return each.second;
    return 0.0;
}

Difference differenceOf(const FloatImage& referenceImage, const FloatImage& drawn, float exposureOfLevel) {
    const float exposure = reference::exposureFor(referenceImage, exposureOfLevel);
    return {reference::flip(reference::displayed(referenceImage, exposure), reference::displayed(drawn, exposure)),
            reference::relativeError(referenceImage, drawn)};
}

ReferenceView streetReference(const Options& options, glm::ivec2 size) {
    ReferenceView street{std::move(reference::tuningViews(false)[0]), {}};
    street.scene.view.size = size;
    const reference::Settings settings{.samples = options.full ? 1024 : 192, .filterPixels = true};
    const reference::Scene scene(street.scene.snapshot);
    street.referenceImage = reference::cachedRender(scene, street.scene.view, settings, RUBBLE_BINARY_DIR "/reference",
                                                    "the referenceImage of " + street.scene.name)
                                .mean;
    return street;
}

}  // namespace rubble::tradeoff
