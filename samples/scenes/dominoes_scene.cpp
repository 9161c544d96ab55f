// A curved row of slabs on a square: the first one tips over, the last one falls on a stack of crates.
#include <array>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kSlabs = 30;
constexpr ivec3 kSlabSize{3, 21, 11};  // cells; a slab falls along x
constexpr double kSpacing = 0.98;      // metres

/// One slab with its own pattern of inlaid dots; all slabs weigh about the same.
LevelShape makeSlab(int number) {
    static constexpr const SurfaceStyle* kBodies[] = {&kWhiteEnamel, &kClothRed,  &kPlasticGreen,
                                                      &kClothOchre,  &kClothBlue, &kPlasticGrey};
    Canvas c(kSlabSize);
    const Swatch body = c.addSurface(*kBodies[number % 6]),
                 dot = c.addSurface(number % 6 == 0 ? kPlasticBlack : kWhiteEnamel);
    c.box(ivec3(0), kSlabSize, body);
    c.box({0, 10, 2}, {kSlabSize.x, 11, kSlabSize.z - 2}, dot);
    const int top = number % 6 + 1, low = number * 5 % 6 + 1;
    const auto dots = [&](int count, int y) {
        static constexpr int kPlaces[7][2] = {{2, 2}, {6, 6}, {2, 6}, {6, 2}, {4, 4}, {2, 4}, {6, 4}};
        for (int i = 0; i < count; ++i)
            for (int x : {0, kSlabSize.x - 1})
                c.box({x, y + kPlaces[i][0], kPlaces[i][1]}, {x + 1, y + kPlaces[i][0] + 2, kPlaces[i][1] + 2}, dot);
    };
    dots(low, 0);
    dots(top, 11);
    return c.finish("slab " + std::to_string(number));
}

/// Poses along a wavy curve. Only square roots: no sine that differs by library.
std::array<Pose, kSlabs> slabPoses() {
    std::array<Pose, kSlabs> poses;
    glm::dvec3 foot(5.0, 0.0, 19.5), ahead(1.0, 0.0, 0.0);
    for (int i = 0; i < kSlabs; ++i) {
        const double turn = i < 5 ? 0.0 : i < 14 ? -0.115 : i < 24 ? 0.12 : -0.04;
        const glm::dvec3 side(-ahead.z, 0.0, ahead.x);
        ahead = glm::normalize(ahead + side * turn);
        foot += ahead * kSpacing;
        const glm::dquat rotation =
            glm::normalize(glm::quat_cast(glm::dmat3(ahead, glm::dvec3(0, 1, 0), glm::dvec3(-ahead.z, 0.0, ahead.x))));
        poses[size_t(i)] = {foot - rotation * (glm::dvec3(kSlabSize.x, 0, kSlabSize.z) * (0.5 * kVoxel)), rotation};
    }
    return poses;
}

Level dominoesLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {448, 0, 320};
    ground.areas = {area(Paving, 0, 76, 448, 262), area(Concrete, 0, 262, 448, 276)};
    Level level = makePlot("dominoes", ground, seed);
    const auto poses = slabPoses();
    for (int i = 0; i < kSlabs; ++i) {
        LevelBody body;
        LevelShape slab = makeSlab(i);
        body.name = slab.name;
        body.isStatic = false;
        body.pose = poses[size_t(i)];
        if (i == 0) body.velocity = {1.3f, 0.0f, 0.0f}, body.angularVelocity = {0.0f, 0.0f, -1.2f};
        body.shapes.push_back(std::move(slab));
        level.bodies.push_back(std::move(body));
    }
    const glm::dvec3 end = (poses.back().position + poses.back().rotation * glm::dvec3(1.5, 0, 0.1)) / kVoxel;
    for (int i = 0; i < 6; ++i) {
        const int column = i < 3 ? i : i < 5 ? i - 3 : 0, row = i < 3 ? 0 : i < 5 ? 1 : 2;
        addDynamic(level, makeCrate("crate " + std::to_string(i)),
                   ivec3(int(end.x) + 2, row * 8, int(end.z) - 8 + column * 9 + row * 4));
    }
    addDynamic(level, makeBench("bench"), {90, 0, 100});
    addDynamic(level, makePlantPot("plant 1"), {60, 0, 110});
    addDynamic(level, makePlantPot("plant 2"), {300, 0, 104});
    addDynamic(level, makeBin("bin"), {340, 0, 110});
    return level;
}

Edits dominoesScript(int, uint64_t) {
    return {};  // the first slab is already tipping
}

Pose dominoesCamera(double seconds) {
    return lookAt({7.5 + 2.0 * seconds, 2.8, 25.0}, {12.5 + 2.0 * seconds, 1.1, 16.5});
}

}  // namespace

Scene dominoesScene() {
    Scene scene{"dominoes", "a row of slabs that tips over", dominoesLevel, dominoesScript, dominoesCamera};
    scene.steps = 480;
    return scene;
}

}  // namespace rubble::scenes
