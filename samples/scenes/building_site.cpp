#include "samples/scenes/building_site.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/crane.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kFoot = 3, kStoreyHeight = 30, kBay = 40, kColumn = 5, kStoreys = 3;
constexpr int kBaysX = 3, kBaysZ = 2;
constexpr ivec3 kFrameSize{kBaysX * kBay + kColumn, kFoot + kStoreys* kStoreyHeight + 14, kBaysZ* kBay + kColumn};

struct SiteSwatches {
    explicit SiteSwatches(Canvas& c)
        : concrete(c.addSurface(kConcrete)),
          slab(c.addSurface(kConcrete, 90)),
          rebar(c.addSurface(kRebar)),
          brick(c.addSurface(kBrick)),
          joint(c.addSurface(kBrickJoint)),
          board(c.addSurface(kFenceWood)),
          pipe(c.addSurface(kSteel)) {}
    Swatch concrete, slab, rebar, brick, joint, board, pipe;
};

/// Columns with bars that stand out of the last storey, and slabs with an opening for stairs. The last slab has not
/// been poured over one row of bays.
void drawFrame(Canvas& c, const SiteSwatches& s) {
    for (int i = 0; i <= kBaysX; ++i)
        for (int k = 0; k <= kBaysZ; ++k) {
            const int x = i * kBay, z = k * kBay, top = kFoot + kStoreys * kStoreyHeight;
            c.box({x - 1, 0, z - 1}, {x + kColumn + 1, kFoot, z + kColumn + 1}, s.slab);
            c.box({x, 0, z}, {x + kColumn, top, z + kColumn}, s.concrete);
            for (const int dx : {1, 3})
                for (const int dz : {1, 3}) {
                    const int over = 6 + int(hashCell(i, dx, k * 4 + dz, 251) % 7);
                    c.box({x + dx, 0, z + dz}, {x + dx + 1, top + over, z + dz + 1}, s.rebar);
                }
        }
    c.box({2 * kBay + 8, 0, kColumn + 7}, {2 * kBay + 12, kFoot, kColumn + 17}, s.slab);  // the foot of the stairs
    for (int storey = 1; storey <= kStoreys; ++storey) {
        const int y = kFoot + storey * kStoreyHeight - 3;
        const int end = storey == kStoreys ? kBay + kColumn : kFrameSize.z;
        c.box({0, y, 0}, {kFrameSize.x, y + 3, end}, s.slab);
        for (int x = 3; x < kFrameSize.x - 2; x += 6)
            c.box({x, y + 1, 1}, {x + 1, y + 2, std::min(end + 5, kFrameSize.z)}, s.rebar);
        c.clear({2 * kBay + 10, y, kColumn + 6}, {2 * kBay + 33, y + 3, kColumn + 18});
        for (int step = 0; step < kStoreyHeight; ++step) {  // stairs of rough concrete
            const int x = 2 * kBay + 8 + step * 24 / kStoreyHeight;
            c.box({x, y - kStoreyHeight + 3 + std::max(0, step - 3), kColumn + 7},
                  {x + 2, y - kStoreyHeight + 3 + step + 1, kColumn + 17}, s.slab);
        }
        for (int i = 0; i <= kBaysX; ++i)
            for (int k = 0; k <= kBaysZ; ++k)
                c.box({i * kBay, y, k * kBay}, {i * kBay + kColumn, y + 3, k * kBay + kColumn}, s.concrete);
    }
}

/// Bricks between the columns of the lowest storeys, up to a ragged edge.
void drawBrickwork(Canvas& c, const SiteSwatches& s) {
    for (int storey = 0; storey < 2; ++storey)
        for (int bay = 0; bay < kBaysX; ++bay)
            for (int u = kColumn; u < kBay; ++u) {
                const int low = kFoot + storey * kStoreyHeight, x = bay * kBay + u;
                const int done =
                    storey == 0 ? kStoreyHeight - 3 : 10 - bay * 4 + int(hashCell(x / 4, storey, bay, 257) % 3) * 2;
                for (int y = 0; y < std::min(done, kStoreyHeight - 3); ++y) {
                    const bool isWindow = u >= 14 && u < 31 && y >= 8 && y < 23;
                    if (isWindow) continue;
                    const bool isJoint = (x + y / 2 % 2 * 2) % 4 == 0 && y % 2 == 0;
                    for (int k = 1; k < 3; ++k) c.set({x, low + y, kFrameSize.z - 1 - k}, isJoint ? s.joint : s.brick);
                }
            }
}

/// Pipes and boards along the front, three lifts high.
LevelShape makeScaffold(std::string name) {
    constexpr int kLength = kFrameSize.x, kHeight = 74;
    Canvas c({kLength, kHeight, 9});
    const Swatch pipe = c.addSurface(kSteel), board = c.addSurface(kFenceWood), foot = c.addSurface(kTimber);
    for (int x = 2; x < kLength; x += 20)
        for (const int z : {0, 8}) {
            c.box({x - 1, 0, z == 0 ? 0 : 7}, {x + 2, 1, z == 0 ? 2 : 9}, foot);
            c.box({x, 1, z}, {x + 1, kHeight, z + 1}, pipe);
        }
    for (int y = 22; y < kHeight; y += 22) {
        for (int x = 2; x < kLength; x += 20) c.box({x, y, 0}, {x + 1, y + 1, 9}, pipe);
        for (const int z : {0, 8}) c.box({2, y, z}, {kLength - 2, y + 1, z + 1}, pipe);
        c.fill({2, y + 1, 1}, {kLength - 2, y + 2, 8},
               [&](ivec3 cell) { return PaletteBuilder::pickFor(board, hashCell(cell.x / 40, y, cell.z / 2, 263)); });
        c.box({2, y + 10, 8}, {kLength - 2, y + 11, 9}, pipe);
    }
    for (int x = 2; x + 20 < kLength; x += 40) c.bar({x, 1, 8}, {x + 20, 22, 8}, 1, pipe);
    LevelShape scaffold = c.finish(std::move(name));
    scaffold.loadBearing = false;  // pipes one voxel thick, too thin for the stress analysis
    return scaffold;
}

LevelShape makeStack(std::string name, ivec3 size, const SurfaceStyle& style, bool isRagged) {
    Canvas c(size);
    const Swatch pallet = c.addSurface(kFenceWood), swatch = c.addSurface(style), dark = c.addSurface(style, 84);
    for (int z = 0; z < size.z; z += 3) c.box({0, 0, z}, {size.x, 1, std::min(z + 2, size.z)}, pallet);
    c.box({0, 1, 0}, {size.x, 2, size.z}, pallet);
    c.fill({0, 2, 0}, size, [&](ivec3 cell) {
        if (isRagged && cell.y > size.y - 4 && hashCell(cell.x / 4, cell.y / 2, cell.z / 2, 269) % 3 == 0)
            return uint8_t(0);
        return PaletteBuilder::pick((cell.x / 4 + cell.y / 2) % 2 ? swatch : dark, cell);
    });
    c.removeUnanchored();
    return c.finish(std::move(name));
}

}  // namespace

void addBuildingSite(Level& level, ivec3 cell) {
    const ivec3 frame = cell + ivec3(30, 0, 60);
    Canvas c(kFrameSize);
    const SiteSwatches s(c);
    drawFrame(c, s);
    drawBrickwork(c, s);
    c.removeUnanchored();
    addStatic(level, c.finish("shell of a building"), frame - ivec3(0, kFoot, 0));
    addStatic(level, makeScaffold("scaffold"), frame + ivec3(0, 0, kFrameSize.z + 1));
    addCrane(level, cell + ivec3(190, 0, 40), 0.0);
    addDynamic(level, makeStack("stack of bricks 1", {12, 12, 10}, kBrick, true), cell + ivec3(40, 0, 190));
    addDynamic(level, makeStack("stack of bricks 2", {12, 10, 10}, kBrickYellow, true), cell + ivec3(60, 0, 192));
    addDynamic(level, makeStack("stack of boards", {30, 8, 8}, kTimber, false), cell + ivec3(84, 0, 194));
    addDynamic(level, makeCrate("site crate 1"), cell + ivec3(130, 0, 190));
    addDynamic(level, makeCrate("site crate 2"), cell + ivec3(140, 0, 196));
    addDynamic(level, makeBarrel("site barrel", kCarYellow), cell + ivec3(152, 0, 188));
    addStatic(level, makePicketFence("site fence", 240, 14, false), cell + ivec3(10, -kFenceFoot, 234));
}

}  // namespace rubble::scenes
