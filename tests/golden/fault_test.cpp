#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// A mistake in a shader: the first occurrence of `good` in the file becomes `bad`.
struct Fault {
    const char* name;
    const char* file;
    const char* good;
    const char* bad;
};

constexpr Fault kFaults[] = {
    {"rays start in their own surface", "lib/shadow_trace.glsl", "return movedTowardEye(origin, toEye(positionWorld))",
     "return positionWorld"},
    {"the sun is behind", "passes/sun.frag", "coneDirection(frame.sunDirection.xyz",
     "coneDirection(-frame.sunDirection.xyz"},
    {"sky rays that leave see nothing", "passes/sky.frag", "light.rgb += skyRadiance(direction)",
     "light.rgb += vec3(0.0)"},
    {"colours are not made linear", "lib/color.glsl", "vec3(2.4)", "vec3(1.4)"},
    {"bodies rotate in the wrong direction", "lib/bodies.glsl", "+ q.w * v)", "- q.w * v)"},
    {"sunlight without the one over pi", "passes/composite.frag", "sun / kPi", "sun"},
    {"nothing emits", "passes/composite.frag", "s.albedo * s.emission", "s.albedo * 0.0"},
    {"no fresnel", "lib/brdf.glsl", "return f0 + (max(vec3(smoothness * smoothness), f0) - f0) * m2 * m2 * m",
     "return f0"},
    {"glass does not tint", "passes/glass_composite.frag", "texelFetch(uGlassTint, pixel, 0).rgb * light.a",
     "vec3(light.a)"},
    {"no haze", "lib/sky.glsl", "return 1.0 - exp2(-ratio * sqrt(ratio))", "return 0.0"},
    {"exposure off by a tenth", "lib/display.glsl", "kFilmExposure = 0.5", "kFilmExposure = 0.55"},
    {"the filter crosses edges", "passes/filter.frag",
     "there.y == centre.y ? planeWeight(plane, vec2(p - pixel), there.x) : 0.0", "1.0"},
    {"history counts for nothing", "passes/accumulate.frag", "mix(history.light, now, blends)", "now"},
    {"empty blocks are too large", "lib/cell_walk.glsl", "return 2;", "return 4;"},
    {"palette indices from the wrong row", "lib/bodies.glsl", "(c.x >> 2) + c.y * 2", "(c.x >> 2) + c.y * 4"},
    {"mirror rays go inward", "passes/reflections.frag", "reflect(-m.view", "reflect(m.view"},
    {"what rays hit reflects too much", "lib/bounce.glsl", "vec3 diffuse = albedo", "vec3 diffuse = 5.0 * albedo"},
    {"the eye does not adapt", "passes/exposure.frag", "kAdaptationStrength = 0.45", "kAdaptationStrength = 0.0"},
    {"highlights forty times too weak", "lib/brdf.glsl", "distribution * 0.5", "distribution * 0.0125"},
    {"edges are not smoothed", "passes/taa.frag", "across[i % 3] * up[i / 3]", "(i == 4 ? 1.0 : 0.0)"},
};

/// What is small in the street scene: a rotated block close by, an emissive one, a floor that mirrors at grazing
/// angles, thin slats.
LitScene closeUp() {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, uint8_t grey, uint8_t roughness, uint8_t reflectivity, float emission) {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = e.green = e.blue = grey;
        e.roughness = roughness;
        e.reflectivity = reflectivity;
        e.emission = emission;
    };
    entry(1, 40, 20, 30, 0.0f);
    entry(2, 200, 230, 10, 0.0f);
    entry(3, 230, 230, 10, 6.0f);
    LitScene scene(palette);
    scene.environment.sunDirection = {-0.5f, 0.4f, 0.6f};
    scene.add({120, 2, 120}, {{-6, -0.2, -6}, {1, 0, 0, 0}}, [](glm::ivec3) { return uint8_t(1); });
    scene.add({10, 10, 10}, {{-1.2, 0.3, -0.5}, glm::normalize(glm::dquat(0.86, 0.21, 0.37, 0.28))},
              [](glm::ivec3) { return uint8_t(2); });
    scene.add({4, 12, 4}, {{0.5, 0.0, -0.8}, {1, 0, 0, 0}}, [](glm::ivec3 c) { return uint8_t(c.y > 7 ? 3 : 2); });
    scene.add({20, 12, 3}, {{-1.0, 0.0, -2.0}, {1, 0, 0, 0}},
              [](glm::ivec3 c) { return uint8_t(c.x % 2 == 0 || c.z == 2 ? 2 : 0); });
    return scene;
}

/// Each fault must be visible in at least one of three images, by the measure that golden images are compared with.
/// One renderer draws all of them and reloads what a fault changes.
class FaultTest : public Drawing {
protected:
    static constexpr glm::ivec2 kSize{160, 90};
    static constexpr size_t kImageCount = 3;

    void SetUp() override {
        fs::copy(shaderFolder(), m_folder.path() / "shaders", fs::copy_options::recursive);
        RenderSettings settings;
        settings.warmUpFrames = 3;
        auto made = Renderer::create(testContext().loader(), m_folder / "shaders", settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        target = std::make_unique<Offscreen>(kSize);
    }
    /// Draws from a cut on. Reads the target rather than the view, in whose corner a dot tells of a reload.
    Image drawImage(size_t which) {
        renderer->apply(m_scenes[which / 2].snapshot());
        Camera camera = streetCamera(2 * int(which));
        if (which == 2) {
            camera.position = {0.3, 0.7, 2.4};
            camera.lookAt({-0.2, 0.5, -0.6});
        }
        View view = camera.view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
        const FloatImage drawn = read("final");
        Image image(kSize.x, kSize.y);
        for (size_t i = 0; i < drawn.pixels.size(); ++i)
            for (int k = 0; k < 3; ++k)
                image.rgb[3 * i + size_t(k)] =
                    uint8_t(std::lround(255.0f * glm::clamp(drawn.pixels[i][k], 0.0f, 1.0f)));
        return image;
    }
    /// The text of a shader as it is now.
    std::string readShader(const char* file) const {
        std::ifstream in(shaderPath(file));
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// Replaces a shader. Its time differs from all earlier ones, however coarse the clock of the file system is.
    void writeShader(const char* file, const std::string& text) {
        std::ofstream(shaderPath(file)) << text;
        fs::last_write_time(shaderPath(file), fs::file_time_type::clock::now() + std::chrono::seconds(++m_writes));
    }
    void reload() {
        EXPECT_TRUE(renderer->reloadShaders());
        for (const std::string& error : renderer->shaderErrors()) ADD_FAILURE() << error;
    }

private:
    fs::path shaderPath(const char* file) const { return m_folder.path() / "shaders" / file; }

    const TempFolder m_folder;
    const std::array<LitScene, 2> m_scenes{streetScene(), closeUp()};
    int m_writes = 0;
};

TEST_F(FaultTest, ImagesRejectEachOfTwentyFaults) {
    std::array<Image, kImageCount> good;
    for (size_t i = 0; i < kImageCount; ++i) good[i] = drawImage(i);
    for (size_t i = 0; i < kImageCount; ++i) {
        EXPECT_TRUE(looksAlike(compare(drawImage(i), good[i]))) << "image " << i << " depends on those drawn before";
        for (size_t k = 0; k < i; ++k)
            EXPECT_FALSE(looksAlike(compare(good[i], good[k])))
                << "images " << i << " and " << k << " look alike: each must show something of its own";
    }

    for (const Fault& fault : kFaults) {
        const std::string text = readShader(fault.file);
        const size_t place = text.find(fault.good);
        ASSERT_NE(place, std::string::npos) << fault.name << ": expected \"" << fault.good << "\" in " << fault.file
                                            << ", found none: adapt the fault to the shader";
        writeShader(fault.file, std::string(text).replace(place, std::string(fault.good).size(), fault.bad));
        reload();
        std::string seen;
        bool alike = true;
        for (size_t i = 0; i < kImageCount && alike; ++i) {
            const Difference difference = compare(drawImage(i), good[i]);
            alike = looksAlike(difference);
            seen += " " + std::to_string(difference.share * 100) + " % clearly, " + std::to_string(difference.mean) +
                    " of 255 on average;";
        }
        EXPECT_FALSE(alike) << fault.name << " is not visible:" << seen;
        writeShader(fault.file, text);  // reloaded together with the next fault
    }
    reload();
    for (size_t i = 0; i < kImageCount; ++i)
        EXPECT_TRUE(looksAlike(compare(drawImage(i), good[i]))) << "image " << i << " after all faults are mended";
}

}  // namespace
}  // namespace rubble
