#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <glm/gtc/packing.hpp>

#include "tests/reference/display.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(320, 180);

float half(float v) {
    return glm::unpackHalf1x16(glm::packHalf1x16(v));
}

glm::vec3 octahedral(glm::vec3 n, float steps) {
    glm::vec2 p = glm::vec2(n) / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (n.z < 0.0f) p = (1.0f - glm::abs(glm::vec2(p.y, p.x))) * glm::vec2(p.x < 0 ? -1 : 1, p.y < 0 ? -1 : 1);
    p = glm::round((p * 0.5f + 0.5f) * steps) / steps * 2.0f - 1.0f;
    glm::vec3 v(p, 1.0f - std::abs(p.x) - std::abs(p.y));
    if (v.z < 0.0f) {
        const glm::vec2 q = (1.0f - glm::abs(glm::vec2(v.y, v.x))) * glm::vec2(v.x < 0 ? -1 : 1, v.y < 0 ? -1 : 1);
        v.x = q.x, v.y = q.y;
    }
    return glm::normalize(v);
}

/// Mean and largest error of a format over all pixels that show a surface.
struct Errors {
    double mean = 0.0, largest = 0.0;
};
Errors errorsOf(const FloatImage& image, const FloatImage& depth,
                const std::function<double(const glm::vec4&)>& error) {
    Errors errors;
    int count = 0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        if (depth.pixels[i].x > 1e4f) continue;
        const double e = error(image.pixels[i]);
        errors.mean += e, errors.largest = std::max(errors.largest, e);
        ++count;
    }
    errors.mean /= std::max(count, 1);
    return errors;
}

double degreesBetween(glm::vec3 a, glm::vec3 b) {
    return glm::degrees(std::acos(std::min(1.0, double(glm::dot(glm::normalize(a), glm::normalize(b))))));
}

/// How far a format moves the displayed radiance, in steps of 255.
Errors displayErrors(const FloatImage& radiance, const FloatImage& depth,
                     const std::function<glm::vec3(glm::vec3)>& store) {
    FloatImage stored = radiance;
    for (glm::vec4& p : stored.pixels) p = glm::vec4(store(glm::vec3(p)), 1.0f);
    const FloatImage a = reference::displayed(radiance, 1.0f), b = reference::displayed(stored, 1.0f);
    FloatImage off(kSize);
    for (size_t i = 0; i < off.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            off.pixels[i].x = std::max(off.pixels[i].x, 255.0f * std::abs(a.pixels[i][c] - b.pixels[i][c]));
    return errorsOf(off, depth, [](const glm::vec4& v) { return double(v.x); });
}

}  // namespace

Table gbufferTradeoff(const Options&) {
    Table table{"T10-gbuffer",
                "formats of the G-buffer and of light: error of the stored values",
                {"target", "format", "bytes", "unit", "mean error", "max error"},
                {}};
    table.note =
        "The street in the evening, 320x180: values as drawn, rounded to each format. A shadow ray must start within 1 "
        "mm of its surface, or surfaces shadow themselves. Steps of 255: how far a format moves displayed values; "
        "banding is visible beyond one step.";
    const reference::SceneView street = reference::tuningViews(false)[0];
    RenderSettings settings = reference::comparedSettings();
    LightBench bench(street.snapshot, street.view, kSize, settings);
    bench.draw(16);
    const FloatImage depth = bench.read("depth"), normal = bench.read("normal"), radiance = bench.read("radiance");
    const auto add = [&](const char* target, const char* format, int bytes, const char* unit, const Errors& e) {
        table.add({target, format, std::to_string(bytes), unit, fmt::format("{:.3g}", e.mean),
                   fmt::format("{:.3g}", e.largest)});
        return e;
    };
    add("depth", "R32F (drawn)", 4, "mm", errorsOf(depth, depth, [](const glm::vec4& v) {
            return 1e3 * (double(std::nextafter(v.x, 1e9f)) - v.x) * 0.5;
        }));
    const Errors halfDepth =
        add("depth", "R16F", 2, "mm",
            errorsOf(depth, depth, [](const glm::vec4& v) { return 1e3 * std::abs(half(v.x) - v.x); }));
    add("depth", "R16F of 1/depth", 2, "mm",
        errorsOf(depth, depth, [](const glm::vec4& v) { return 1e3 * std::abs(1.0 / half(1.0f / v.x) - v.x); }));
    add("normal", "RGBA16F (drawn)", 8, "degrees", errorsOf(normal, depth, [](const glm::vec4& v) {
            return degreesBetween({half(v.x), half(v.y), half(v.z)}, glm::vec3(v));
        }));
    for (const auto& [name, bytes, steps] :
         {std::tuple{"octahedral 2x16", 4, 65535.0f}, {"octahedral 2x12", 3, 4095.0f}, {"octahedral 2x8", 2, 255.0f}})
        add("normal", name, bytes, "degrees", errorsOf(normal, depth, [s = steps](const glm::vec4& v) {
                return degreesBetween(octahedral(glm::vec3(v), s), glm::vec3(v));
            }));
    const auto addRadiance = [&](const char* format, int bytes, const std::function<glm::vec3(glm::vec3)>& store) {
        return add("radiance", format, bytes, "steps of 255", displayErrors(radiance, depth, store));
    };
    addRadiance("RGBA16F (drawn)", 8, [](glm::vec3 v) { return glm::vec3(half(v.x), half(v.y), half(v.z)); });
    addRadiance("R11F_G11F_B10F", 4, [](glm::vec3 v) { return glm::unpackF2x11_1x10(glm::packF2x11_1x10(v)); });
    const Errors shared =
        addRadiance("RGB9_E5", 4, [](glm::vec3 v) { return glm::unpackF3x9_E1x5(glm::packF3x9_E1x5(v)); });
    table.conclusion = fmt::format(
        "Depth needs 32 bits: in 16 its error is up to {:.1f} mm. Radiance would change by at most {:.2f} steps in "
        "RGB9_E5 at half the bytes.",
        halfDepth.largest, shared.largest);
    return table;
}

}  // namespace rubble::tradeoff
