#include <fmt/format.h>

#include <algorithm>

#include "render/gl/gl.h"
#include "samples/support/gl_context.h"
#include "tests/benchmark/world_rays/scenes.h"
#include "tests/benchmark/world_rays/walks.h"
#include "tests/tradeoff/light.h"

namespace rubble::tradeoff {
namespace {

using namespace rays;

struct Figures {
    double nanoseconds = 0.0, falseLight = 0.0, falseShadow = 0.0;  ///< ns per ray; rays in a million
};

Figures figuresOf(Walks& walks, const std::string& walk, const RaySet& set, int repeats) {
    TraceResult answers;
    const Measured time = measure(repeats, [&] {
        answers = walks.trace(walk, set);
        return answers.milliseconds;
    });
    Figures out;
    out.nanoseconds = time.median * 1e6 / double(set.count);
    for (size_t i = 0; i < set.rays.size(); ++i) {
        if (answers.stopped[i] == set.stopped[i]) continue;
        (set.stopped[i] ? out.falseLight : out.falseShadow) += 1e6 / double(set.count);
    }
    return out;
}

}  // namespace

Table walkTradeoff(const Options& options) {
    Table table{"T7",
                "walks through the shadow volume: the exact walk and Teardown's, by length of the rays",
                {"walk", "distance m", "ns per ray", "false light per million", "false shadow per million", "MB"},
                {}};
    table.note =
        "Ambient rays from the street view of a city of 1024 x 256 x 1024 cells, 640 x 360, llvmpipe in one thread. "
        "Sparse and super sparse as in Teardown: 2x2x2 cells in a byte, full, half and quarter resolution, in a 3D "
        "texture or in a buffer. Reference: a walk in doubles, cell by cell.";
    disableGlThreads();
    auto context = GlContext::create(GlContext::Kind::OsMesa);
    if (!context || !loadGl(context.value()->loader())) {
        table.failed = true;
        table.conclusion = "Not measured: no OpenGL context by OSMesa (Debian package libosmesa6).";
        return table;
    }
    const RayScene scene = cityScene();
    Walks walks(scene.bits, scene.patches);
    std::vector<double> distances =
        options.full ? std::vector<double>{30, 60, 120, 240, 480, 960} : std::vector<double>{60, 240, 960};
    std::vector<Series> series;
    double exact = 0.0, superSparse = 0.0, wrong = 0.0, missed = 0.0;
    for (const std::string& walk : Walks::names()) series.push_back({walk, {}});
    for (const double distance : distances) {
        const RaySet set = makeRays(scene.bits, scene.views[0], RayKind::Ambient, distance);
        for (size_t k = 0; k < Walks::names().size(); ++k) {
            const std::string& walk = Walks::names()[k];
            const Figures figures = figuresOf(walks, walk, set, options.repeats);
            table.add({walk, fmt::format("{:g}", distance * 0.1), fmt::format("{:.0f}", figures.nanoseconds),
                       fmt::format("{:.0f}", figures.falseLight), fmt::format("{:.0f}", figures.falseShadow),
                       fmt::format("{:.1f}", double(walks.bytes(walk)) / 1e6)});
            series[k].points.emplace_back(distance * 0.1, figures.nanoseconds);
            if (k == 0) wrong += figures.falseLight + figures.falseShadow;
            if (distance == 240.0 && k == 0) exact = figures.nanoseconds;
            if (distance == 240.0 && k == 1)
                superSparse = figures.nanoseconds, missed = figures.falseLight + figures.falseShadow;
        }
    }
    table.conclusion = fmt::format(
        "At 24 m the exact walk takes {:.2f} of the time of super sparse, which is wrong for {:.0f} rays in a million; "
        "the exact walk is wrong for {:.0f} (grazing rays).",
        exact / superSparse, missed, wrong);
    writePlot(options, "T7", "Walks: time per ray, by its length", "m", "ns per ray", series);
    return table;
}

}  // namespace rubble::tradeoff
