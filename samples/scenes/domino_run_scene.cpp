// Five hundred domino stones in rows across a square; the first one is pushed.
#include <array>

#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kStones = 500, kRow = 54, kTurn = 9;  // stones in a straight row, and in the half circle to the next row
constexpr ivec3 kStoneSize{1, 8, 4};                // cells; a stone falls along x
constexpr double kSpacing = 0.36;                   // metres

LevelShape makeStone(int number) {
    static constexpr const SurfaceStyle* kColors[] = {&kWhiteEnamel, &kClothRed, &kClothOchre, &kPlasticGreen,
                                                      &kClothBlue};
    Canvas c(kStoneSize);
    c.box(ivec3(0), kStoneSize, c.addSurface(*kColors[number / 10 % 5]));
    return c.finish("stone " + std::to_string(number));
}

/// Rows along x, joined by half circles in steps of 20 degrees.
std::array<Pose, kStones> stonePoses() {
    constexpr double kCosine = 0.93969262078590838, kSine = 0.34202014332566873;
    constexpr double kHalfCosine = 0.98480775301220806, kHalfSine = 0.17364817766693035;
    std::array<Pose, kStones> poses;
    glm::dvec3 foot(7.0, 0.0, 26.0), ahead(1.0, 0.0, 0.0);
    const auto turned = [](glm::dvec3 v, double cosine, double sine) {
        return glm::dvec3(v.x * cosine + v.z * sine, 0.0, v.z * cosine - v.x * sine);
    };
    for (int i = 0; i < kStones; ++i) {
        const int place = i % (kRow + kTurn), row = i / (kRow + kTurn);
        const double side = row % 2 ? -1.0 : 1.0;  // rows proceed toward -z, so the first turn is to the left
        glm::dvec3 step = ahead;
        if (place >= kRow) {
            step = turned(ahead, kHalfCosine, side * kHalfSine);
            ahead = turned(ahead, kCosine, side * kSine);
        }
        foot += step * kSpacing;
        const glm::dquat rotation =
            glm::normalize(glm::quat_cast(glm::dmat3(ahead, glm::dvec3(0, 1, 0), glm::dvec3(-ahead.z, 0.0, ahead.x))));
        poses[size_t(i)] = {foot - rotation * (glm::dvec3(kStoneSize.x, 0, kStoneSize.z) * (0.5 * kVoxel)), rotation};
    }
    return poses;
}

Level dominoRunLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {360, 0, 320};
    ground.areas = {area(Paving, 0, 76, 360, 320)};
    Level level = makePlot("domino run", ground, seed);
    const auto poses = stonePoses();
    for (int i = 0; i < kStones; ++i) {
        LevelBody body{.pose = poses[size_t(i)], .isStatic = false};
        body.shapes.push_back(makeStone(i));
        body.name = body.shapes[0].name;
        if (i == 0) body.velocity = {0.7f, 0.0f, 0.0f}, body.angularVelocity = {0.0f, 0.0f, -1.7f};
        level.bodies.push_back(std::move(body));
    }
    addDynamic(level, makeBench("bench"), {40, 0, 100});
    addDynamic(level, makePlantPot("plant 1"), {46, 0, 130});
    addDynamic(level, makePlantPot("plant 2"), {300, 0, 130});
    return level;
}

Edits dominoRunScript(int, uint64_t) {
    return {};  // the first stone is already tipping
}

Pose dominoRunCamera(double) {
    return lookAt({17.0, 10.5, 37.0}, {17.0, 0.0, 18.4});
}

}  // namespace

Scene dominoRunScene() {
    Scene scene{"domino_run", "five hundred stones that tip over one another", dominoRunLevel, dominoRunScript,
                dominoRunCamera};
    scene.verticalFov = 0.80f;
    scene.steps = 3240;
    return scene;
}

}  // namespace rubble::scenes
