// bench_world_rays [SCENE...] [--repeats N] [--edits N] [--worker]: the exact walk against Teardown's on the GL, in one
// process. See walks.h.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "render/gl/gl.h"
#include "samples/support/gl_context.h"
#include "tests/benchmark/world_rays/demolition.h"
#include "tests/benchmark/world_rays/scenes.h"
#include "tests/benchmark/world_rays/walks.h"

using namespace rubble;
using namespace rubble::rays;

namespace {

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Total {
    double milliseconds = 0.0;
    size_t falseLight = 0, falseShadow = 0, grazing = 0, rays = 0;
};

std::vector<RaySet> setsOf(const RayScene& scene) {
    std::vector<RaySet> sets;
    for (const RayView& view : scene.views)
        for (const RayKind kind : {RayKind::Ambient, RayKind::Sun, RayKind::Local})
            sets.push_back(makeRays(scene.bits, view, kind));
    return sets;
}

/// Traces all rays of all sets. The walks take turns, so that other work on the machine disturbs all alike.
std::vector<Total> measure(Walks& walks, const WorldBits& bits, glm::ivec3 shift, const std::vector<RaySet>& sets,
                           const std::vector<std::string>& names, int repeats) {
    std::vector<Total> totals(names.size());
    for (const RaySet& set : sets) {
        std::vector<std::vector<double>> times(names.size());
        for (int repeat = 0; repeat <= repeats; ++repeat)
            for (size_t k = 0; k < names.size(); ++k) {
                const TraceResult answers = walks.trace(names[k], set);
                if (repeat) {
                    times[k].push_back(answers.milliseconds);
                    continue;
                }
                Total& total = totals[k];
                total.rays += set.count;
                for (size_t i = 0; i < set.rays.size(); ++i) {
                    if (answers.stopped[i] == set.stopped[i]) continue;
                    const bool grazes = k == 0 && isGrazing(bits, set.rays[i], shift);
                    ++(grazes ? total.grazing : set.stopped[i] ? total.falseLight : total.falseShadow);
                }
            }
        for (size_t k = 0; k < names.size(); ++k) totals[k].milliseconds += median(times[k]);
    }
    return totals;
}

void print(const std::string& title, const Walks& walks, const std::vector<std::string>& names,
           const std::vector<Total>& totals) {
    fmt::print("{}: {} rays\n", title, totals[0].rays);
    for (size_t k = 0; k < names.size(); ++k) {
        const Total& t = totals[k];
        fmt::print(
            "  {:20} {:7.1f} ms {:6.0f} ns a ray   exact/this {:.2f}   false light {:6.3f} %  shadow {:6.3f} %   "
            "{:.2f} MB{}\n",
            names[k], t.milliseconds, t.milliseconds * 1e6 / double(t.rays), totals[0].milliseconds / t.milliseconds,
            100.0 * double(t.falseLight) / double(t.rays), 100.0 * double(t.falseShadow) / double(t.rays),
            double(walks.bytes(names[k])) / 1e6,
            k ? "" : fmt::format("   {} wrong, {} grazing", t.falseLight + t.falseShadow, t.grazing));
    }
}

/// Prints the ratios again without the benchmark's own time, and with the exact walk reduced to one step.
void printNet(const std::vector<std::string>& names, const std::vector<Total>& totals, const Total& setUp,
              const Total& noWalk) {
    const auto net = [&](const Total& t) { return t.milliseconds - noWalk.milliseconds; };
    fmt::print("  without the bench's own {:.1f} ms:", noWalk.milliseconds);
    for (size_t k = 1; k < names.size(); ++k)
        fmt::print(" exact/{} {:.2f} ({:.2f} if it made one step),", names[k], net(totals[0]) / net(totals[k]),
                   net(setUp) / net(totals[k]));
    fmt::print("\n");
}

const std::vector<std::string> kExactOnly(Walks::names().begin(), Walks::names().begin() + 1);

/// Traces the scene's rays in the changed world, and in the same world as if all that moves were at rest.
void runChanged(const std::string& what, const RayScene& scene, Walks& walks, Demolition& demolition,
                std::vector<RaySet> sets, int repeats, double untouchedMs) {
    walks.apply(demolition.takePatches());
    const WorldBits bits = demolition.bits();
    const glm::ivec3 shift = scene.bits.low - bits.low;
    for (RaySet& set : sets) findReference(bits, set, shift);
    const std::vector<Total> totals = measure(walks, bits, shift, sets, kExactOnly, repeats);
    walks.apply(demolition.patchesAtRest());
    const std::vector<Total> atRest = measure(walks, bits, shift, sets, kExactOnly, repeats);
    walks.apply(demolition.patchesNow());
    const double ms = totals[0].milliseconds;
    print(
        fmt::format("{}, {}: worker {:.2f} ms a step; {:.2f} of the time untouched, {:.2f} of that of the same at rest",
                    scene.name, what, demolition.workerMs(50), ms / untouchedMs, ms / atRest[0].milliseconds),
        walks, kExactOnly, totals);
}

void run(const RayScene& scene, int repeats, int edits) {
    const std::vector<RaySet> sets = setsOf(scene);
    Walks walks(scene.bits, scene.patches);
    const glm::ivec3 n = scene.bits.cells();
    const std::vector<Total> rest = measure(walks, scene.bits, glm::ivec3(0), sets, Walks::names(), repeats);
    const std::vector<Total> baselines = measure(walks, scene.bits, glm::ivec3(0), sets, Walks::baselines(), repeats);
    print(fmt::format("{}, {} x {} x {} cells", scene.name, n.x, n.y, n.z), walks, Walks::names(), rest);
    printNet(Walks::names(), rest, baselines[0], baselines[1]);
    if (!edits) return;
    Demolition demolition(scene, 300);
    for (int i = 0; i < edits; ++i) demolition.step(1, false);
    runChanged(fmt::format("after {} edits, 300 bodies asleep", edits), scene, walks, demolition, sets, repeats,
               rest[0].milliseconds);
    for (int i = 0; i < 60; ++i) demolition.step(0, true);
    runChanged("300 bodies moving", scene, walks, demolition, sets, repeats, rest[0].milliseconds);
}

/// Times the shadow worker with moving cubes.
void runWorker(const RayScene& scene) {
    for (const int bodies : {50, 150, 300, 1000}) {
        constexpr int kSteps = 45;
        Demolition demolition(scene, bodies);
        demolition.takePatches();
        size_t bricks = 0;
        for (int i = 0; i < kSteps; ++i) {
            demolition.step(0, true);
            bricks = demolition.takePatches().size();
        }
        fmt::print("{}, {} pieces of 8^3 to 32^3 moving: worker {:.2f} ms a step, {} bricks\n", scene.name, bodies,
                   demolition.workerMs(40), bricks);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names{"town", "city", "model"};
    int repeats = 5, edits = 0;
    bool worker = false;
    std::string gl = "osmesa";
    CLI::App app{"Rays through the shadow volume", "bench_world_rays"};
    app.add_option("scenes", names, "town, city, model, wide")->capture_default_str();
    app.add_option("--repeats", repeats, "of each measurement; the median counts")->capture_default_str();
    app.add_option("--edits", edits, "measure again after so many edits, and with 300 moving bodies")
        ->capture_default_str();
    app.add_flag("--worker", worker, "only time the shadow worker with moving bodies");
    app.add_option("--gl", gl, "osmesa, egl or auto")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    setvbuf(stdout, nullptr, _IOLBF, 0);
    disableGlThreads();
    auto context = GlContext::create(GlContext::kindOf(gl));
    if (!context || !loadGl(context.value()->loader())) return 1;
    for (const std::string& name : names) {
        const RayScene scene = name == "town"   ? townScene()
                               : name == "city" ? cityScene()
                               : name == "wide" ? wideCityScene(3)
                                                : modelScene();
        if (scene.views.empty()) continue;
        worker ? runWorker(scene) : run(scene, std::max(repeats, 1), edits);
    }
    return 0;
}
