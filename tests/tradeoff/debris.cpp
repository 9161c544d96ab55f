#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "generated/paths.h"
#include "render/gl/offscreen.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/test_scenes.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

constexpr int kSteps = 150;
constexpr uint32_t kNever = std::numeric_limits<uint32_t>::max();

struct Setting {
    const char* axis;
    uint64_t smallest;
    uint32_t bodies, settleSteps;
};

struct Run {
    double stepMs = 0.0, massLost = 0.0, momentumLost = 0.0;
    size_t pieces = 0;
    Image image;
};

/// Two explosions at a brick wall.
Edits script(int step, uint64_t) {
    Edits edits;
    for (int i = 0; i < 2; ++i)
        if (step == 6 + 4 * i) edits.push_back(ExplodeEdit{{3.1 + 1.8 * i, 1.0, 3.5}, 1.6, 900.0});
    return edits;
}

Image drawImage(FrameLoop& loop) {
    static const auto context = GlContext::create(GlContext::Kind::OsMesa);
    if (!context) return {};
    RenderSettings settings = RenderSettings::preset("fast");
    settings.warmUpFrames = 3;
    auto renderer = Renderer::create((*context)->loader(), RUBBLE_SOURCE_DIR "/shaders", settings);
    if (!renderer) return {};
    const Offscreen target({160, 90});
    const Pose eye = scenes::lookAt({2.2, 2.4, 10.0}, {4.0, 0.7, 4.5});
    View view;
    view.position = eye.position;
    view.rotation = eye.rotation;
    view.size = target.size();
    view.framebuffer = target.framebuffer();
    view.cut = true;
    loop.draw(**renderer, view, 1.0f);
    Image image(160, 90);
    image.rgb = target.readRgb();
    return image;
}

Run simulate(const Setting& setting, uint64_t seed, bool drawn) {
    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.shadowVolume = settings.publish = drawn;
    settings.particles.maxAlive = 0;
    FrameLoop loop(settings);
    WorldSettings worldSettings;
    worldSettings.minPieceVoxels = setting.smallest;
    worldSettings.debris.bodies = setting.bodies;
    worldSettings.debris.settleSteps = setting.settleSteps;
    loop.world().setSettings(worldSettings);
    loop.load(makeWall());
    Run run;
    for (int step = 0; step < kSteps; ++step) {
        loop.edits().push(script(step, seed));
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            loop.step();
        }
        run.stepMs += ms / kSteps;
        for (const DustCloud& dust : loop.changes().dust) {
            const double mass = double(dust.count) * 1e-3 * double(loop.world().materials()[dust.material].density);
            run.massLost += mass;
            run.momentumLost += mass * double(glm::length(dust.velocity));
        }
    }
    loop.world().bodies().forEach([&](BodyHandle, const Body& body) { run.pieces += !body.isStatic; });
    if (drawn) run.image = drawImage(loop);
    return run;
}

/// Root mean square difference of two images, from 0 to 255.
double difference(const Image& a, const Image& b) {
    if (a.rgb.empty() || a.rgb.size() != b.rgb.size()) return std::nan("");
    double sum = 0.0;
    for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(double(a.rgb[i]) - double(b.rgb[i]), 2);
    return std::sqrt(sum / double(a.rgb.size()));
}

std::vector<Setting> settingsOf(bool full) {
    constexpr uint64_t kSizes[] = {1, 8, 32, 128};
    constexpr uint32_t kBudgets[] = {10'000, 40, 15}, kFreezing[] = {kNever, 120, 20};
    std::vector<Setting> out;
    for (const uint64_t size : kSizes)
        for (const uint32_t bodies : kBudgets)
            for (const uint32_t settle : kFreezing) {
                const int turned = int(size != 1) + int(bodies != 10'000) + int(settle != kNever);
                if (full || turned <= 1)
                    out.push_back({turned > 1         ? "several"
                                   : size != 1        ? "smallest piece"
                                   : bodies != 10'000 ? "budget"
                                   : settle != kNever ? "freezing"
                                                      : "reference",
                                   size, bodies, settle});
            }
    return out;
}

}  // namespace

Table debrisTradeoff(const Options& options) {
    Table table{"T4",
                "debris budgets: step ms against mass, momentum and image lost, compared with keeping all debris",
                {"varied", "smallest piece voxels", "max pieces", "settle after steps", "step ms", "pieces",
                 "mass dropped kg", "momentum dropped kg m/s", "image rms of 255"},
                {}};
    const Run reference = simulate({"reference", 1, 10'000, kNever}, options.seed, true);
    std::vector<Series> plot;
    double keepAll = 0.0, least = 1e30, dropped = 0.0;
    for (const Setting& setting : settingsOf(options.full)) {
        const Run seen = simulate(setting, options.seed, true);
        const Measured ms = measure(options.repeats, [&] { return simulate(setting, options.seed, false).stepMs; });
        const double rms = difference(seen.image, reference.image);
        table.add({setting.axis, std::to_string(setting.smallest), std::to_string(setting.bodies),
                   setting.settleSteps == kNever ? "never" : std::to_string(setting.settleSteps), ms.text(),
                   std::to_string(seen.pieces), fmt::format("{:.1f}", seen.massLost - reference.massLost),
                   fmt::format("{:.1f}", seen.momentumLost - reference.momentumLost), fmt::format("{:.2f}", rms)});
        if (keepAll == 0.0) keepAll = ms.median;  // the reference comes first
        if (ms.median < least) least = ms.median, dropped = seen.massLost - reference.massLost;
        auto series = std::find_if(plot.begin(), plot.end(), [&](const Series& s) { return s.name == setting.axis; });
        if (series == plot.end())
            series = plot.insert(plot.end(), {setting.axis, {}, setting.axis == std::string("several")});
        series->points.emplace_back(ms.median, seen.massLost - reference.massLost);
    }
    table.conclusion = fmt::format(
        "Keeping all debris takes {:.2f} ms per step; the cheapest setting takes {:.2f} ms and turns {:.0f} kg of "
        "debris to dust. Pieces fall chaotically: any change of settings changes the image by a similar amount.",
        keepAll, least, dropped);
    writePlot(options, "T4", "Debris: cost of a step against mass turned to dust", "ms per step",
              "kg turned to dust, compared with keeping all", plot);
    return table;
}

}  // namespace rubble::tradeoff
