#include <filesystem>
#include <fstream>

#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// A mistake that someone could make in a shader: `good` stands in the file once or more, and its first place becomes `bad`.
struct Fault {
    const char* name;
    const char* file;
    const char* good;
    const char* bad;
};

constexpr Fault kFaults[] = {
    {"rays start in their own surface", "lib/shadow_trace.glsl", "kLeaveCells = 0.52", "kLeaveCells = 0.0"},
    {"the sun is behind", "passes/sun.frag", "coneDirection(frame.sunDirection.xyz", "coneDirection(-frame.sunDirection.xyz"},
    {"sky rays that leave see nothing", "passes/sky.frag", "light.rgb += skyRadiance(direction)", "light.rgb += vec3(0.0)"},
    {"colours are not made linear", "lib/gbuffer.glsl", "vec3(2.4)", "vec3(1.4)"},
    {"bodies turn the wrong way", "lib/bodies.glsl", "+ q.w * v)", "- q.w * v)"},
    {"sunlight without the one over pi", "passes/composite.frag", "sun / 3.14159265", "sun"},
    {"nothing glows", "passes/composite.frag", "s.albedo * s.emission", "s.albedo * 0.0"},
    {"no fresnel", "lib/brdf.glsl", "return f0 + (1.0 - f0) * m2 * m2 * m", "return f0"},
    {"panes do not tint", "lib/glass.glsl", "behind * texelFetch(uGlassTint, pixel, 0).rgb", "behind"},
    {"no haze", "lib/sky.glsl", "return 1.0 - exp2(-ratio * sqrt(ratio))", "return 0.0"},
    {"exposure off by a tenth", "passes/tonemap.frag", "c * 0.5", "c * 0.55"},
    {"the filter crosses edges", "passes/filter.frag", "there.y == centre.y", "there.x > 0.0"},
    {"history counts for nothing", "passes/accumulate.frag", "mix(past.light, now, 1.0 / frames)", "now"},
    {"empty blocks are too large", "lib/cell_walk.glsl", "return 2;", "return 4;"},
    {"palette indices from the wrong row", "lib/voxel_walk.glsl", "(c.x >> 2) + c.y * 2", "(c.x >> 2) + c.y * 4"},
    {"mirrors look inward", "passes/reflections.frag", "reflect(-m.view", "reflect(m.view"},
    {"what rays hit shines too much", "lib/bounce.glsl", "kBounceAlbedo = 0.50", "kBounceAlbedo = 1.50"},
    {"the eye does not adapt", "passes/exposure.frag", "kStrength = 0.45", "kStrength = 0.0"},
    {"highlights forty times too weak", "lib/brdf.glsl", "distribution * 0.5", "distribution * 0.0125"},
    {"edges are not smoothed", "passes/taa.frag", "exp(-2.3 *", "exp(-230.0 *"},
};

/// Each fault must be seen in one of two pictures, by the measure that golden pictures are compared with.
class FaultTest : public Drawing {
protected:
    static constexpr glm::ivec2 kSize{160, 90};
    std::array<Image, 2> pictures(const std::string& shaders) {
        RenderSettings settings;
        settings.warmUpFrames = 7;
        auto made = Renderer::create(testContext().loader(), shaders, settings);
        EXPECT_TRUE(made) << made.error();
        if (!made) return {};
        renderer = std::move(made).value();
        renderer->apply(streetScene().snapshot());
        target = std::make_unique<Offscreen>(kSize);
        std::array<Image, 2> images;
        for (int i = 0; i < 2; ++i) {
            View view = streetCamera(2 * i).view(kSize, target->framebuffer());
            view.cut = true;
            renderer->draw(view, 1.0f);
            images[size_t(i)] = Image(kSize.x, kSize.y);
            images[size_t(i)].rgb = target->readRgb();
        }
        return images;
    }
};

TEST_F(FaultTest, PicturesRejectEachOfTwentyFaults) {
    const std::array<Image, 2> good = pictures(shaderFolder());
    const std::array<Image, 2> again = pictures(shaderFolder());
    for (size_t i = 0; i < good.size(); ++i) ASSERT_TRUE(looksAlike(compare(again[i], good[i]))) << "the same shaders draw the same picture";
    EXPECT_FALSE(looksAlike(compare(good[0], good[1]))) << "two pictures reject each other";

    const fs::path folder = fs::path(testing::TempDir()) / "rubble_faults";
    for (const Fault& fault : kFaults) {
        fs::remove_all(folder);
        fs::copy(shaderFolder(), folder, fs::copy_options::recursive);
        std::ifstream in(folder / fault.file);
        std::string text((std::istreambuf_iterator<char>(in)), {});
        const size_t place = text.find(fault.good);
        ASSERT_NE(place, std::string::npos) << fault.name << ": " << fault.file << " does not say \"" << fault.good << "\" any more: seed it anew";
        std::ofstream(folder / fault.file) << text.replace(place, std::string(fault.good).size(), fault.bad);
        const std::array<Image, 2> bad = pictures(folder.string());
        const Difference street = compare(bad[0], good[0]), room = compare(bad[1], good[1]);
        EXPECT_FALSE(looksAlike(street) && looksAlike(room)) << fault.name << " is not seen: " << street.share * 100 << " % and " << room.share * 100
                                                             << " % differ clearly, " << street.mean << " and " << room.mean << " of 255 on average";
    }
    fs::remove_all(folder);
}

}  // namespace
}  // namespace rubble
