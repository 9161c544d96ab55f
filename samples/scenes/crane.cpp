#include "samples/scenes/crane.h"

#include <algorithm>

#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kMastSide = 11, kHeight = 132;  // cells
constexpr int kPivot = 56, kTip = 204;        // cells along the jib
constexpr int kJibSide = 7;
constexpr double kRope = 8.6;  // length in metres

LevelShape makeMast() {
    constexpr int kLast = kMastSide - 1, kPanel = 10;
    Canvas c({kMastSide, kHeight + 6, kMastSide});
    const Swatch steel = c.addSurface(kCarYellow), foot = c.addSurface(kConcrete);
    c.box({0, 0, 0}, {kMastSide, 8, kMastSide}, foot);
    for (int x : {0, kLast - 1})
        for (int z : {0, kLast - 1}) c.box({x, 8, z}, {x + 2, kHeight, z + 2}, steel);
    for (int y = 10; y + kPanel <= kHeight; y += kPanel) {
        const bool isOdd = y / kPanel % 2 != 0;
        for (int side : {0, kLast}) {
            c.box({0, y, side}, {kMastSide, y + 1, side + 1}, steel);
            c.box({side, y, 0}, {side + 1, y + 1, kMastSide}, steel);
            c.bar({isOdd ? 0 : kLast, y, side}, {isOdd ? kLast : 0, y + kPanel, side}, 1, steel);
            c.bar({side, y, isOdd ? kLast : 0}, {side, y + kPanel, isOdd ? 0 : kLast}, 1, steel);
        }
    }
    c.box({0, kHeight - 2, 0}, {kMastSide, kHeight, kMastSide}, steel);
    c.box({3, kHeight, 3}, {8, kHeight + 6, 8}, c.addSurface(kDarkSteel));
    LevelShape mast = c.finish("mast");
    mast.loadBearing = false;
    return mast;
}

/// Counterweight, cabin, jib and stays, along x.
LevelShape makeJib() {
    constexpr int kHigh = 30, kChord = 9, kMiddle = kJibSide / 2;
    Canvas c({kTip + 4, kHigh, kJibSide});
    const Swatch steel = c.addSurface(kCarYellow), dark = c.addSurface(kDarkSteel),
                 weight = c.addSurface(kConcreteDark), glass = c.addSurface(kGlass), white = c.addSurface(kWhiteEnamel);
    for (int z : {0, kJibSide - 1}) c.box({2, 0, z}, {kTip + 3, 1, z + 1}, steel);
    c.box({kPivot, kChord - 1, kMiddle}, {kTip, kChord, kMiddle + 1}, steel);
    for (int x = 2; x < kTip; x += 8) {
        c.box({x, 0, 0}, {x + 1, 1, kJibSide}, steel);
        if (x < kPivot) continue;
        for (int z : {0, kJibSide - 1}) {
            c.bar({x, 0, z}, {x + 4, kChord - 1, kMiddle}, 1, steel);
            c.bar({x + 4, kChord - 1, kMiddle}, {std::min(x + 8, kTip), 0, z}, 1, steel);
        }
    }
    c.box({2, 0, 0}, {18, 10, kJibSide}, weight);
    c.box({kTip - 6, 0, 0}, {kTip + 3, 2, kJibSide}, dark);
    c.box({kPivot - 5, 0, 0}, {kPivot + 6, 3, kJibSide}, dark);
    for (int z : {1, kJibSide - 2}) c.bar({kPivot, 3, z}, {kPivot, kHigh - 1, kMiddle}, 2, steel);
    c.bar({kPivot, kHigh - 2, kMiddle}, {kPivot + 88, kChord, kMiddle}, 1, dark);
    c.bar({kPivot, kHigh - 2, kMiddle}, {12, 10, kMiddle}, 1, dark);
    c.box({kPivot + 7, 1, 0}, {kPivot + 18, 12, 2}, white);
    c.box({kPivot + 9, 5, 0}, {kPivot + 17, 11, 1}, glass);
    return c.finish("jib");
}

LevelShape makeWreckingBall() {
    constexpr int kSize = 15;
    Canvas c({kSize, kSize + 3, kSize});
    const Swatch steel = c.addSurface(kCastSteel);
    c.fill(ivec3(0), ivec3(kSize), [&](ivec3 cell) {
        const ivec3 d = cell - kSize / 2;
        return d.x * d.x + d.y * d.y + d.z * d.z <= 53 ? PaletteBuilder::pick(steel, cell) : uint8_t(0);
    });
    c.box({6, kSize - 1, 6}, {9, kSize + 3, 9}, steel);
    return c.finish("wrecking ball");
}

}  // namespace

void addCrane(Level& level, ivec3 cell, double slewSpeed) {
    addStatic(level, makeMast(), cell);
    const glm::dvec3 pivot = kVoxel * glm::dvec3(cell.x + 0.5 * kMastSide, kHeight + 6, cell.z + 0.5 * kMastSide);
    const glm::dvec3 pivotInJib = kVoxel * glm::dvec3(kPivot + 0.5, 0.5, 0.5 * kJibSide),
                     tipInJib = kVoxel * glm::dvec3(kTip - 1.5, 0.5, 0.5 * kJibSide);
    const glm::dquat heading(kSqrtHalf, 0.0, -kSqrtHalf, 0.0);  // turns the jib toward +z
    const glm::dquat upright(kSqrtHalf, 0.0, 0.0, kSqrtHalf);   // turns x to y
    LevelBody jib{.name = "jib", .pose = {pivot - heading * pivotInJib, heading}, .isStatic = false};
    jib.shapes.push_back(makeJib());
    const glm::dvec3 tip = jib.pose.transformPoint(tipInJib);
    level.bodies.push_back(std::move(jib));

    LevelShape shape = makeWreckingBall();
    const glm::dvec3 eye = kVoxel * glm::dvec3(7.5, 17.5, 7.5);
    LevelBody ball{.name = "wrecking ball", .pose = {tip - glm::dvec3(0.0, kRope, 0.0) - eye}, .isStatic = false};
    ball.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(ball));

    LevelJoint slew{{.name = "slew", .kind = JointKind::Hinge}, {"mast", "jib"}};
    slew.joint.ends[0].frame = {pivot - kVoxel * glm::dvec3(cell.x, cell.y, cell.z), upright};
    slew.joint.ends[1].frame = {pivotInJib, glm::conjugate(heading) * upright};
    slew.joint.motor = {MotorMode::Speed, slewSpeed, 1.0e6};
    level.joints.push_back(slew);
    LevelJoint rope{{.name = "rope", .kind = JointKind::Rope}, {"jib", "wrecking ball"}};
    rope.joint.ends[0].frame.position = tipInJib;
    rope.joint.ends[1].frame.position = eye;
    rope.joint.rope = {.length = kRope, .points = 26, .radius = 0.045, .massPerMetre = 6.0, .color = {58, 54, 50}};
    level.joints.push_back(rope);
}

}  // namespace rubble::scenes
