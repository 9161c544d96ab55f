// An orthographic view is a perspective from far away, in every pass.
// RUBBLE_IMAGES=FOLDER writes for each view: the orthographic image, the perspective one and their difference.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "runtime/frame/ripples.h"
#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(192, 128);
constexpr double kDistance = 300.0;  // metres of the eyes from what is in the middle
constexpr double kHalfHeight = 7.0;  // metres of the view
constexpr int kFrames = 24;          // after which the light is smooth

/// A scene that needs every pass: sun, sky, lights, wet ground, glass, mirrors, fog, water, particles, a rope.
FrameSnapshot fullScene() {
    LitScene scene = streetScene();
    scene.environment.wetness = 0.8f;
    scene.environment.fogDensity = 0.03f;
    scene.environment.fogHeight = 2.0f;
    scene.environment.fogDistance = 1e6f;  // haze is by the distance of the eye
    scene.addLight({LightKind::Sphere, {-1.0, 2.0, -3.0}, {0, -1, 0}, {4.0f, 9.0f, 14.0f}, 0.1f, 6.0f, 0.0f, 0.0f});
    FrameSnapshot snapshot = scene.snapshot();
    Water water;
    water.outline = {{0.5, -8.0}, {6.0, -8.0}, {6.0, -4.5}, {0.5, -4.5}};
    water.surface = 0.35;
    snapshot.waters = {water};
    snapshot.ripples.push_back({{3.0, -6.0}, water.surface, 0.4f, 0.05f, 0.3f});
    for (const ParticleKind kind : {ParticleKind::Smoke, ParticleKind::Flame, ParticleKind::Spark, ParticleKind::Crumb})
        snapshot.particles.push_back({kind,
                                      {-6.0 + 1.2 * double(kind), 1.6, -7.5},
                                      glm::vec3(0.0f),
                                      glm::vec3(0.6f),
                                      kind == ParticleKind::Spark ? 0.05f : 0.5f,
                                      0.8f,
                                      0.3f,
                                      7});
    const std::vector<glm::dvec3> rope = {{-4.0, 3.0, -5.0}, {0.0, 2.0, -5.0}, {4.0, 3.0, -5.0}};
    snapshot.ropes.push_back({JointHandle::make(1, 1, 0), rope, rope, 0.06f, glm::vec3(0.7f, 0.5f, 0.3f)});
    snapshot.watersChanged = snapshot.ripplesChanged = snapshot.particlesChanged = snapshot.ropesChanged = true;
    return snapshot;
}

/// The largest difference of the means of blocks of 8 x 8 pixels, of 255: parallax shifts edges by a pixel.
double worstBlock(const Image& a, const Image& b) {
    constexpr int kBlock = 8;
    double worst = 0.0;
    for (int y = 0; y + kBlock <= a.height; y += kBlock)
        for (int x = 0; x + kBlock <= a.width; x += kBlock)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int i = 0; i < kBlock * kBlock; ++i) {
                    const int column = x + i % kBlock, row = y + i / kBlock;
                    sum += a.at(column, row)[channel] - b.at(column, row)[channel];
                }
                worst = std::max(worst, std::abs(sum) / double(kBlock * kBlock));
            }
    return worst;
}

struct Aim {
    const char* name;
    glm::dvec3 from;  ///< relative to what is in the middle
};
constexpr Aim kAims[] = {{"above", {0.0, 1.0, -0.001}}, {"aslant", {-0.6, 0.7, -1.0}}, {"level", {0.15, 0.12, -1.0}}};

class OrthographicTest : public Drawing {
protected:
    static View viewOf(const Aim& aim, double distance) {
        Camera camera;
        const glm::dvec3 middle(0.0, 0.5, -2.5);
        camera.position = middle + glm::normalize(aim.from) * distance;
        camera.lookAt(middle);
        View view = camera.view(kSize, 0);
        view.verticalFov = float(2.0 * std::atan(kHalfHeight / distance));
        return view;
    }
    /// The same view as an orthographic one, whose rays begin at the eye.
    static View orthographic(View view) {
        const double aspect = double(kSize.x) / kSize.y, x = kHalfHeight * aspect;
        view.projection = View::Projection{glm::ortho(-x, x, -kHalfHeight, kHalfHeight, 0.0, 1000.0)};
        return view;
    }
    Image drawn(View view, int frames = kFrames) {
        view.framebuffer = target->framebuffer();
        for (int i = 0; i < frames; ++i) {
            view.cut = i == 0;
            renderer->draw(view, 1.0f);
        }
        Image image(kSize.x, kSize.y);
        image.rgb = target->readRgb();
        return image;
    }
    void startFull(const RenderSettings& settings = {}) {
        start(streetScene(), kSize, settings);
        FrameSnapshot full = fullScene();
        full.version = full.newestStep = 2;
        renderer->apply(std::move(full));
    }
};

TEST_F(OrthographicTest, EveryPassShowsWhatAPerspectiveFromFarAwayShows) {
    startFull();
    for (const Aim& aim : kAims) {
        View perspective = viewOf(aim, kDistance), parallel = orthographic(perspective);
        perspective.slot = 0, parallel.slot = 1;
        const Image expected = drawn(perspective), found = drawn(parallel);
        const Difference difference = compare(found, expected);
        if (const char* folder = std::getenv("RUBBLE_IMAGES"))
            EXPECT_TRUE(writePng(std::string(folder) + "/orthographic_" + aim.name + ".png",
                                 tile({found, expected, difference.image}, 3)));
        EXPECT_LT(difference.mean, 6.0) << aim.name;
        EXPECT_LT(worstBlock(found, expected), 36.0) << aim.name;
    }
}

TEST_F(OrthographicTest, AViewThatMovesKeepsWhatItHasAccumulated) {
    startFull();
    const View end = orthographic(viewOf(kAims[1], kDistance));
    const Image expected = drawn(end);
    constexpr int kMoves = 24;
    View moving = end;
    moving.framebuffer = target->framebuffer();
    const glm::dvec3 step = end.rotation * glm::dvec3(0.03, 0.02, 0.05);
    for (int i = kMoves; i >= 0; --i) {
        moving.position = end.position - step * double(i);
        moving.cut = i == kMoves;
        renderer->draw(moving, 1.0f);
    }
    Image found(kSize.x, kSize.y);
    found.rgb = target->readRgb();
    EXPECT_LT(compare(found, expected).mean, 5.0);
    EXPECT_LT(worstBlock(found, expected), 26.0);
    const FloatImage surface = read("surface");
    const auto isOld = [](const glm::vec4& pixel) { return pixel.z >= 16.0f; };  // frames accumulated
    EXPECT_GT(std::ranges::count_if(surface.pixels, isOld), kSize.x * kSize.y * 7 / 10);
}

}  // namespace
}  // namespace rubble
