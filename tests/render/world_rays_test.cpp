// Rays in GLSL through what the shadow worker publishes, against a plain walk in doubles: while the world breaks and
// bodies move.
#include <cmath>

#include "render/gl/framebuffer.h"
#include "tests/render/gbuffer_fixture.h"
#include "tests/runtime/shadow/received_volume.h"

namespace rubble {
namespace {

constexpr int kRays = 4000;

struct MetreRay {
    glm::vec3 origin, direction;
    float maxDistance;
};

class WorldRaysTest : public GBufferTest {
protected:
    void submit(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world) {
        worker.submit(changes, moved, world);
        for (ShadowPatches& publication : worker.takePatches()) {
            volume.apply(publication);
            FrameSnapshot snapshot;
            snapshot.shadowReplacesAll = publication.replacesAll;
            snapshot.shadow = std::move(publication.patches);
            scene.apply(std::move(snapshot));
        }
    }
    static constexpr float kExactFor = 1.6f;
    struct Found {
        bool exact, coarse;
        float t, coarseT;
    };
    std::vector<Found> trace(const std::vector<MetreRay>& rays) {
        const glm::ivec2 size(int(rays.size()), 1);
        Texture origins(GL_RGBA32F, size), directions(GL_RGBA32F, size), hits(GL_RGBA32F, size);
        std::vector<glm::vec4> o, d;
        for (const MetreRay& ray : rays) {
            o.emplace_back(ray.origin, ray.maxDistance);
            d.emplace_back(ray.direction, 0.0f);
        }
        origins.upload(o.data());
        directions.upload(d.data());
        View view;
        view.size = {16, 16};
        draw(scene, view);
        const Program& program = shaders->load("../tests/render/shaders/shadow_rays.frag");
        EXPECT_TRUE(program) << shaders->errors().front();
        Framebuffer framebuffer({&hits});
        framebuffer.begin();
        program.use();
        scene.bindShadow(program);
        program.set("uOrigins", origins);
        program.set("uDirections", directions);
        program.set("uExactDistance", kExactFor);
        context(scene).drawTriangle();
        std::vector<Found> out;
        for (const glm::vec4& hit : read(hits)) out.push_back({hit.y > 0.5f, hit.z > 0.5f, hit.x, hit.w});
        return out;
    }
    /// Whether the exact answer stays the same when the ray moves by a rounding error.
    bool isSure(const MetreRay& ray, bool hit) const {
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 moved =
                glm::dvec3(ray.origin) + 1e-4 * (2.0 * glm::dvec3(i & 1, i >> 1 & 1, i >> 2) - 1.0);
            if (volume.occluded(moved, glm::dvec3(ray.direction), double(ray.maxDistance)) != hit) return false;
        }
        return true;
    }
    void expectExact(Random& random, glm::dvec3 low, glm::dvec3 high, const std::string& when) {
        std::vector<MetreRay> rays;
        for (int i = 0; i < kRays; ++i) {
            const glm::dvec3 at = low + (high - low) * drawPoint(random, 0.0, 1.0);
            glm::dvec3 direction = drawPoint(random, -1.0, 1.0);
            if (i % 7 == 0) direction[i % 3] = 0.0;
            if (i % 11 == 0) direction = {0.0, i % 2 ? 1.0 : -1.0, 0.0};
            rays.push_back(
                {glm::vec3(at), glm::vec3(glm::normalize(direction)), float(1.0 + 20.0 * double(random.unit()))});
        }
        const std::vector<Found> found = trace(rays);
        int wrong = 0, hits = 0, coarse = 0, coarseWrong = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const bool expected =
                volume.occluded(glm::dvec3(rays[i].origin), glm::dvec3(rays[i].direction), double(rays[i].maxDistance));
            hits += expected;
            wrong += found[i].exact != expected && isSure(rays[i], expected);
            coarse += found[i].coarse;
            // The coarse ray stops where the exact one does, or earlier, but only beyond its exact distance.
            coarseWrong += found[i].exact && (!found[i].coarse || found[i].coarseT > found[i].t);
            coarseWrong +=
                found[i].coarse && found[i].coarseT < kExactFor && (!found[i].exact || found[i].coarseT != found[i].t);
        }
        EXPECT_EQ(coarseWrong, 0) << when;
        EXPECT_GE(coarse, hits) << when;
        EXPECT_EQ(wrong, 0) << when << ", of " << kRays;
        EXPECT_GT(hits, kRays / 20) << when;
        EXPECT_LT(hits, kRays * 19 / 20) << when;
    }
    ShadowWorker worker{ShadowWorker::Mode::Inline};
    Volume volume;
    Scene scene;
};

TEST_F(WorldRaysTest, AreExactWhileTheWorldBreaksAndBodiesMove) {
    Random random(21);
    std::vector<LevelBody> bodies;
    const auto building = [](glm::ivec3 c) {
        return uint8_t(c.y < 3 || c.y % 30 == 20 || c.x % 70 == 9 || c.z % 90 == 5);
    };
    bodies.push_back(makeBody(gridOf({160, 90, 140}, building), {{-5.0, -1.0, -3.0}}, true));
    for (int i = 0; i < 30; ++i) {
        const int side = random.between(3, 20);
        bodies.push_back(makeBody(gridOf(glm::ivec3(side), [](glm::ivec3) { return uint8_t(1); }),
                                  {drawPoint(random, -3.0, 9.0), drawRotation(random)}, false));
    }
    World world = worldOf(std::move(bodies));
    for (int step = 0; step < 40; ++step) {
        CarveEdit carve;
        carve.position = drawPoint(random, -3.0, 8.0);
        carve.radii = {0.8, 0.8, 0.8};
        const FrameChanges changes = world.applyEdits({carve});
        std::vector<BodyPose> moved;
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (body.isStatic || random.below(4) == 0) return;
            moved.push_back({handle,
                             {body.pose.position + drawPoint(random, -0.4, 0.4), drawRotation(random)},
                             {},
                             {},
                             random.below(9) == 0});
        });
        world.setPoses(moved);
        submit(changes, moved, world);
        if (step % 8 == 7) expectExact(random, {-7.0, -2.0, -5.0}, {13.0, 10.0, 13.0}, "step " + std::to_string(step));
    }
}

TEST_F(WorldRaysTest, AreExactInAWorldTwoKilometresWide) {
    Random random(22);
    std::vector<LevelBody> bodies;
    const VoxelGrid frameGrid =
        gridOf({60, 60, 60}, [](glm::ivec3 c) { return uint8_t(c.x % 20 == 3 || c.y % 25 == 3); });
    for (const glm::dvec3 place : {glm::dvec3(0.0), glm::dvec3(2000.0, 0.0, 0.0), glm::dvec3(0.0, 10.0, 2000.0),
                                   glm::dvec3(2000.0, 0.0, 2000.0)})
        bodies.push_back(makeBody(frameGrid, {place}, true));
    World world = worldOf(std::move(bodies));
    submit(world.applyEdits({}), {}, world);
    EXPECT_LT(scene.shadow().bytes(), uint64_t(600) << 20) << "one texel per brick";
    expectExact(random, {-2.0, -1.0, -2.0}, {8.0, 8.0, 8.0}, "at the origin");

    CarveEdit carve;  // a change costs its neighbourhood, also far from the camera
    carve.position = {2003.0, 3.0, 2003.0};
    carve.radii = {1.0, 1.0, 1.0};
    const FrameChanges changes = world.applyEdits({carve});
    submit(changes, {}, world);
    trace({{{1, 1, 1}, {1, 0, 0}, 5.0f}});
    EXPECT_LT(uploaded, uint64_t(4) << 20);
}

}  // namespace
}  // namespace rubble
