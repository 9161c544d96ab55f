// No view, however odd, leaves a NaN or an infinity in any target. RUBBLE_LONG=1 tries 10,000 views.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "render/gl/offscreen.h"
#include "runtime/core/random.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/town.h"
#include "tests/golden/finite_textures.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr int kViewsPerWorld = 250;  // then the level is loaded again
constexpr int kViewsPerReport = 50;  // of a long run

int viewCount() {
    return std::getenv("RUBBLE_LONG") ? 3334 : 12;
}

struct Weather {
    const char* name;
    void (*set)(Environment&);
};
const Weather kWeathers[] = {{"evening", [](Environment&) {}},
                             {"a night in fog",
                              [](Environment& e) {
                                  e.sunDirection = {0.3f, -0.4f, 0.2f};
                                  e.sunColor = glm::vec3(0.0f);
                                  e.skyColor = e.horizonColor = glm::vec3(0.01f, 0.012f, 0.02f);
                                  e.stars = 1.0f;
                                  e.fogDensity = 0.05f;
                              }},
                             {"the sun overhead after rain", [](Environment& e) {
                                  e.sunDirection = {0.0f, 1.0f, 0.0f};
                                  e.wetness = 1.0f;
                                  e.clouds = 1.0f;
                              }}};

class RandomView : public GlTest, public testing::WithParamInterface<int> {};

/// From the air, from inside the ground and the houses, from far away; field of view 1 to 179 degrees.
View randomView(Random& random, unsigned framebuffer) {
    View view;
    for (int a = 0; a < 3; ++a) view.position[a] = random.unit() * 70.0 - 3.0;
    const uint32_t where = random.below(8);
    view.position.y = where < 2   ? random.unit() * 0.9 - 0.4
                      : where < 7 ? random.unit() * 12.0
                                  : random.unit() * 4000.0 - 2000.0;
    for (int i = 0; i < 4; ++i) view.rotation[i] = random.unit() - 0.5;
    view.rotation = random.below(8) ? glm::normalize(view.rotation) : glm::dquat(1, 0, 0, 0);
    const int degrees = random.below(4) ? random.between(1, 179) : random.below(2) ? 1 : 179;
    view.verticalFov = float(degrees) * 0.0174532925f;
    view.size = kSize;
    view.framebuffer = framebuffer;
    view.cut = random.below(3) == 0;
    return view;
}

TEST_P(RandomView, AllTargetsAreFinite) {
    Random random(7, uint64_t(GetParam()));
    Level town = makeTown(1);
    kWeathers[GetParam()].set(town.environment);
    auto renderer = Renderer::create(testContext().loader(), shaderFolder(), {});
    ASSERT_TRUE(renderer) << renderer.error();
    const Offscreen target(kSize);
    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.waitForShadow = true;
    FrameLoop loop(settings);
    for (int i = 0; i < viewCount(); ++i) {
        if (i % kViewsPerWorld == 0) loop.load(town);
        if (random.below(4) == 0) {
            const double x = random.unit() * 64, y = random.unit() * 8, z = random.unit() * 64;
            loop.edits().push(Edit(ExplodeEdit{{x, y, z}, 0.5 + random.unit() * 2.0}));
        }
        loop.step();
        const View view = randomView(random, target.framebuffer());
        loop.draw(*renderer.value(), view, float(random.unit()));
        const std::string bad = nonFiniteTextures();
        ASSERT_EQ(bad, "") << kWeathers[GetParam()].name << ", view " << i << " from " << view.position.x << ", "
                           << view.position.y << ", " << view.position.z << ", turned " << view.rotation.w << ' '
                           << view.rotation.x << ' ' << view.rotation.y << ' ' << view.rotation.z << ", fov "
                           << view.verticalFov;
        if (const int views = i + 1; std::getenv("RUBBLE_LONG") && views % kViewsPerReport == 0) {
            std::printf("%s: %d of %d views, %.0f s of processor time\n", kWeathers[GetParam()].name, views,
                        viewCount(), double(std::clock()) / CLOCKS_PER_SEC);
            std::fflush(stdout);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Weathers, RandomView, testing::Range(0, int(std::size(kWeathers))));

}  // namespace
}  // namespace rubble
