#include <cmath>

#include "render/passes/glass_pass.h"
#include "render/renderer.h"
#include "runtime/core/random.h"
#include "runtime/voxel/ray_walk.h"
#include "samples/support/camera.h"
#include "tests/render/gbuffer_fixture.h"

namespace rubble {
namespace {

struct Body {
    VoxelGrid grid;
    Pose pose;
    float voxelSize = 0.1f;
};

struct Expected {
    double depth = 65000.0;
    glm::dvec3 normal{0.0};
    int index = 0;
};

/// What the pixel at (x, y) sees, by the C++ walk in double.
Expected trace(const std::vector<Body>& bodies, const View& view, int x, int y) {
    const double tanY = std::tan(double(view.verticalFov) / 2), tanX = tanY * view.size.x / view.size.y;
    const glm::dvec3 rayView((2 * (x + 0.5) / view.size.x - 1) * tanX, (2 * (y + 0.5) / view.size.y - 1) * tanY, -1.0);
    const glm::dvec3 ray = view.rotation * rayView;
    Expected nearest;
    for (const Body& body : bodies) {
        const glm::dquat back = glm::conjugate(body.pose.rotation);
        const CellHit hit = walkRay(body.grid, {body.pose.inversePoint(view.position) / double(body.voxelSize),
                                                back * ray / double(body.voxelSize), nearest.depth});
        if (!hit.hit || hit.t >= nearest.depth) continue;
        glm::dvec3 normal(0.0);
        if (hit.axis >= 0) normal[hit.axis] = hit.sign;
        nearest = {hit.t, body.pose.rotation * normal, body.grid.at(hit.cell)};
    }
    return nearest;
}

Body randomBody(Random& random, glm::ivec3 size, int solidPercent) {
    Body body{VoxelGrid(size), {}};
    GridWriter writer(body.grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (int(hashCell(x, y, z, random.next()) % 100) < solidPercent)
                    writer.set({x, y, z}, uint8_t(1 + random.below(255)));
    return body;
}

glm::dquat randomRotation(Random& random) {
    glm::dquat q;
    for (int i = 0; i < 4; ++i) q[i] = random.unit() - 0.5;
    return glm::normalize(q);
}

/// A floor around the camera, sparse and dense bodies, some of them rotated or of other voxel sizes.
std::vector<Body> bodiesFor(uint64_t seed) {
    Random random(seed);
    std::vector<Body> bodies;
    bodies.push_back(randomBody(random, {96, 70, 90}, 1));
    bodies.back().pose.position = {-4.8, -1.0, -4.5};
    for (int i = 0; i < 12; ++i) {
        bodies.push_back(randomBody(random,
                                    {int(5 + random.below(30)), int(5 + random.below(30)), int(5 + random.below(30))},
                                    i % 2 ? 30 : 95));
        for (int a = 0; a < 3; ++a) bodies.back().pose.position[a] = random.unit() * 10.0 - 5.0;
        bodies.back().pose.rotation = randomRotation(random);
        bodies.back().voxelSize = i % 3 ? 0.1f : 0.07f;
    }
    return bodies;
}

void fill(Scene& scene, const std::vector<Body>& bodies) {
    TestScene made;
    const PaletteRef palette = testPalette();
    for (const Body& body : bodies) made.add(body.grid, body.pose, palette, body.voxelSize);
    scene.apply(made.take());
}

TEST_F(GBufferTest, MatchesTheDoublePrecisionWalk) {
    const std::vector<Body> bodies = bodiesFor(3);
    Scene scene;
    fill(scene, bodies);
    Camera eye;
    eye.position = {2.13, 1.57, 3.71};
    eye.lookAt({-1, 0.4, -1});
    const View view = eye.view({480, 270}, 0);
    draw(scene, view);
    const auto albedo = read(targets.at(Target::Albedo)), normal = read(targets.at(Target::Normal)),
               depth = read(targets.at(Target::Depth));

    int differ = 0, hits = 0;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            const Expected expected = trace(bodies, view, x, y);
            const size_t i = size_t(y) * size_t(view.size.x) + size_t(x);
            hits += expected.index != 0;
            const bool same = std::abs(depth[i].x - expected.depth) < 1e-4 * expected.depth &&
                              int(std::lround(albedo[i].w * 255)) == expected.index &&
                              glm::distance(glm::dvec3(normal[i]), expected.normal) < 2e-3;
            differ += !same;
        }
    const int pixels = view.size.x * view.size.y;
    EXPECT_GT(hits, pixels / 2) << "the camera sees little";
    EXPECT_LE(differ, pixels / 10000) << "of " << pixels << " pixels";
    RecordProperty("differ", differ);
}

TEST_F(GBufferTest, MovingBodyLeavesItsPathInTheMotionTarget) {
    Scene scene;
    TestScene made;
    VoxelGrid grid({20, 20, 20});
    {
        GridWriter writer(grid);
        fillBox(writer, {0, 0, 0}, {20, 20, 20}, 5);
    }
    const ShapeHandle shape = made.add(grid, {{-1, -1, -5}, {1, 0, 0, 0}}, testPalette());
    scene.apply(made.take());
    View view;
    view.size = {160, 90};
    draw(scene, view, 1.0f, true);
    made.snapshot().poses.push_back({shape, {{-1, -1, -5}, {1, 0, 0, 0}}, {{-0.5, -1, -5}, {1, 0, 0, 0}}});
    scene.apply(made.take());
    draw(scene, view, 1.0f, true);
    const size_t middle = 45 * 160 + 80;
    const double depth = 3.0, moved = 0.5 / (2 * depth * std::tan(view.verticalFov / 2.0) * 160 / 90);
    EXPECT_NEAR(read(targets.at(Target::Motion))[middle].x, moved, moved * 0.01);
    EXPECT_NEAR(read(targets.at(Target::Motion))[middle].y, 0.0, 1e-4);
    EXPECT_EQ(read(targets.at(Target::Material))[middle].w, 1.0f);
    draw(scene, view, 1.0f, true);
    EXPECT_NEAR(read(targets.at(Target::Motion))[middle].x, 0.0, 1e-4) << "it has come to rest";
}

TEST_F(GBufferTest, CameraInsideABoxAndInsideAVoxel) {
    std::vector<Body> bodies(1, Body{VoxelGrid({40, 40, 40}), {{-2, -2, -2}, {1, 0, 0, 0}}});
    {
        GridWriter writer(bodies[0].grid);
        fillBox(writer, {0, 0, 0}, {40, 40, 40}, 7);
        fillBox(writer, {1, 1, 1}, {39, 39, 39}, 0);
        fillBox(writer, {30, 30, 30}, {33, 33, 33}, 9);
    }
    Scene scene;
    fill(scene, bodies);
    View view;
    view.size = {120, 90};
    draw(scene, view);
    for (const glm::vec4& pixel : read(targets.at(Target::Albedo)))
        ASSERT_GT(pixel.w, 0.0f) << "a closed room without a hole";
    view.position = {1.15, 1.15, 1.15};  // in the voxels of entry 9
    draw(scene, view);
    for (const glm::vec4& pixel : read(targets.at(Target::Albedo))) ASSERT_EQ(std::lround(pixel.w * 255), 9);
}

TEST_F(GBufferTest, OneDrawForAnyNumberOfBodies) {
    for (const int count : {1, 20, 2000}) {
        TestScene made;
        const PaletteRef palette = testPalette();
        VoxelGrid grid({6, 5, 4});
        {
            GridWriter writer(grid);
            fillBox(writer, {0, 0, 0}, {6, 5, 4}, 3);
        }
        Random random{uint64_t(count)};
        for (int i = 0; i < count; ++i) {
            const double x = random.unit() * 20 - 10, y = random.unit() * 10 - 5, z = -5 - random.unit() * 20;
            made.add(grid, {{x, y, z}, randomRotation(random)}, palette);
        }
        Scene scene;
        scene.apply(made.take());
        View view;
        view.size = {320, 180};
        draw(scene, view);
        EXPECT_LE(figures.bodyDraws, GBufferPass::kMaxDraws) << count << " bodies";
        EXPECT_EQ(scene.bodies().bricks(), 1) << "they share one brick";
    }
}

TEST_F(GBufferTest, GlassIsSeenThrough) {
    auto palette = std::make_shared<Palette>(*testPalette());
    (*palette)[20] = {200, 240, 240, 64};
    VoxelGrid room({30, 30, 30});
    {
        GridWriter writer(room);
        fillBox(writer, {0, 0, 0}, {30, 30, 2}, 9);     // a wall
        fillBox(writer, {0, 0, 10}, {30, 30, 11}, 20);  // two panes before it
        fillBox(writer, {0, 0, 20}, {30, 30, 22}, 20);
    }
    TestScene made;
    made.add(room, {{-1.5, -1.5, -5}, {1, 0, 0, 0}}, palette);
    Scene scene;
    scene.apply(made.take());
    ASSERT_TRUE(scene.hasGlass());
    View view;
    view.size = {64, 36};
    draw(scene, view);
    GlassPass glass(*shaders);
    ASSERT_TRUE(shaders->errors().empty()) << shaders->errors().front();
    glass.draw(context(scene), pass->tiles());
    const size_t middle = 18 * 64 + 32;
    EXPECT_EQ(std::lround(read(targets.at(Target::Albedo))[middle].w * 255), 9) << "the wall behind the panes";
    EXPECT_NEAR(read(targets.at(Target::Depth))[middle].x, 4.8, 1e-3);
    const double pane = 1.0 - 64.0 / 255;
    EXPECT_NEAR(read(targets.at(Target::GlassTint))[middle].y, pane * pane, 0.01) << "two panes, however thick";
    EXPECT_NEAR(read(targets.at(Target::GlassSurface))[middle].z, 1.0, 1e-3);
    EXPECT_NEAR(read(targets.at(Target::GlassSurface))[middle].w, 2.8, 0.005) << "the nearer pane";
}

TEST_F(GBufferTest, UploadsFollowTheChange) {
    Scene scene;
    TestScene made;
    VoxelGrid grid({256, 64, 256});
    {
        GridWriter writer(grid);
        for (int z = 0; z < 256; ++z)
            for (int x = 0; x < 256; ++x) fillBox(writer, {x, 0, z}, {x + 1, 10, z + 1}, uint8_t(1 + (x * 7 + z) % 5));
    }
    const ShapeHandle shape = made.add(grid, {}, testPalette());
    scene.apply(made.take());
    View view;
    view.size = {64, 36};
    draw(scene, view);
    EXPECT_GT(uploaded, 32u * 32u * 2u * 576u);
    draw(scene, view);
    draw(scene, view);
    EXPECT_EQ(uploaded, 0u);

    BrickIndices indices{};
    indices[5] = 9;
    made.snapshot().bricks.push_back({shape, {3, 0, 3}, makeBrick(indices)});
    scene.apply(made.take());
    draw(scene, view);
    EXPECT_GT(uploaded, 576u);
    EXPECT_LT(uploaded, 4096u) << "one brick changed";
    made.snapshot().destroyed.push_back(shape);
    scene.apply(made.take());
    EXPECT_EQ(scene.bodies().bricks(), 0);
    EXPECT_EQ(scene.bodies().shapes(), 0);
}

TEST_F(GBufferTest, ChangesOverTheUploadBudgetAreDeferred) {
    Scene scene;
    scene.setUploadBudget(3 * BrickAtlas::kBrickBytes);
    TestScene made;
    VoxelGrid grid({80, 8, 8});
    {
        GridWriter writer(grid);
        fillBox(writer, {0, 0, 0}, {80, 8, 8}, 5);
    }
    const ShapeHandle shape = made.add(grid, {{-4, -0.4, -6}, {1, 0, 0, 0}}, testPalette());
    made.snapshot().replacesAll = true;
    scene.apply(made.take());
    View view;
    view.size = {160, 20};
    const auto entries = [&] {
        draw(scene, view);
        std::vector<int> row;
        for (const glm::vec4& pixel : read(targets.at(Target::Albedo))) row.push_back(int(std::lround(pixel.w * 255)));
        return row;
    };
    const std::vector<int> before = entries();
    EXPECT_EQ(scene.bodies().waitingBytes(), 0u) << "a level that is loaded does not wait";

    for (int step = 0; step < 2; ++step) {  // a change is seen whole or not at all
        for (int brick = 0; brick < 10; ++brick) {
            BrickIndices indices;
            indices.fill(uint8_t(20 + 20 * step + brick));
            made.snapshot().bricks.push_back({shape, {brick, 0, 0}, makeBrick(indices)});
        }
        scene.apply(made.take());
    }
    int frames = 0;
    std::vector<int> seen;
    do {
        EXPECT_GT(scene.bodies().waitingBytes(), 0u);
        seen = entries();
        EXPECT_LE(uploaded, 3 * BrickAtlas::kBrickBytes + 8192) << "the budget, and the directory";
        ++frames;
    } while (seen == before && frames < 100);
    EXPECT_EQ(frames, 4) << "ten bricks, three per frame";
    for (int entry : seen) EXPECT_TRUE(entry == 0 || (entry >= 20 && entry < 30)) << "the whole first change";
    while (scene.bodies().waitingBytes() > 0) seen = entries();
    for (int entry : seen) EXPECT_TRUE(entry == 0 || (entry >= 40 && entry < 50)) << "the whole second change";
}

TEST_F(GBufferTest, AtlasGrowsAndKeepsWhatItHeld) {
    std::vector<Body> bodies = bodiesFor(5);
    Scene scene;
    View view;
    view.position = {0, 0, 7};
    view.size = {160, 90};
    TestScene made;
    const PaletteRef palette = testPalette();
    for (const Body& body : bodies) {  // one per frame, so that every buffer grows several times
        made.add(body.grid, body.pose, palette, body.voxelSize);
        scene.apply(made.take());
        draw(scene, view);
    }
    const auto grown = read(targets.at(Target::Depth));
    Scene atOnce;
    fill(atOnce, bodies);
    draw(atOnce, view);
    const auto fresh = read(targets.at(Target::Depth));
    for (size_t i = 0; i < fresh.size(); ++i) ASSERT_EQ(grown[i].x, fresh[i].x);
}

}  // namespace
}  // namespace rubble
