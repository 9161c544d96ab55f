// A raft of logs with cargo floats in a basin. A charge under its middle blows it apart; its wood floats.
#include "runtime/core/random.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr ivec3 kBasin{60, 0, 100};   // low corner, in cells
constexpr ivec3 kSize{200, 16, 150};  // of the basin with its walls
constexpr int kWall = 5, kFloor = 3;  // thickness in cells
constexpr double kSurface = 1.25;     // height of the water in metres
constexpr ivec3 kRaft{130, 11, 140};

void addBasin(Level& level) {
    Canvas c(kSize);
    const Swatch stone = c.addSurface(kConcrete), rim = c.addSurface(kPaving), tile = c.addSurface(kTileWhite),
                 line = c.addSurface(kPlasterBlue);
    c.box({0, 0, 0}, kSize, stone);
    c.clear({kWall, kFloor, kWall}, {kSize.x - kWall, kSize.y, kSize.z - kWall});
    c.fill({kWall, kFloor - 1, kWall}, {kSize.x - kWall, kFloor, kSize.z - kWall},
           [&](ivec3 cell) { return PaletteBuilder::pick(cell.x % 10 == 0 || cell.z % 10 == 0 ? line : tile, cell); });
    for (const auto& [low, high] : {std::pair(ivec3(0, kSize.y - 2, 0), ivec3(kSize.x, kSize.y, kWall)),
                                    std::pair(ivec3(0, kSize.y - 2, kSize.z - kWall), ivec3(kSize.x, kSize.y, kSize.z)),
                                    std::pair(ivec3(0, kSize.y - 2, 0), ivec3(kWall, kSize.y, kSize.z)),
                                    std::pair(ivec3(kSize.x - kWall, kSize.y - 2, 0), kSize)})
        c.box(low, high, rim);
    addStatic(level, c.finish("basin"), kBasin);
    const double low = (kBasin.x + kWall) * kVoxel, high = (kBasin.x + kSize.x - kWall) * kVoxel,
                 near = (kBasin.z + kWall) * kVoxel, far = (kBasin.z + kSize.z - kWall) * kVoxel;
    level.waters.push_back({.name = "basin",
                            .outline = {{low, near}, {high, near}, {high, far}, {low, far}},
                            .surface = kSurface,
                            .depth = kSurface - kFloor * kVoxel,
                            .linearDrag = 1.2,
                            .angularDrag = 1.2,
                            .color = {0.25f, 0.55f, 0.52f},
                            .clarity = 2.0f,
                            .waves = {.height = 0.02f, .length = 1.6f, .speed = 0.5f, .direction = 0.6f}});
}

/// Logs side by side with planks across them.
LevelShape makeRaft() {
    constexpr int kLogs = 9, kLog = 4, kLength = 52;
    Canvas c({kLength, kLog + 2, kLogs * kLog});
    const Swatch bark = c.addSurface(kBark), timber = c.addSurface(kTimber), board = c.addSurface(kFenceWood);
    for (int i = 0; i < kLogs; ++i)
        c.fill({i % 2, 0, i * kLog}, {kLength - (i + 1) % 2, kLog, (i + 1) * kLog}, [&](ivec3 cell) {
            const int y = cell.y, z = cell.z - i * kLog;
            const bool isCorner = (y == 0 || y == kLog - 1) && (z == 0 || z == kLog - 1);
            if (isCorner && y == 0) return uint8_t(0);
            const bool isEnd = cell.x < 2 || cell.x >= kLength - 2;
            return PaletteBuilder::pick(isEnd ? timber : bark, cell);
        });
    for (const int x : {6, 18, 30, 42}) c.box({x, kLog, 0}, {x + 4, kLog + 2, kLogs * kLog}, board);
    return c.finish("raft");
}

Level raftLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 40, 80, 280, 270)};
    Level level = makePlot("basin", ground, seed);
    addBasin(level);
    addDynamic(level, makeRaft(), kRaft);
    const ivec3 deck = kRaft + ivec3(0, 6, 0);
    addDynamic(level, makeCrate("crate 1"), deck + ivec3(8, 0, 4));
    addDynamic(level, makeCrate("crate 2"), deck + ivec3(8, 0, 18), Turn::Askew);
    addDynamic(level, makeBarrel("barrel 1", kCarRed), deck + ivec3(30, 0, 6));
    addDynamic(level, makeBarrel("barrel 2", kCarBlue), deck + ivec3(32, 0, 20));
    addDynamic(level, makeChair("chair", kRedWood), deck + ivec3(20, 0, 14), Turn::Quarter);
    addDynamic(level, makeTable("floating table"), {90, 14, 200}, Turn::Askew);
    addDynamic(level, makeCrate("floating crate"), {210, 14, 130}, Turn::Askew);
    for (LevelBody& body : level.bodies)
        if (!body.isStatic) body.velocity.y = -0.1f;  // a moving body does not fall asleep on the water
    addDynamic(level, makeBench("bench"), {150, 0, 258});
    addTree(level, "bank tree 1", {286, 0, 120}, 80, kLeaves, seed + 3);
    addTree(level, "bank tree 2", {34, 0, 150}, 70, kLeavesAutumn, seed + 4);
    return level;
}

Edits raftScript(int step, uint64_t seed) {
    ScriptClock clock(step);
    const glm::dvec3 middle = atCell(kRaft.x + 26, 12, kRaft.z + 18);
    if (clock.at(5.0))
        clock.add(BreakEdit{
            .position = middle, .radii = {2.2, 1.6, 1.0}, .tool = Tool::Explosive, .seed = uint32_t(seed) + 7});
    if (clock.at(5.0))
        clock.add(ExplodeEdit{.position = middle - glm::dvec3(0.0, 0.3, 0.0), .size = 1.6, .impulse = 2500.0});
    return clock.take();
}

Pose raftCamera(double seconds) {
    return lookAt({11.5 + 0.12 * seconds, 5.2, 26.5}, {15.6, 0.9, 16.2});
}

}  // namespace

Scene raftScene() {
    Scene scene{"raft", "a raft that is blown up afloat", raftLevel, raftScript, raftCamera};
    scene.steps = 900;
    return scene;
}

}  // namespace rubble::scenes
