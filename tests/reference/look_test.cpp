// Pictures for eyes: what the renderer draws beside the truth. Only with RUBBLE_PICTURES=FOLDER.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/flip.h"
#include "tests/reference/picture_file.h"
#include "tests/reference/relative_error.h"
#include "tests/reference/ssim.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

class Look : public GlTest {};

FloatImage asGray(const FloatImage& map) {
    FloatImage out(map.size);
    for (size_t i = 0; i < map.pixels.size(); ++i) out.pixels[i] = glm::vec4(glm::vec3(map.pixels[i].x), 1.0f);
    return out;
}

/// Least milliseconds of each pass over the pictures drawn: what else the machine does is left out as far as it can be.
class LeastTimes {
public:
    void add(const RenderFigures& figures) {
        for (const auto& [pass, ms] : figures.passMs) {
            const auto found =
                std::find_if(m_least.begin(), m_least.end(), [&, name = std::string(pass)](const auto& each) { return each.first == name; });
            if (found == m_least.end())
                m_least.emplace_back(pass, ms);
            else
                found->second = std::min(found->second, ms);
        }
    }
    void print() const {
        double sum = 0.0;
        for (const auto& [pass, ms] : m_least) printf("%s %.1f, ", pass.c_str(), ms), sum += ms;
        printf("all %.1f ms\n", sum);
    }

private:
    std::vector<std::pair<std::string, double>> m_least;
};

int numberFrom(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

TEST_F(Look, AtTheTruth) {
    const char* folder = std::getenv("RUBBLE_PICTURES");
    if (!folder) GTEST_SKIP() << "set RUBBLE_PICTURES to a folder to draw the views beside the truth";
    const int width = numberFrom("RUBBLE_WIDTH", 320), samples = numberFrom("RUBBLE_SAMPLES", 64), frames = numberFrom("RUBBLE_FRAMES", 16);
    std::vector<SceneView> views = tuningViews();
    if (numberFrom("RUBBLE_JUDGE", 0)) views = judgingViews();
    const std::string only = std::getenv("RUBBLE_VIEW") ? std::getenv("RUBBLE_VIEW") : "";
    for (SceneView& each : views) {
        if (each.name.find(only) == std::string::npos) continue;
        each.view.size = {width, width * 9 / 16};
        const Scene scene(each.snapshot);
        const Settings settings{.samples = samples, .filterPixels = true};
        const Picture truth = cachedRender(scene, each.view, settings, RUBBLE_BINARY_DIR "/reference", each.name);
        const char* shaders = std::getenv("RUBBLE_SHADERS");
        auto made = Renderer::create(testContext().loader(), shaders ? shaders : shaderFolder(), comparedSettings());
        ASSERT_TRUE(made) << made.error();
        (*made)->apply(FrameSnapshot(each.snapshot));
        const Offscreen target(each.view.size);
        each.view.framebuffer = target.framebuffer();
        LeastTimes times;
        for (int i = 0; i < frames; ++i) (*made)->draw(each.view, 1.0f), times.add((*made)->figures());
        times.print();
        const auto drawn = (*made)->readTarget("resolved");
        ASSERT_TRUE(drawn) << drawn.error();
        const float exposure = exposureFor(truth.mean, each.snapshot.environment.exposure);
        const FloatImage a = displayed(truth.mean, exposure), b = displayed(*drawn, exposure), map = flipMap(a, b);
        printf("%-20s FLIP %.4f  relMSE %.4f  SSIM %.4f\n", each.name.c_str(), flip(a, b), relativeError(truth.mean, *drawn), ssim(a, b));
        std::string file = each.name;
        std::replace(file.begin(), file.end(), ' ', '_');
        ASSERT_TRUE(writePng(std::string(folder) + "/" + file + ".png", tile({toImage(a), toImage(b), toImage(asGray(map))}, 1)));
    }
}

}  // namespace
}  // namespace rubble::reference
