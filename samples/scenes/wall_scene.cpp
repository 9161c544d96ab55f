// A mural is sprayed on a brick wall; then a hammer, a ball and charges break the wall. The pieces keep the paint.
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kFoot = 3, kLength = 150, kHeight = 46, kThickness = 4;
constexpr ivec3 kWall{85, -kFoot, 150};
constexpr double kFace = (kWall.z + kThickness - 0.5) * kVoxel;  // z of the outer cells of the painted face

LevelShape makeMuralWall() {
    Canvas c({kLength, kFoot + kHeight + 2, kThickness + 2});
    const Swatch brick = c.addSurface(kBrick), joint = c.addSurface(kBrickJoint), dirty = c.addSurface(kBrick, 78),
                 stone = c.addSurface(kKerb), plaster = c.addSurface(kRender), grey = c.addSurface(kRender, 90),
                 moss = c.addSurface(kMoss);
    for (int x = 0; x < kLength; ++x)
        for (int y = 0; y < kFoot + kHeight; ++y)
            for (int k = 0; k < kThickness; ++k) {
                const int shifted = x + y % 2 * 2 + k / 2 * 4;
                const uint32_t id = hashCell(shifted / 4, y, k / 2, 42);
                c.setEntry({x, y, 1 + k}, PaletteBuilder::pickFor(shifted % 4 == 0 ? joint
                                                                  : id % 11 == 0   ? dirty
                                                                                   : brick,
                                                                  id >> 8));
            }
    // Worn plaster over most of the face, under the mural.
    c.fill({6, kFoot + 4, kThickness}, {kLength - 6, kFoot + kHeight - 1, kThickness + 1}, [&](ivec3 cell) {
        const int edge = std::min({cell.x - 6, kLength - 7 - cell.x, cell.y - kFoot - 4, kFoot + kHeight - 2 - cell.y});
        const int flaked = int(hashCell(cell.x / 5, cell.y / 4, 0, 151) % 100) - edge * 9;
        if (flaked > 10 || hashCell(cell.x / 9, cell.y / 6, 1, 152) % 17 == 0) return c.at(cell);
        return PaletteBuilder::pick(hashCell(cell.x / 12, cell.y / 9, 2, 153) % 5 ? plaster : grey, cell);
    });
    c.box({0, kFoot + kHeight, 0}, {kLength, kFoot + kHeight + 2, kThickness + 2}, stone);
    for (int x : {0, kLength - 3}) c.box({x, 0, 0}, {x + 3, kFoot + kHeight, kThickness + 2}, brick);
    c.stain({0, kFoot, 0}, {kLength, kFoot + 4, kThickness + 2}, moss, 30);
    return c.finish("mural wall");
}

/// A ball of heavy steel, thrown from far behind the camera; it hits the word.
void addBall(Level& level) {
    Canvas c(ivec3(13));
    const Swatch steel = c.addSurface(kCastSteel);
    c.fill(ivec3(0), ivec3(13), [&](ivec3 cell) {
        const ivec3 d = cell - 6;
        return d.x * d.x + d.y * d.y + d.z * d.z <= 40 ? PaletteBuilder::pick(steel, cell) : uint8_t(0);
    });
    LevelShape ball = c.finish("ball");
    addDynamic(level, std::move(ball), {206, 34, 900});
    level.bodies.back().velocity = {-1.7f, 13.65f, -25.8f};
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
    addStreetLight(level, "street light", {62, 0, 198}, false);
    addDynamic(level, makeBench("bench"), {216, 0, 166});
    addDynamic(level, makeBin("bin"), {206, 0, 168});
    for (int i = 0; i < 5; ++i)
        addDynamic(level, makeCrate("crate " + std::to_string(i)), {120 + i % 3 * 11, i / 3 * 8, 124});
    addDynamic(level, makeBarrel("barrel", kCarRed), {176, 0, 128});
    return level;
}

/// A point of the wall's face in metres, given in cells from its lower left corner.
glm::dvec3 onFace(double x, double y) {
    return {(kWall.x + x) * kVoxel, y * kVoxel, kFace};
}

using Color = std::array<uint8_t, 3>;
constexpr Color kNight{44, 36, 96}, kPurple{126, 44, 132}, kPink{232, 52, 112}, kOrange{246, 112, 44},
    kGold{252, 184, 52}, kSun{255, 232, 150}, kSea{16, 104, 122}, kFoam{30, 164, 160}, kWhite{248, 244, 232},
    kShade{34, 24, 66};

/// A stroke of the spray can across the wall, one piece per step; blue noise breaks up its rim.
void sprayBand(ScriptClock& clock, double from, double to, double y, Color color, uint32_t seed) {
    constexpr int kPieces = 15;
    constexpr double kLeft = 7.0, kPiece = (kLength - 2 * kLeft) / kPieces;
    for (int i = clock.first(from, kPieces, to); i < clock.last(from, kPieces, to); ++i) {
        PaintEdit stroke{onFace(kLeft + i * kPiece, y), 0.50, color, 255, 0, seed, 255};
        stroke.kind = BrushKind::Capsule;
        stroke.end = onFace(kLeft + (i + 1) * kPiece, y);
        clock.add(stroke);
    }
}

/// One dot of spray for each pixel of a letter.
void sprayWord(ScriptClock& clock, double from, double to, glm::dvec2 low, Color color, uint32_t seed) {
    constexpr std::string_view kWord = "RUBBLE";
    constexpr double kPixel = 3.0;
    for (int letter = clock.first(from, 6, to); letter < clock.last(from, 6, to); ++letter)
        for (int row = 0; row < kLetterHeight; ++row)
            for (int column = 0; column < kLetterWidth; ++column)
                if (letterRows(kWord[size_t(letter)])[row] >> (kLetterWidth - 1 - column) & 1)
                    clock.add(PaintEdit{onFace(low.x + (letter * kLetterAdvance + column) * kPixel,
                                               low.y + (kLetterHeight - 1 - row) * kPixel),
                                        0.22, color, 255, 200, seed, 255});
}

/// An evening sky from the top down, a sun, the sea in front of it, and a word with its shadow.
void sprayMural(ScriptClock& clock) {
    constexpr Color kSky[] = {kNight, kPurple, kPurple, kPink, kPink, kOrange, kGold};
    for (int row = 0; row < 7; ++row)
        sprayBand(clock, 0.1 + 0.16 * row, 0.26 + 0.16 * row, 40.5 - row * 5.0, kSky[row], 11 + uint32_t(row));
    for (int ring = 0; ring < 3; ++ring)
        if (clock.at(1.3 + 0.1 * ring))
            clock.add(PaintEdit{onFace(129, 16), 1.35 - 0.2 * ring, ring == 0 ? kGold : kSun, 255, 0, 31, 255});
    sprayBand(clock, 1.6, 1.75, 9.0, kFoam, 41);
    sprayBand(clock, 1.7, 1.85, 5.0, kSea, 42);
    sprayWord(clock, 1.85, 2.2, {15.2, 14.8}, kShade, 51);
    sprayWord(clock, 2.0, 2.4, {14.0, 16.0}, kWhite, 52);
}

Edits wallScript(int step, uint64_t seed) {
    ScriptClock clock(step);
    sprayMural(clock);
    // The ball hits at about 2.9 s. Then follow four blows of a hammer and two charges behind the wall.
    for (int i = 0; i < 4; ++i)
        if (clock.at(3.5 + 0.16 * i))
            clock.add(
                BreakEdit{onFace(18.0 + i * 8, 33.0 - i % 2 * 10), {0.45, 0.4, 0.0}, Tool::Any, uint32_t(seed) + i});
    const glm::dvec3 behind(0, 0, -0.9);
    if (clock.at(4.3)) clock.add(ExplodeEdit{onFace(34, 19) + behind, 2.8, 7000});
    if (clock.at(5.1)) clock.add(ExplodeEdit{onFace(124, 20) + behind, 2.5, 6000});
    return clock.take();
}

Pose wallCamera(double seconds) {
    return lookAt({12.4 + 0.1 * seconds, 2.6, 29.5}, {16.2, 2.2, 15.0});
}

}  // namespace

Scene wallScene() {
    Scene scene{"wall", "a painted wall, shattered by hammer, ball and charge", wallLevel, wallScript, wallCamera};
    scene.steps = 400;
    scene.settings.paint.mode = PaintMode::Layer;
    scene.settings.impactRadiusLimit = 1.0;
    scene.settings.stress.on = true;

    return scene;
}

}  // namespace rubble::scenes
