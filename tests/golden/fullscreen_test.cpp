// Full-screen passes must write the same numbers as fragment and as compute programs, in every target.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "render/shader_library/fullscreen_choice.h"
#include "runtime/core/log.h"
#include "tests/golden/drawing.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 64);

/// In drawing order: the first that differs names the pass.
constexpr const char* kTargets[] = {"albedo",           "material",    "noisyLight",    "specular",
                                    "changedLight",     "lightOffset", "fastHistory",   "historyConfidence",
                                    "accumulatedLight", "surface",     "denoisedLight", "reflection",
                                    "radiance",         "fogLight",    "fog",           "resolved",
                                    "bloom0",           "exposure",    "final"};
const std::vector<std::string> kPasses = {"wetness", "sun",         "sky",       "local lights", "accumulate",
                                          "filter",  "reflections", "composite", "fog",          "taa",
                                          "bloom",   "exposure",    "tonemap"};

/// A scene that needs every pass: sun, sky, lights, wet ground, glass, mirrors, fog.
LitScene fullScene() {
    LitScene scene = streetScene();
    scene.environment.wetness = 0.8f;
    scene.environment.fogDensity = 0.02f;
    SnapshotLight light{LightKind::Sphere, {-1.0, 2.0, -3.0}, {0, -1, 0}, {4.0f, 9.0f, 14.0f}, 0.1f, 6.0f, 0.0f, 0.0f};
    light.light = LightHandle::make(1, 1, 0);
    scene.addLight(light);
    return scene;
}

FrameSnapshot withWater(const LitScene& scene) {
    FrameSnapshot snapshot = scene.snapshot();
    Water water;
    water.outline = {{0.5, -8.0}, {6.0, -8.0}, {6.0, -4.5}, {0.5, -4.5}};
    water.surface = 0.15;
    snapshot.waters = {water};
    snapshot.watersChanged = true;
    return snapshot;
}

/// How many numbers of two targets differ, and by how much at most.
struct TargetDifference {
    int numbers = 0, clearly = 0;  ///< clearly: by more than 1 %
    float largest = 0.0f;
};

TargetDifference targetDifference(const FloatImage& a, const FloatImage& b) {
    TargetDifference found;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            if (std::memcmp(&a.pixels[i][c], &b.pixels[i][c], sizeof(float)) == 0) continue;
            ++found.numbers;
            const float difference = std::abs(a.pixels[i][c] - b.pixels[i][c]);
            found.largest = std::max(found.largest, difference);
            found.clearly += difference > 0.01f + 0.01f * std::abs(a.pixels[i][c]);
        }
    return found;
}

GLint g_minor = 3;
void reportVersionFour(GLenum name, GLint* value) {
    if (name == GL_MAJOR_VERSION)
        *value = 4;
    else if (name == GL_MINOR_VERSION)
        *value = g_minor;
    else
        reinterpret_cast<PFNGLGETINTEGERVPROC>(testContext().loader()("glGetIntegerv"))(name, value);
}
void* loaderWithOtherVersion(const char* name) {
    return std::strcmp(name, "glGetIntegerv") == 0 ? reinterpret_cast<void*>(&reportVersionFour)
                                                   : testContext().loader()(name);
}

class FullscreenTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!hasCompute()) GTEST_SKIP() << "no GL 4.3";
        setLogSink([](void* lines, LogLevel,
                      std::string_view text) { static_cast<std::vector<std::string>*>(lines)->emplace_back(text); },
                   &m_lines);
    }
    void TearDown() override {
        setLogSink(nullptr, nullptr);
        GlTest::TearDown();
    }
    auto logCount(std::string_view text) const {
        return std::count_if(m_lines.begin(), m_lines.end(),
                             [&](const std::string& line) { return line.find(text) != std::string::npos; });
    }
    std::unique_ptr<Renderer> make(Fullscreen fullscreen, FrameSnapshot snapshot, RenderSettings settings = {},
                                   GlLoader loader = nullptr) {
        settings.fullscreen = fullscreen;
        auto made = Renderer::create(loader ? loader : testContext().loader(), m_shaders, settings);
        if (!made) {
            ADD_FAILURE() << made.error();
            return nullptr;
        }
        made.value()->apply(std::move(snapshot));
        return std::move(made).value();
    }
    static void draw(Renderer& renderer, glm::ivec2 size, int frame = 0) {
        const Offscreen target(size);
        Camera camera = streetCamera(0);
        camera.position.x += 0.02 * frame;
        renderer.draw(camera.view(size, target.framebuffer()), 1.0f);
        glFinish();  // a GPU's times are ready for the next frame then
    }
    /// Draws the same frames with both and compares every target after each.
    static void expectSame(Renderer& a, Renderer& b, glm::ivec2 size, int frames, float tolerance = 0.0f) {
        for (int frame = 0; frame < frames; ++frame) {
            for (Renderer* each : {&a, &b}) draw(*each, size, frame);
            int compared = 0;
            for (const char* name : kTargets) {
                const auto first = a.readTarget(name), second = b.readTarget(name);
                ASSERT_EQ(bool(first), bool(second)) << name;
                if (!first) continue;
                ASSERT_EQ(first->size, second->size);
                const TargetDifference found = targetDifference(*first, *second);
                // GPU compilers may fuse and order sums in two ways, and a rounded ray may miss a corner.
                const bool isSame = !isSoftwareGl()    ? found.clearly <= int(first->pixels.size() * 4 / 50)
                                    : tolerance > 0.0f ? found.largest <= tolerance
                                                       : found.numbers == 0;
                EXPECT_TRUE(isSame) << name << " in frame " << frame << ": " << found.numbers
                                    << " numbers differ, by up to " << found.largest;
                ++compared;
            }
            EXPECT_GE(compared, frame ? 17 : 15);
        }
    }
    static std::vector<std::string> byCompute(const Renderer& renderer) {
        return {renderer.stats().computePasses.begin(), renderer.stats().computePasses.end()};
    }
    std::string m_shaders = shaderFolder();
    std::vector<std::string> m_lines;
};

TEST_F(FullscreenTest, ComputeDrawsWhatFragmentsDrawInAnySize) {
    const auto fragment = make(Fullscreen::Fragment, fullScene().snapshot()),
               compute = make(Fullscreen::Compute, fullScene().snapshot());
    for (const glm::ivec2 size : {kSize, glm::ivec2(61, 37), glm::ivec2(1, 3), glm::ivec2(128, 40)})
        expectSame(*fragment, *compute, size, 4);
    EXPECT_EQ(byCompute(*compute), kPasses);
}

TEST_F(FullscreenTest, ComputeRelightsAsFragmentsDo) {
    LitScene scene = fullScene();
    const auto fragment = make(Fullscreen::Fragment, scene.snapshot()),
               compute = make(Fullscreen::Compute, scene.snapshot());
    expectSame(*fragment, *compute, kSize, 2);
    for (Renderer* each : {fragment.get(), compute.get()}) {
        FrameSnapshot now = LitScene(scene).step();
        for (SnapshotLight& light : now.lights) light.color *= 0.3f;
        now.lightsChanged = true;
        each->apply(std::move(now));
    }
    expectSame(*fragment, *compute, kSize, 1);
    ASSERT_TRUE(compute->readTarget("changedLight"));
}

TEST_F(FullscreenTest, ComputeDrawsWhatFragmentsDrawWhereLessIsTracedThanShown) {
    RenderSettings settings;
    settings.resolutionScale = 0.75f;
    const auto fragment = make(Fullscreen::Fragment, fullScene().snapshot(), settings);
    const auto compute = make(Fullscreen::Compute, fullScene().snapshot(), settings);
    expectSame(*fragment, *compute, {61, 37}, 4);
    EXPECT_EQ(compute->readTarget("noisyLight")->size, glm::ivec2(46, 28));
}

TEST_F(FullscreenTest, ComputeKeepsPixelsThatAreNotDrawn) {
    // Dry, at night, without lights and glass: most passes write little. The second view shows nothing but sky.
    LitScene scene = streetScene();
    scene.environment.sunDirection = {0.1f, -0.5f, 0.2f};
    RenderSettings settings;
    settings.localLights = settings.reflections = false;
    settings.filterPasses = 0;
    const auto fragment = make(Fullscreen::Fragment, scene.snapshot(), settings),
               compute = make(Fullscreen::Compute, scene.snapshot(), settings);
    const Offscreen target(kSize);
    Camera camera = streetCamera(3);
    for (const glm::dvec3 to : {glm::dvec3(0, 0.5, 0), glm::dvec3(-11, 90, -10)}) {
        camera.lookAt(to);
        for (Renderer* each : {fragment.get(), compute.get()})
            each->draw(camera.view(kSize, target.framebuffer()), 1.0f);
        for (const char* name : {"noisyLight", "accumulatedLight", "surface", "denoisedLight", "radiance", "final"})
            EXPECT_TRUE(!isSoftwareGl() ||
                        targetDifference(*fragment->readTarget(name), *compute->readTarget(name)).numbers == 0)
                << name;
    }
}

/// A GL may fuse the products and sums of the waves in different ways: llvmpipe does so in the two programs, and slopes
/// differ in the last bit. Rounded to 16 bits that is 2^-12 for numbers near 0.5.
TEST_F(FullscreenTest, WaterIsTheSameButForTheLastBit) {
    const auto fragment = make(Fullscreen::Fragment, withWater(fullScene())),
               compute = make(Fullscreen::Compute, withWater(fullScene()));
    expectSame(*fragment, *compute, kSize, 3, 0.005f);
    const auto passes = byCompute(*compute);
    EXPECT_NE(std::find(passes.begin(), passes.end(), "water"), passes.end());
    const auto dry = make(Fullscreen::Fragment, fullScene().snapshot());
    draw(*dry, kSize, 2);
    EXPECT_GT(targetDifference(*dry->readTarget("radiance"), *fragment->readTarget("radiance")).numbers, 100)
        << "there is no water";
}

TEST_F(FullscreenTest, FragmentModeAllocatesNothingForCompute) {
    const auto fragment = make(Fullscreen::Fragment, fullScene().snapshot()),
               automatic = make(Fullscreen::Auto, fullScene().snapshot());
    const auto compute = make(Fullscreen::Compute, fullScene().snapshot());
    for (Renderer* each : {fragment.get(), automatic.get(), compute.get()}) draw(*each, kSize);
    EXPECT_EQ(fragment->stats().computePrograms, 0);
    EXPECT_TRUE(fragment->stats().computePasses.empty());
    EXPECT_GE(compute->stats().computePrograms, int(kPasses.size()));
    EXPECT_EQ(fragment->stats().textureBytes, compute->stats().textureBytes);
    EXPECT_EQ(automatic->stats().computePrograms > 0, !isSoftwareGl())
        << "compute is slower on software renderers: see docs/decisions/light.md";
}

TEST_F(FullscreenTest, ReloadedShadersDrawTheSame) {
    const TempFolder folder;
    std::filesystem::copy(shaderFolder(), folder.path(), std::filesystem::copy_options::recursive);
    m_shaders = folder.path().string();
    const auto fragment = make(Fullscreen::Fragment, fullScene().snapshot()),
               compute = make(Fullscreen::Compute, fullScene().snapshot());
    expectSame(*fragment, *compute, kSize, 2);
    const auto before = compute->readTarget("noisyLight");
    const auto file = folder.path() / "passes/sky.frag";
    const auto write = [&](const std::string& old, const std::string& now, int seconds) {
        std::ifstream in(file);
        std::string text((std::istreambuf_iterator<char>(in)), {});
        const size_t place = text.find(old);
        text.replace(place, old.size(), now);
        std::ofstream(file) << text;
        std::filesystem::last_write_time(file,
                                         std::filesystem::file_time_type::clock::now() + std::chrono::seconds(seconds));
        return 1 + std::count(text.begin(), text.begin() + ptrdiff_t(place), '\n');
    };
    const auto line = write("light.rgb /= float(rays);", "light.rgb /= float(rays) * oops;", 10);
    for (Renderer* each : {fragment.get(), compute.get()}) {
        EXPECT_FALSE(each->reloadShaders());
        ASSERT_EQ(each->shaderErrors().size(), 1u);
        EXPECT_NE(each->shaderErrors()[0].find("passes/sky.frag:" + std::to_string(line)), std::string::npos)
            << each->shaderErrors()[0];
    }
    expectSame(*fragment, *compute, kSize, 2);
    write("* oops;", "* 2.0;", 20);
    for (Renderer* each : {fragment.get(), compute.get()}) EXPECT_TRUE(each->reloadShaders());
    expectSame(*fragment, *compute, kSize, 2);
    EXPECT_GT(targetDifference(*before, *compute->readTarget("noisyLight")).largest, 0.05f)
        << "the reloaded shader is not in use";
}

TEST_F(FullscreenTest, AContextBelowFourPointThreeDrawsByFragmentsAndWarns) {
    g_minor = 2;
    auto renderer = make(Fullscreen::Compute, fullScene().snapshot(), {}, loaderWithOtherVersion);
    EXPECT_EQ(logCount("expected GL 4.3 or newer for compute programs"), 1);
    draw(*renderer, kSize);
    EXPECT_EQ(renderer->stats().computePrograms, 0);
    EXPECT_TRUE(byCompute(*renderer).empty());
    for (const Fullscreen quiet : {Fullscreen::Auto, Fullscreen::Fragment})
        make(quiet, fullScene().snapshot(), {}, loaderWithOtherVersion);
    EXPECT_EQ(logCount("expected GL 4.3 or newer for compute programs"), 1) << "a warning that nobody needs";
    renderer.reset();
    g_minor = 3;
    renderer = make(Fullscreen::Compute, fullScene().snapshot(), {}, loaderWithOtherVersion);
    draw(*renderer, kSize);
    EXPECT_EQ(byCompute(*renderer), kPasses) << "4.3 is enough";
    renderer.reset();
    ASSERT_TRUE(loadGl(testContext().loader()));
}

TEST_F(FullscreenTest, TheFastestIsMeasuredWhileTheImageIsTheSame) {
    const auto fragment = make(Fullscreen::Fragment, fullScene().snapshot()),
               fastest = make(Fullscreen::Fastest, fullScene().snapshot());
    constexpr int kFrames = 2 * (FullscreenChoice::kWarmUpFrames + FullscreenChoice::kTimedFrames);
    expectSame(*fragment, *fastest, kSize, 2);
    EXPECT_EQ(byCompute(*fastest), kPasses) << "every other frame is drawn by compute";
    const int atFirst = fastest->stats().computePrograms;
    for (int frame = 2; frame < kFrames; ++frame) draw(*fastest, kSize, frame);
    EXPECT_EQ(fastest->stats().computePrograms, atFirst);
    EXPECT_EQ(logCount("drawn by the faster method"), 0);
    std::vector<std::string> chosen;
    for (int frame = 0; frame < 3; ++frame) {
        draw(*fastest, kSize, frame);
        if (frame == 0) chosen = byCompute(*fastest);
        EXPECT_EQ(byCompute(*fastest), chosen);
    }
    EXPECT_EQ(logCount("drawn by the faster method"), 1);
    for (const std::string& pass : kPasses) EXPECT_EQ(logCount(pass + " by "), 1) << pass;
    if (!isSoftwareGl()) return;
    EXPECT_LT(chosen.size(), kPasses.size()) << "llvmpipe is not faster by compute in every pass";
    EXPECT_LT(fastest->stats().computePrograms, atFirst) << "the slower programs are kept";
}

}  // namespace
}  // namespace rubble
