// Images to look at: the renderer beside the reference. Only with RUBBLE_IMAGES=FOLDER.
// RUBBLE_WITHOUT=sun,sky,lights,bounce,mirrors,emission leaves parts of the light out of both;
// RUBBLE_PART=sun|sky|lights|mirrors shows one estimator.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "generated/paths.h"
#include "runtime/core/random.h"
#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/exr_file.h"
#include "tests/reference/flip.h"
#include "tests/reference/relative_error.h"
#include "tests/reference/ssim.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

class SideBySide : public GlTest {};

FloatImage asGray(const FloatImage& map) {
    FloatImage out(map.size);
    for (size_t i = 0; i < map.pixels.size(); ++i) out.pixels[i] = glm::vec4(glm::vec3(map.pixels[i].x), 1.0f);
    return out;
}

/// Least milliseconds of each pass over the frames, which other work on the machine disturbs least.
class MinTimes {
public:
    void add(const RenderStats& figures) {
        for (const auto& [pass, ms] : figures.passMs) {
            const auto found =
                std::find_if(m_min.begin(), m_min.end(),
                             [&, name = std::string(pass)](const auto& each) { return each.first == name; });
            if (found == m_min.end())
                m_min.emplace_back(pass, ms);
            else
                found->second = std::min(found->second, ms);
        }
    }
    void print() const {
        double sum = 0.0;
        for (const auto& [pass, ms] : m_min) printf("%s %.1f, ", pass.c_str(), ms), sum += ms;
        printf("all %.1f ms\n", sum);
    }

private:
    std::vector<std::pair<std::string, double>> m_min;
};

int numberFrom(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

/// Takes a part of the light out of both images, to see whether it causes a difference.
void remove(SceneView& each, RenderSettings& drawn, Settings& traced, const std::string& part) {
    FrameSnapshot& s = each.snapshot;
    if (part == "sun") s.environment.sunColor = glm::vec3(0.0f);
    if (part == "sky")
        s.environment.skyColor = s.environment.horizonColor = s.environment.groundColor = glm::vec3(0.0f);
    if (part == "lights") s.lights.clear();
    if (part == "bounce") drawn.bounce = false, traced.bounces = 0;
    if (part != "mirrors" && part != "emission") return;
    for (SnapshotShape& shape : s.created) {
        auto palette = std::make_shared<Palette>(*shape.palette);
        for (size_t i = 1; i < 256; ++i) {
            PaletteEntry& e = (*palette)[i];
            if (part == "mirrors") e.reflectivity = e.metallic = 0;
            if (part == "emission") e.emission = 0.0f;
        }
        shape.palette = palette;
    }
}

/// A part of the light: its name here, its term in the reference, its target in the renderer.
struct Part {
    const char* name;
    Term term;
    const char* target;
    bool alpha;
};
constexpr Part kParts[] = {{"whole", Term::Full, "resolved", false},
                           {"sun", Term::SunShare, "noisyLight", true},
                           {"sky", Term::Sky, "noisyLight", false},
                           {"lights", Term::LocalLights, "noisyLight", false},
                           {"mirrors", Term::Reflection, "reflection", false}};

const Part& partNamed(const std::string& name) {
    for (const Part& part : kParts)
        if (part.name == name) return part;
    return kParts[0];
}

/// Sets both up for one estimator alone, before any filter, at the centres of the pixels.
void select(const Part& part, RenderSettings& drawn, Settings& traced) {
    traced.term = part.term;
    if (part.term == Term::Full) return;
    traced.filterPixels = drawn.temporal = false;
    drawn.filterPasses = 0;
    drawn.sun = part.term == Term::SunShare, drawn.localLights = part.term == Term::LocalLights;
    drawn.sky = part.term == Term::Sky;
}

/// The last frame; for one estimator, the mean of all frames.
FloatImage drawnPart(Renderer& renderer, const View& view, const Part& part, int frames, MinTimes& times) {
    FloatImage sum;
    for (int i = 0; i < frames; ++i) {
        renderer.draw(view, 1.0f), times.add(renderer.stats());
        if (part.term == Term::Full && i + 1 < frames) continue;
        FloatImage image = std::move(*renderer.readTarget(part.target));
        if (part.alpha)
            for (glm::vec4& p : image.pixels) p = glm::vec4(p.a, 0.0f, 0.0f, 1.0f);
        if (sum.pixels.empty()) sum = FloatImage(image.size);
        const float share = part.term == Term::Full ? 1.0f : 1.0f / float(frames);
        for (size_t p = 0; p < image.pixels.size(); ++p) sum.pixels[p] += share * image.pixels[p];
    }
    return sum;
}

/// The reference with other random numbers: FLIP between the two measures the noise that is left in it.
FloatImage withOtherNoise(const Estimate& reference) {
    FloatImage again = reference.mean;
    Random random(1, 1);
    for (size_t p = 0; p < again.pixels.size(); ++p) {
        float normal = -6.0f;
        for (int i = 0; i < 12; ++i) normal += random.unit();
        again.pixels[p] += normal * glm::sqrt(2.0f * reference.variance.pixels[p] / float(reference.samples));
    }
    return again;
}

TEST_F(SideBySide, BesideTheReference) {
    const char* folder = std::getenv("RUBBLE_IMAGES");
    if (!folder) GTEST_SKIP() << "set RUBBLE_IMAGES to a folder for images of the renderer beside the reference";
    const int width = numberFrom("RUBBLE_WIDTH", 320), samples = numberFrom("RUBBLE_SAMPLES", 64),
              frames = numberFrom("RUBBLE_FRAMES", 16);
    std::vector<SceneView> views = tuningViews();
    if (numberFrom("RUBBLE_HELD_OUT", 0)) views = heldOutViews();
    const std::string only = std::getenv("RUBBLE_VIEW") ? std::getenv("RUBBLE_VIEW") : "";
    for (SceneView& each : views) {
        if (each.name.find(only) == std::string::npos) continue;
        each.view.size = {width, width * 9 / 16};
        Settings settings{.samples = samples, .filterPixels = true};
        RenderSettings drawnSettings = comparedSettings();
        drawnSettings.passTimes = true;
        drawnSettings.filterPasses = numberFrom("RUBBLE_PASSES", drawnSettings.filterPasses);
        drawnSettings.historyFrames = numberFrom("RUBBLE_HISTORY", drawnSettings.historyFrames);
        drawnSettings.skyDistance = float(numberFrom("RUBBLE_REACH", int(drawnSettings.skyDistance)));
        const Part& part = partNamed(std::getenv("RUBBLE_PART") ? std::getenv("RUBBLE_PART") : "whole");
        select(part, drawnSettings, settings);
        std::stringstream without(std::getenv("RUBBLE_WITHOUT") ? std::getenv("RUBBLE_WITHOUT") : "");
        for (std::string one; std::getline(without, one, ',');) remove(each, drawnSettings, settings, one);
        const Scene scene(each.snapshot);
        const Estimate reference = cachedRender(scene, each.view, settings, RUBBLE_BINARY_DIR "/reference", each.name);
        const char* shaders = std::getenv("RUBBLE_SHADERS");
        auto made = Renderer::create(testContext().loader(), shaders ? shaders : shaderFolder(), drawnSettings);
        ASSERT_TRUE(made) << made.error();
        (*made)->apply(FrameSnapshot(each.snapshot));
        const Offscreen target(each.view.size);
        each.view.framebuffer = target.framebuffer();
        MinTimes times;
        const FloatImage drawn = drawnPart(**made, each.view, part, frames, times);
        times.print();
        const float exposure = exposureFor(reference.mean, each.snapshot.environment.exposure);
        const FloatImage a = displayed(reference.mean, exposure), b = displayed(drawn, exposure), map = flipMap(a, b);
        printf("%-20s FLIP %.4f  relMSE %.4f  SSIM %.4f; the reference against itself FLIP %.4f\n", each.name.c_str(),
               flip(a, b), relativeError(reference.mean, drawn), ssim(a, b),
               flip(a, displayed(withOtherNoise(reference), exposure)));
        std::string file = each.name;
        std::replace(file.begin(), file.end(), ' ', '_');
        ASSERT_TRUE(writePng(std::string(folder) + "/" + file + ".png",
                             tile({toImage(a), toImage(b), toImage(asGray(map))}, 1)));
    }
}

}  // namespace
}  // namespace rubble::reference
