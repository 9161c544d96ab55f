// A brick wall is sprayed with a picture and then shattered: hammer, ball, charge. The paint goes with the pieces.
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/fracture.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/lamp.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/recipes.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"

namespace rubble::scenes {
namespace {

constexpr int kFoot = 3, kLength = 150, kTall = 46, kThick = 4;
constexpr ivec3 kWall{85, -kFoot, 150};
constexpr double kFace = (kWall.z + kThick - 0.5) * kVoxel;  // z of the painted face's outer cells

LevelShape makeMuralWall() {
    Canvas c({kLength, kFoot + kTall + 2, kThick + 2});
    const Swatch brick = c.mix(kBrick), joint = c.mix(kBrickJoint), dirty = c.mix(kBrick, 78), stone = c.mix(kKerb), plaster = c.mix(kPlaster),
                 grey = c.mix(kPlaster, 90), moss = c.mix(kMoss);
    for (int x = 0; x < kLength; ++x)
        for (int y = 0; y < kFoot + kTall; ++y)
            for (int k = 0; k < kThick; ++k) {
                const int shifted = x + y % 2 * 2 + k / 2 * 4;
                const uint32_t id = hashCell(shifted / 4, y, k / 2, 42);
                c.setEntry({x, y, 1 + k}, PaintBox::pickFor(shifted % 4 == 0 ? joint : id % 11 == 0 ? dirty : brick, id >> 8));
            }
    // Worn plaster over most of the face: a ground for the picture.
    c.fill({6, kFoot + 4, kThick}, {kLength - 6, kFoot + kTall - 1, kThick + 1}, [&](ivec3 cell) {
        const int edge = std::min({cell.x - 6, kLength - 7 - cell.x, cell.y - kFoot - 4, kFoot + kTall - 2 - cell.y});
        const int flaked = int(hashCell(cell.x / 5, cell.y / 4, 0, 151) % 100) - edge * 9;
        if (flaked > 10 || hashCell(cell.x / 9, cell.y / 6, 1, 152) % 17 == 0) return c.at(cell);
        return PaintBox::pick(hashCell(cell.x / 12, cell.y / 9, 2, 153) % 5 ? plaster : grey, cell);
    });
    c.box({0, kFoot + kTall, 0}, {kLength, kFoot + kTall + 2, kThick + 2}, stone);
    for (int x = 0; x < kLength; x += 49) c.box({x, 0, 0}, {std::min(x + 3, kLength), kFoot + kTall, kThick + 2}, brick);
    c.stain({0, kFoot, 0}, {kLength, kFoot + 4, kThick + 2}, moss, 30);
    return c.finish("mural wall");
}

/// A ball of heavy steel that comes in from the front, thrown to hit the wall at a third of its length.
void addBall(Level& level) {
    Canvas c(ivec3(13));
    const Swatch steel = c.mix(kCastSteel);
    c.fill(ivec3(0), ivec3(13), [&](ivec3 cell) {
        const ivec3 d = cell - 6;
        return d.x * d.x + d.y * d.y + d.z * d.z <= 40 ? PaintBox::pick(steel, cell) : uint8_t(0);
    });
    LevelShape ball = c.finish("ball");
    addLoose(level, std::move(ball), {196, 120, 440});
    level.bodies.back().velocity = {-1.4f, 9.5f, -9.2f};
}

Level wallLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 480};
    ground.areas = {area(Paving, 0, 160, 320, 206), area(Road, 0, 206, 320, 480)};
    ground.lanesAlongX = {{{0, 0, 256}, {320, 0, 258}}};
    Level level = makePlot("painted wall", ground, seed);
    addStatic(level, makeMuralWall(), kWall - ivec3(0, 0, 1));
    addBall(level);
    addStatic(level, makePicketFence("fence left", 72, 14, false), {10, -kFenceFoot, 152});
    addStatic(level, makePicketFence("fence right", 72, 14, false), {238, -kFenceFoot, 152});
    addStreetLamp(level, "lamp", {62, 0, 198}, false);
    addLoose(level, makeBench("bench"), {216, 0, 166});
    addLoose(level, makeBin("bin"), {206, 0, 168});
    for (int i = 0; i < 5; ++i) addLoose(level, makeCrate("crate " + std::to_string(i)), {120 + i % 3 * 11, i / 3 * 8, 124});
    addLoose(level, makeBarrel("barrel", kCarRed), {176, 0, 128});
    return level;
}

/// A point of the wall's face, in cells from its lower left corner.
glm::dvec3 onFace(double x, double y) {
    return {(kWall.x + x) * kVoxel, y * kVoxel, kFace};
}

using Color = std::array<uint8_t, 3>;
constexpr Color kNight{26, 38, 92}, kSunset{238, 84, 52}, kGold{250, 196, 40}, kPink{236, 40, 128}, kTeal{20, 150, 150}, kWhite{245, 240, 225};

void sprayDisc(ScriptClock& clock, double from, double to, glm::dvec2 center, double radius, Color color, uint32_t seed) {
    constexpr int kStrokes = 60;
    for (int i = clock.first(from, kStrokes, to); i < clock.last(from, kStrokes, to); ++i) {
        // Rows of five: a disc filled from below.
        const double y = -radius + 2.0 * radius * (i / 5 + 0.5) / (kStrokes / 5.0), half = glm::sqrt(std::max(0.0, radius * radius - y * y));
        const double x = half * (i % 5 - 2) / 2.2;
        clock.add(PaintEdit{onFace(center.x + x, center.y + y), 0.035 * radius, color, 220, 220, seed + uint32_t(i)});
    }
}

/// Three bands of sky, a setting sun with its glow, and the word over it.
void sprayPicture(ScriptClock& clock) {
    for (int i = clock.first(0.2, 150, 1.6); i < clock.last(0.2, 150, 1.6); ++i) {
        const int row = i / 30, column = i % 30;
        const Color& color = row == 0 ? kTeal : row < 3 ? kSunset : row == 3 ? kPink : kNight;
        const double x = (row % 2 ? 29 - column : column) * 4.6 + 8.0;
        clock.add(PaintEdit{onFace(x, 9.0 + row * 7.6), 0.62, color, 150, 120, uint32_t(i)});
    }
    sprayDisc(clock, 1.4, 2.0, {112, 20}, 11.0, kGold, 1000);
    constexpr std::string_view kWord = "RUBBLE";
    for (int letter = clock.first(1.7, 6, 2.9); letter < clock.last(1.7, 6, 2.9); ++letter)
        for (int row = 0; row < kLetterHeight; ++row)
            for (int column = 0; column < kLetterWidth; ++column)
                if (letterRows(kWord[size_t(letter)])[row] >> (kLetterWidth - 1 - column) & 1)
                    clock.add(PaintEdit{onFace(13.0 + (letter * kLetterAdvance + column) * 2.4, 12.0 + (kLetterHeight - 1 - row) * 2.4), 0.17, kWhite,
                                        235, 255, uint32_t(letter * 100 + row * 10 + column)});
}

Edits wallScript(int step, uint64_t seed) {
    ScriptClock clock(step);
    sprayPicture(clock);
    // The ball arrives at about 2.6 s: the wall cracks around the place and gives way there.
    const glm::dvec3 hit = onFace(92, 27) - glm::dvec3(0, 0, 0.15), left = onFace(36, 20) - glm::dvec3(0, 0, 0.15),
                     right = onFace(122, 18) - glm::dvec3(0, 0, 0.15);
    clock.spread(2.95, 3.05, fracture({hit, 2, 1.9, 0.4, 11, Hardness::Medium, seed + 1}));
    for (int i = 0; i < 4; ++i)
        if (clock.at(3.5 + 0.22 * i)) clock.add(carveSphere(onFace(18.0 + i * 9, 30.0 - i % 2 * 9), {0.5, 0.38, 0.0}));
    clock.spread(4.3, 4.5, fracture({left, 2, 2.3, 0.4, 11, Hardness::Medium, seed + 2}));
    if (clock.at(4.55)) clock.add(ExplodeEdit{left - glm::dvec3(0, 0.3, 0.9), 1.7, 5000});
    clock.spread(5.2, 5.4, fracture({right, 2, 2.1, 0.4, 12, Hardness::Medium, seed + 3}));
    if (clock.at(5.45)) clock.add(ExplodeEdit{right - glm::dvec3(0, 0.2, 0.8), 1.5, 4000});
    return clock.take();
}

Pose wallCamera(double seconds) {
    return lookAt({12.4 + 0.1 * seconds, 2.6, 29.5}, {16.2, 2.2, 15.0});
}

}  // namespace

Scene wallScene() {
    Scene scene{"wall", "a painted wall, shattered by hammer, ball and charge", wallLevel, wallScript, wallCamera};
    scene.steps = 450;
    return scene;
}

}  // namespace rubble::scenes
