#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/golden/lit_scene.h"
#include "tests/reference/path_tracer.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(48, 32);

Outcome judge(double value, double stable, double degraded) {
    return value <= stable ? Outcome::Stable : value <= degraded ? Outcome::Degraded : Outcome::Failed;
}

PaletteRef gray(uint8_t roughness) {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& e = (*palette)[1];
    e.red = e.green = e.blue = 120;
    e.roughness = roughness, e.reflectivity = 20, e.material = 1;
    return palette;
}

uint8_t solid(glm::ivec3) {
    return 1;
}

/// The stable range of a map's row as text: up to the last value before the first one that is not stable.
std::string stableRange(const std::vector<std::pair<std::string, Outcome>>& row) {
    std::string last;
    for (const auto& [value, outcome] : row) {
        if (outcome != Outcome::Stable)
            return last.empty() ? fmt::format("not at {}: {}", value, nameOf(outcome))
                                : fmt::format("up to {}, {} at {}", last, nameOf(outcome), value);
        last = value;
    }
    return fmt::format("up to {}, the largest value tried", last);
}

/// Relative error of the mean radiance of a floor that one sphere light over it lights.
double sphereLightError(uint8_t roughness, float radius) {
    LitScene scene(gray(roughness));
    Environment& air = scene.environment;
    air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
    air.fogDistance = 1e6f;
    scene.add({60, 1, 60}, {{-3, -0.1, -3}}, solid);
    scene.addLight({LightKind::Sphere, {0.3, 1.2, -1.0}, {0, -1, 0}, {4, 4, 4}, radius, 100.0f, 0.6f, 1.1f});
    Camera camera;
    camera.position = {0.0, 1.6, 2.2};
    camera.lookAt({0, 0, -0.6});
    RenderSettings settings = reference::comparedSettings();
    LightBench bench(scene.snapshot(), camera.view(kSize, 0), kSize, settings);
    bench.draw(24);
    View view = camera.view(kSize, 0);
    const FloatImage drawn = bench.read("resolved"), depth = bench.read("depth");
    const FloatImage referenceImage =
        reference::render(reference::Scene(scene.snapshot()), view, {.samples = 192, .filterPixels = true}).mean;
    double off = 0.0, all = 0.0;
    for (size_t p = 0; p < referenceImage.pixels.size(); ++p) {
        if (depth.pixels[p].x > 1e3f) continue;
        off += drawn.pixels[p].y - referenceImage.pixels[p].y, all += referenceImage.pixels[p].y;
    }
    return std::abs(off) / std::max(all, 1e-6);
}

/// Share of pixels that show another surface than an exact ray hits, in a view that is `distance` metres from the
/// origin.
double visibilityError(double distance, float degrees) {
    LitScene scene(gray(255));
    const glm::dvec3 origin(distance, 0, -distance);
    scene.add({60, 2, 60}, {origin + glm::dvec3(-3, -0.2, -3)}, solid);
    scene.add({10, 20, 10}, {origin + glm::dvec3(0.5, 0, -0.5)}, solid);
    scene.add({6, 6, 6},
              {origin + glm::dvec3(-1.2, 0.4, 0.2), glm::angleAxis(0.6, glm::normalize(glm::dvec3(0.3, 1, 0.2)))},
              solid);
    Camera camera;
    camera.position = origin + glm::dvec3(0.2, 1.5, 3.0);
    camera.lookAt(origin + glm::dvec3(0, 0.5, 0));
    camera.verticalFov = glm::radians(degrees);
    RenderSettings settings = reference::comparedSettings();
    settings.temporal = false;
    View view = camera.view(kSize, 0);
    LightBench bench(scene.snapshot(), view, kSize, settings);
    bench.draw(1);
    const FloatImage depth = bench.read("depth");
    const reference::Scene exact(scene.snapshot());
    int differ = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const glm::dvec2 p = (glm::dvec2(x, y) + 0.5) / glm::dvec2(kSize) * 2.0 - 1.0;
            const double tanY = std::tan(double(camera.verticalFov) * 0.5), tanX = tanY * kSize.x / kSize.y;
            const glm::dvec3 ray = camera.rotation() * glm::dvec3(p.x * tanX, p.y * tanY, -1.0);
            const reference::Surface s = exact.closest({camera.position, glm::normalize(ray)});
            const double expected = s.t / glm::length(ray), drawn = depth.at(x, y).x;
            differ += s.hit ? std::abs(expected - drawn) > 2e-3 * expected + 2e-3 : drawn < 1e4;
        }
    return double(differ) / (kSize.x * kSize.y);
}

/// Mean error of the sun's share behind the edge of a roof.
double penumbraError(float radians, double height) {
    LitScene scene(gray(255));
    scene.environment.sunDirection = {0.0f, 1.0f, 0.0f};
    scene.environment.sunAngle = radians;
    scene.add({80, 1, 80}, {{-4, -0.1, -4}}, solid);
    scene.add({40, 1, 80}, {{-4, height, -4}}, solid);
    Camera camera;
    camera.position = {0.0, std::min(1.5, 0.8 * height), 0.001};
    camera.lookAt({0, 0, 0});
    RenderSettings settings = reference::comparedSettings();
    View view = camera.view(kSize, 0);
    LightBench bench(scene.snapshot(), view, kSize, settings);
    bench.draw(32);
    const FloatImage light = bench.read("denoisedLight");
    const FloatImage referenceImage =
        reference::render(reference::Scene(scene.snapshot()), view, {.term = reference::Term::SunShare, .samples = 192})
            .mean;
    double off = 0.0;
    for (size_t p = 0; p < referenceImage.pixels.size(); ++p)
        off += std::abs(double(light.pixels[p].a) - referenceImage.pixels[p].x);
    return off / double(referenceImage.pixels.size());
}

}  // namespace

Table sphereLightMap(const Options& options) {
    Table table{"T13-sphere-light",
                "sphere lights over floors of any roughness",
                {"roughness", "radius m", "error %", "outcome"},
                {}};
    table.note =
        "Mean radiance of a floor that one sphere light lights, one ray per pixel, 24 frames, against the reference. "
        "Stable: within 3 %; degraded: 15 %.";
    std::vector<MapCell> cells;
    int stable = 0;
    for (const int roughness : {10, 40, 80, 110, 140, 180, 255}) {
        std::vector<std::pair<std::string, Outcome>> row;
        const std::string name = fmt::format("{:.2f}", roughness / 255.0);
        for (const float radius : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f, 0.8f}) {
            const double error = sphereLightError(uint8_t(roughness), radius);
            const Outcome outcome = judge(error, 0.03, 0.15);
            const std::string x = fmt::format("{:g} m", radius);
            cells.push_back({x, name, outcome, fmt::format("{:.1f} %", error * 100)});
            table.add({name, fmt::format("{:g}", radius), fmt::format("{:.2f}", error * 100), nameOf(outcome)});
            row.emplace_back(x, outcome);
            stable += outcome == Outcome::Stable;
        }
        table.envelope.push_back({name, stableRange(row)});
    }
    table.conclusion = fmt::format("{} of {} are within 3 %.", stable, cells.size());
    writeMap(options, "T13-sphere-light", "T13-sphere-light: error of a floor's radiance", "radius of the light",
             "roughness of the floor", cells, {"within 3 %", "within 15 %", "more", nullptr});
    return table;
}

Table visibilityMap(const Options& options) {
    Table table{"T13-visibility",
                "visible surfaces, by distance from the origin and angle of view",
                {"vertical angle", "km", "wrong pixels %", "outcome"},
                {}};
    table.note =
        "Pixels whose depth differs from the exact ray's by more than 2 mm and 0.2 %. Stable: 1 %; degraded: 5 %.";
    std::vector<MapCell> cells;
    int stable = 0;
    for (const float degrees : {1.0f, 10.0f, 60.0f, 120.0f, 160.0f, 179.0f}) {
        std::vector<std::pair<std::string, Outcome>> row;
        const std::string name = fmt::format("{:g} degrees", degrees);
        for (const double distance : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7}) {
            const double error = visibilityError(distance, degrees);
            const Outcome outcome = judge(error, 0.01, 0.05);
            const std::string x = fmt::format("{:g} km", distance * 1e-3);
            cells.push_back({x, name, outcome, fmt::format("{:.2f} %", error * 100)});
            table.add(
                {name, fmt::format("{:g}", distance * 1e-3), fmt::format("{:.2f}", error * 100), nameOf(outcome)});
            row.emplace_back(x, outcome);
            stable += outcome == Outcome::Stable;
        }
        table.envelope.push_back({name, stableRange(row)});
    }
    table.conclusion = fmt::format("{} of {} show at most 1 % of wrong pixels.", stable, cells.size());
    writeMap(options, "T13-visibility", "T13-visibility: pixels that show the wrong place", "distance from the origin",
             "vertical angle of view", cells, {"up to 1 %", "up to 5 %", "more", nullptr});
    return table;
}

Table penumbraMap(const Options& options) {
    Table table{"T13-penumbra",
                "the sun's shadow behind an edge",
                {"height of the edge", "sun's radius", "error", "outcome"},
                {}};
    table.note =
        "Mean error of the sun's share against the reference, one ray per pixel, filtered, 32 frames, by the height of "
        "the edge and the angular radius of the sun. Stable: 0.02; degraded: 0.06.";
    std::vector<MapCell> cells;
    int stable = 0;
    for (const double height : {0.4, 1.6, 6.4, 25.6}) {
        std::vector<std::pair<std::string, Outcome>> row;
        const std::string name = fmt::format("{:g} m", height);
        for (const float radians : {0.0f, 0.0047f, 0.02f, 0.1f, 0.4f}) {
            const double error = penumbraError(radians, height);
            const Outcome outcome = judge(error, 0.02, 0.06);
            const std::string x = fmt::format("{:g} rad", radians);
            cells.push_back({x, name, outcome, fmt::format("{:.3f}", error)});
            table.add({name, fmt::format("{:g}", radians), fmt::format("{:.4f}", error), nameOf(outcome)});
            row.emplace_back(x, outcome);
            stable += outcome == Outcome::Stable;
        }
        table.envelope.push_back({name, stableRange(row)});
    }
    table.conclusion = fmt::format("{} of {} are within 0.02 of the sun's share.", stable, cells.size());
    writeMap(options, "T13-penumbra", "T13-penumbra: error of the sun's share behind an edge",
             "angular radius of the sun", "height of the edge", cells, {"within 0.02", "within 0.06", "more", nullptr});
    return table;
}

}  // namespace rubble::tradeoff
