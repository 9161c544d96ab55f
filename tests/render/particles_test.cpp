#include <gtest/gtest.h>

#include <cstdlib>

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "samples/support/camera.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/test_scene.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize{96, 64};

struct GlObjects {
    int programs = 0, buffers = 0, textures = 0;
    friend bool operator==(const GlObjects&, const GlObjects&) = default;
};

GlObjects countGlObjects() {
    GlObjects out;
    for (GLuint name = 1; name < 2000; ++name) {
        out.programs += glIsProgram(name);
        out.buffers += glIsBuffer(name);
        out.textures += glIsTexture(name);
    }
    return out;
}

/// A wall of 4 x 4 m, 6 m before the camera.
class ParticlesTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        target = std::make_unique<Offscreen>(kSize);
        RenderSettings settings;
        settings.temporal = false;
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        VoxelGrid wall({40, 40, 2});
        GridWriter writer(wall);
        fillBox(writer, {0, 0, 0}, {40, 40, 2}, 20);
        writer.flush();
        TestScene scene;
        scene.add(wall, {{-2, -2, -6}, {1, 0, 0, 0}}, testPalette());
        renderer->apply(scene.take());
    }
    std::vector<uint8_t> draw(const std::vector<SnapshotParticle>& particles) {
        FrameSnapshot snapshot;
        snapshot.particlesChanged = true;
        snapshot.particles = particles;
        renderer->apply(std::move(snapshot));
        Camera camera;
        camera.position = {0, 0, 0};
        View view = camera.view(kSize, target->framebuffer());
        view.cut = true;  // the same noise in every frame
        renderer->draw(view, 1.0f);
        return target->readRgb();
    }
    bool passRan() const {
        const auto& passes = renderer->stats().passes;
        return std::find(passes.begin(), passes.end(), std::string_view("particles")) != passes.end();
    }
    static SnapshotParticle at(ParticleKind kind, double z, float radius, float opacity = 0.9f) {
        return {kind, {0, 0, z}, glm::vec3(0.0f), glm::vec3(0.6f), radius, opacity, 0.3f, 12345};
    }
    static int differing(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
        int pixels = 0;
        for (size_t i = 0; i < a.size(); i += 3)
            pixels += std::abs(a[i] - b[i]) + std::abs(a[i + 1] - b[i + 1]) + std::abs(a[i + 2] - b[i + 2]) > 12;
        return pixels;
    }
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<Offscreen> target;
};

TEST_F(ParticlesTest, CostNothingUntilThereAreSome) {
    draw({});
    const GlObjects without = countGlObjects();
    draw({});
    EXPECT_FALSE(passRan());
    EXPECT_EQ(countGlObjects(), without) << "no program, no buffer, no texture";
    draw({at(ParticleKind::Dust, -4, 0.8f), at(ParticleKind::Flame, -4, 0.5f), at(ParticleKind::Crumb, -4, 0.1f)});
    EXPECT_TRUE(passRan());
    EXPECT_GT(countGlObjects().programs, without.programs);
    draw({});
    EXPECT_FALSE(passRan()) << "the pass still runs without particles";
}

TEST_F(ParticlesTest, EachKindShows) {
    const auto clear = draw({});
    for (const ParticleKind kind : {ParticleKind::Dust, ParticleKind::Smoke, ParticleKind::Flame, ParticleKind::Spark,
                                    ParticleKind::Crumb, ParticleKind::Glint, ParticleKind::Ember})
        EXPECT_GT(differing(draw({at(kind, -4, 0.6f)}), clear), 40) << int(kind);
}

TEST_F(ParticlesTest, AreHiddenBehindSurfacesAndFadeIntoThem) {
    const auto clear = draw({});
    EXPECT_EQ(differing(draw({at(ParticleKind::Dust, -9, 0.8f), at(ParticleKind::Crumb, -9, 0.3f)}), clear), 0);
    // Half of the puff is in the wall: it shows, and its edges are as soft as those of a puff in the open.
    const auto half = draw({at(ParticleKind::Dust, -5.8, 0.8f)}), open = draw({at(ParticleKind::Dust, -5.0, 0.8f)});
    EXPECT_GT(differing(half, clear), 20);
    EXPECT_LT(differing(half, clear), differing(open, clear));
}

TEST_F(ParticlesTest, CameraInsideAPuffSeesThrough) {
    const auto clear = draw({});
    EXPECT_LT(differing(draw({at(ParticleKind::Smoke, -0.1, 0.5f)}), clear), kSize.x * kSize.y / 4);
}

TEST_F(ParticlesTest, SmokeThrowsAShadow) {
    FrameSnapshot air;
    air.environmentChanged = true;
    air.environment.sunDirection = {0.0f, 0.6f, 0.8f};  // over the camera's shoulder, onto the wall
    renderer->apply(std::move(air));
    // Out of sight, between the wall and the sun.
    SnapshotParticle cloud = at(ParticleKind::Smoke, -2.0, 1.0f);
    cloud.position.y = 3.0;
    const auto clear = draw({}), shaded = draw(std::vector<SnapshotParticle>(6, cloud));
    int darker = 0;
    for (size_t i = 0; i < clear.size(); i += 3) darker += shaded[i] + 25 < clear[i];
    EXPECT_GT(darker, 60);
    cloud.position = {0.0, 0.0, -9.0};
    EXPECT_EQ(differing(draw(std::vector<SnapshotParticle>(6, cloud)), clear), 0)
        << "smoke behind the wall must not shade it";
}

}  // namespace
}  // namespace rubble
