// A camera inside a voxel, or partly so, shows what it is in: the dim colour of that voxel, the same in every frame.
// RUBBLE_IMAGES=FOLDER writes the images.
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "runtime/core/random.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 64);
constexpr int kFrames = 8;
constexpr uint8_t kStone = 1, kChrome = 2, kGlowing = 3, kGlass = 4;

PaletteRef palette() {
    auto palette = std::make_shared<Palette>();
    const auto add = [&](uint8_t entry, std::array<uint8_t, 3> color, uint8_t roughness, uint8_t metallic) {
        PaletteEntry& e = (*palette)[entry];
        e.red = color[0], e.green = color[1], e.blue = color[2];
        e.roughness = roughness, e.metallic = metallic, e.reflectivity = 10, e.material = 1;
    };
    add(kStone, {186, 120, 90}, 230, 0);
    add(kChrome, {200, 200, 200}, 10, 255);
    add(kGlowing, {255, 200, 100}, 200, 0);
    (*palette)[kGlowing].emission = 4.0f;
    add(kGlass, {160, 220, 200}, 10, 0);
    (*palette)[kGlass].opacity = 60;
    return palette;
}

/// A floor in the sun, a block of one kind of voxel round the world's origin, a post to see and a light beside it.
LitScene blockOf(uint8_t entry, glm::dquat rotation = {1, 0, 0, 0}) {
    LitScene scene(palette());
    scene.environment.sunDirection = {0.4f, 0.6f, 0.5f};
    scene.environment.wetness = 0.5f;
    scene.environment.fogDensity = 0.02f;
    scene.add({80, 2, 80}, {{-4, -1.2, -4}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    scene.add({8, 8, 8}, {rotation * glm::dvec3(-0.4), rotation}, [=](glm::ivec3) { return entry; });
    scene.add({3, 20, 3}, {{1.0, -1.0, -0.5}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    scene.addLight({LightKind::Sphere, {0.6, 0.3, 0.4}, {0, -1, 0}, {4.0f, 9.0f, 14.0f}, 0.1f, 6.0f, 0.0f, 0.0f});
    return scene;
}

class CameraInside : public Drawing {
protected:
    View viewFrom(glm::dvec3 position) const {
        View view;
        view.position = position;
        view.rotation =
            glm::quat_cast(glm::inverse(glm::lookAt(glm::dvec3(0.0), {1.0, -0.2, -0.5}, glm::dvec3(0, 1, 0))));
        view.size = kSize;
        view.framebuffer = target->framebuffer();
        return view;
    }
    void drawFrames(View view) {
        for (int i = 0; i < kFrames; ++i) {
            view.cut = i == 0;
            renderer->draw(view, 1.0f);
        }
    }
    void keep(const std::string& name) const {
        const char* folder = std::getenv("RUBBLE_IMAGES");
        if (!folder) return;
        Image image(kSize.x, kSize.y);
        image.rgb = target->readRgb();
        EXPECT_TRUE(writePng(std::string(folder) + "/inside_" + name + ".png", image));
    }
    /// That all pixels are of one colour, and which.
    glm::vec3 plainColor(const std::string& name) const {
        const FloatImage radiance = read("radiance");
        const glm::vec3 first(radiance.at(0, 0));
        int others = 0;
        for (const glm::vec4& pixel : radiance.pixels)
            others += !(glm::distance(glm::vec3(pixel), first) < 0.01f * glm::length(first));
        EXPECT_EQ(others, 0) << name;
        return first;
    }
};

TEST_F(CameraInside, AVoxelShowsItsDimColour) {
    const glm::dquat turned = glm::angleAxis(0.5, glm::normalize(glm::dvec3(1, 2, 3)));
    Random random(7, 0);
    for (const glm::dquat rotation : {glm::dquat(1, 0, 0, 0), turned})
        for (const uint8_t entry : {kStone, kChrome, kGlowing}) {
            start(blockOf(entry, rotation), kSize);
            glm::vec3 color(0.0f);
            for (int i = 0; i < 12; ++i) {
                glm::dvec3 cell;
                for (int a = 0; a < 3; ++a) cell[a] = random.unit() * 0.8 - 0.4;
                if (i % 2) cell[random.below(3)] = 0.399;  // a millimetre below the block's face
                drawFrames(viewFrom(rotation * cell));
                const std::string name =
                    std::to_string(entry) + (rotation.w < 1.0 ? "_turned_" : "_") + std::to_string(i);
                const glm::vec3 found = plainColor(name);
                if (i == 0) color = found, keep(name);
                EXPECT_LT(glm::distance(found, color), 0.01f * glm::length(color)) << name;
            }
            if (entry == kGlowing)
                EXPECT_GT(color.g, 1.0f);
            else
                EXPECT_TRUE(color.g > 0.01f && color.g < 0.2f) << color.g;
        }
}

TEST_F(CameraInside, AVoxelUnderWaterShowsNoWater) {
    const LitScene scene = blockOf(kStone);
    start(scene, kSize);
    drawFrames(viewFrom(glm::dvec3(0.03)));
    const glm::vec3 dry = plainColor("dry");
    FrameSnapshot snapshot = scene.snapshot();
    Water water;
    water.outline = {{-4.0, -4.0}, {4.0, -4.0}, {4.0, 4.0}, {-4.0, 4.0}};
    water.surface = 0.2;
    snapshot.waters = {water};
    snapshot.watersChanged = true;
    snapshot.version = snapshot.newestStep = 2;
    renderer->apply(std::move(snapshot));
    drawFrames(viewFrom(glm::dvec3(0.03)));
    keep("under_water");
    EXPECT_LT(glm::distance(plainColor("under water"), dry), 0.01f * glm::length(dry));
}

/// Its far face reflects nothing, least of all what is behind the camera: there something glows.
TEST_F(CameraInside, GlassShowsWhatIsBehindItTinted) {
    FloatImage images[2], depth;
    for (const bool isGlass : {false, true}) {
        LitScene scene = blockOf(isGlass ? kGlass : 0);
        scene.environment.fogDensity = 0.0f;
        scene.add({2, 80, 80}, {{-3.0, -1.0, -4.0}, {1, 0, 0, 0}}, [](glm::ivec3) { return kGlowing; });
        start(scene, kSize);
        drawFrames(viewFrom(glm::dvec3(0.03)));
        keep(isGlass ? "glass" : "no_glass");
        images[isGlass] = read("radiance"), depth = read("depth");
    }
    int sky = 0, surfaces = 0, others = 0;
    for (size_t i = 0; i < depth.pixels.size(); ++i) {
        const bool isSky = depth.pixels[i].r > 1e4f;
        ++(isSky ? sky : surfaces);
        const float share = images[1].pixels[i].g / images[0].pixels[i].g;
        others += isSky && !(std::abs(share - (1.0f - 60.0f / 255.0f)) < 0.01f);
    }
    EXPECT_EQ(others, 0) << "of " << sky;
    EXPECT_GT(sky, 500);
    EXPECT_GT(surfaces, 500);
}

/// The rays of such a view begin side by side: some of them inside the block.
TEST_F(CameraInside, AnOrthographicViewShowsTheSectionOfWhatItBeginsIn) {
    start(blockOf(kStone), kSize);
    View view;
    view.size = kSize, view.framebuffer = target->framebuffer();
    view.position = {0.4, 0.03, 0.0};  // the block's face at x = 0.4 is in the middle
    view.rotation = glm::quat_cast(glm::inverse(glm::lookAt(glm::dvec3(0.0), {0, -1, 0}, glm::dvec3(0, 0, -1))));
    const double halfHeight = 0.3, halfWidth = halfHeight * kSize.x / kSize.y;
    view.projection = View::Projection{glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, 0.0, 100.0)};
    drawFrames(view);
    keep("section");
    const FloatImage radiance = read("radiance"), depth = read("depth");
    const glm::vec3 plain(radiance.at(4, 4));
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            if (std::abs(x - kSize.x / 2) <= 1) continue;  // jitter
            const bool isInside = x < kSize.x / 2;
            const glm::vec3 found(radiance.at(x, y));
            ASSERT_EQ(depth.at(x, y).r < 0.01f, isInside) << x << ", " << y;
            if (isInside)
                ASSERT_LT(glm::distance(found, plain), 0.01f * glm::length(plain)) << x << ", " << y;
            else
                ASSERT_GT(found.g, 2.0f * plain.g) << x << ", " << y;
        }
}

}  // namespace
}  // namespace rubble
