#include "render/scene/light_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame/frame_camera.h"
#include "render/frame/frame_context.h"
#include "render/renderer.h"
#include "runtime/core/random.h"
#include "samples/support/camera.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

class LightGridTest : public GlTest {
protected:
    static FrameBlock seenFrom(const Camera& camera, bool isOrthographic = false) {
        FrameBlock block{};
        View view = camera.view({320, 180}, 0);
        if (isOrthographic) view.projection = View::Projection{glm::ortho(-16.0, 16.0, -9.0, 9.0, 0.0, 200.0)};
        FrameCamera().begin(view, {320, 180}, true, glm::dvec3(0.0), block);
        return block;
    }
    /// Lights scattered around the origin, of all kinds.
    static std::vector<SnapshotLight> scattered(int count, Random& random) {
        std::vector<SnapshotLight> lights;
        const auto between = [&](double low, double high) { return low + (high - low) * double(random.unit()); };
        for (int i = 0; i < count; ++i) {
            const double x = between(-30, 30), y = between(-5, 15), z = between(-60, 10);
            SnapshotLight light{
                LightKind(i % 5),        {x, y, z}, {0, -1, 0}, glm::vec3(1.0f), 0.2f, float(between(1, 12)), 0.2f,
                float(between(0.3, 1.4))};
            light.right = {1, 0, 0};
            light.width = float(between(0.2, 4.0));
            light.height = float(between(0.2, 2.0));
            lights.push_back(light);
        }
        return lights;
    }
};

/// A list may hold too many lights, but no light that reaches a place may be missing in its list.
TEST_F(LightGridTest, EveryLightIsListedInItsRange) {
    Random random{7, 3};
    LightGrid grid;
    int reached = 0, listed = 0;
    for (int view = 0; view < 24; ++view) {
        Camera camera;
        camera.position = {0.7 * view - 4.0, 1.7 + 0.3 * view, 8.0 - view};
        camera.yaw = 0.2 * view - 1.0;
        camera.pitch = 0.1 * (view % 5) - 0.2;
        const FrameBlock block = seenFrom(camera, view % 2 == 1);
        const auto lights = scattered(60, random);
        grid.update(lights, block, glm::dvec3(0.0));
        for (int ray = 0; ray < 400; ++ray) {
            const glm::ivec2 pixel(int(random.below(320)), int(random.below(180)));
            const float depth = std::exp2(float(random.unit()) * 7.0f - 1.0f);
            const glm::vec2 ndc = (glm::vec2(pixel) + 0.5f) / glm::vec2(block.targetSize) * 2.0f - 1.0f;
            const glm::vec3 place = block.rayStart(ndc) + block.ray(ndc) * depth;
            const std::vector<int> found = grid.lightsAt(pixel, depth);
            listed += int(found.size());
            for (size_t i = 0; i < lights.size(); ++i) {
                const glm::vec3 away = place - glm::vec3(lights[i].position);
                const float range = glm::length(away);
                if (range >= lights[i].reach) continue;
                if (lights[i].kind == LightKind::Cone &&
                    glm::dot(away / range, lights[i].direction) <= std::cos(lights[i].coneOuter))
                    continue;
                ++reached;
                ASSERT_NE(std::find(found.begin(), found.end(), int(i)), found.end())
                    << "light " << i << " at depth " << depth;
            }
        }
    }
    EXPECT_GT(reached, 1000);
    EXPECT_LT(listed, 6 * reached) << "lights are listed where they do not reach";
}

TEST_F(LightGridTest, LightsBehindTheCameraOrDarkCostNothing) {
    LightGrid grid;
    const FrameBlock block = seenFrom(Camera{});
    std::vector<SnapshotLight> lights{{LightKind::Sphere, {0, 1.7, 20}, {0, -1, 0}, glm::vec3(1.0f), 0.1f, 8.0f, 0, 0},
                                      {LightKind::Sphere, {0, 1.7, -5}, {0, -1, 0}, glm::vec3(0.0f), 0.1f, 8.0f, 0, 0}};
    EXPECT_EQ(grid.update(lights, block, glm::dvec3(0.0)), 0u);
    EXPECT_TRUE(grid.empty());
    lights[1].color = glm::vec3(1.0f);
    EXPECT_GT(grid.update(lights, block, glm::dvec3(0.0)), 0u);
    EXPECT_EQ(grid.lights(), 1);
    EXPECT_EQ(grid.lightsAt({160, 90}, 5.0f), std::vector<int>{1});
}

/// Histories of light mix what a light has sent over many frames.
TEST_F(LightGridTest, WhatChangesALightCountsAsAChange) {
    FrameBlock block = seenFrom(Camera{});
    block.counters.y = 1;  // not a cut
    SnapshotLight first{LightKind::Cone, {0, 1.7, -5}, {0, -1, 0}, glm::vec3(1.0f), 0.1f, 8.0f, 0.3f, 0.5f};
    first.light = LightHandle::make(1, 1, 0);
    const auto framesAfter = [&](auto&& change) {
        LightGrid grid;
        SnapshotLight light = first;
        const auto update = [&] { grid.update(std::span(&light, 1), block, glm::dvec3(0.0)); };
        for (int i = 0; i < 40; ++i) update();
        EXPECT_TRUE(grid.changes().empty());
        change(light);
        update();
        EXPECT_EQ(grid.changes().empty(), grid.framesSinceChange() > 0);
        return grid.framesSinceChange();
    };
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.color = {0.2f, 1.0f, 3.0f}; }), 0);
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.color = {1.0f, 0.7f, 1.0f}; }), 0);
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.position.x = 2.0; }), 0);
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.direction = {1, 0, 0}; }), 0);
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.reach = 3.0f; }), 0);
    EXPECT_EQ(framesAfter([](SnapshotLight& l) { l.coneOuter = 0.7f; }), 0);
    EXPECT_GT(framesAfter([](SnapshotLight& l) { l.color *= 1.01f; }), 0);
}

TEST_F(LightGridTest, ACutLeavesNoChanges) {
    const FrameBlock block = seenFrom(Camera{});
    ASSERT_EQ(block.counters.y, 0);
    const SnapshotLight light{LightKind::Sphere, {0, 1.7, -5}, {0, -1, 0}, glm::vec3(1.0f), 0.1f, 8.0f, 0, 0};
    LightGrid grid;
    grid.update(std::span(&light, 1), block, glm::dvec3(0.0));
    EXPECT_TRUE(grid.changes().empty());
}

TEST_F(LightGridTest, SlowChangesCountOnceTheyHaveAddedUp) {
    FrameBlock block = seenFrom(Camera{});
    block.counters.y = 1;  // not a cut
    SnapshotLight light{LightKind::Sphere, {0, 1.7, -5}, {0, -1, 0}, glm::vec3(1.0f), 0.1f, 8.0f, 0, 0};
    light.light = LightHandle::make(1, 1, 0);
    LightGrid grid;
    int changes = 0;
    for (int i = 0; i < 50; ++i) {
        light.color.b *= 0.98f;
        grid.update(std::span(&light, 1), block, glm::dvec3(0.0));
        changes += i > 0 && grid.framesSinceChange() == 0;
    }
    EXPECT_GE(changes, 5);
    EXPECT_LE(changes, 12);
}

}  // namespace
}  // namespace rubble
