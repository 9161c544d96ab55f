#include "samples/scenes/steel_bridge.h"

#include <algorithm>
#include <cstdlib>

#include "runtime/core/random.h"
#include "samples/scenes/street.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

using Plan = SteelBridge;
constexpr int kDeck = Plan::kDepth;                  // y of the footways' tops
constexpr int kPanel = 23;                           // cells between the posts of a truss
constexpr int kRise = 46;                            // of the top chord over the deck, in the middle
constexpr int kTrusses[] = {11, Plan::kWidth - 15};  // x of their low sides
constexpr int kChord = 4;                            // width of a chord

struct BridgeSwatches {
    explicit BridgeSwatches(Canvas& c)
        : paint(c.addSurface(kBridgePaint)),
          rust(c.addSurface(kRust)),
          dark(c.addSurface(kDarkSteel)),
          stone(c.addSurface(kKerb)),
          joint(c.addSurface(kKerb, 76)),
          concrete(c.addSurface(kConcrete)),
          paving(c.addSurface(kPaving)),
          asphalt(c.addSurface(kAsphalt)),
          white(c.addSurface(kLaneWhite)) {}
    Swatch paint, rust, dark, stone, joint, concrete, paving, asphalt, white;
};

/// Height of the top chord's underside over the deck at z: a polygon with its corners at the posts.
int chordHeight(int z) {
    const auto atPost = [](int post) {
        const int from = std::abs(2 * post * kPanel - Plan::kLength);
        return kRise - 18 * from * from / (Plan::kLength * Plan::kLength);
    };
    const int post = z / kPanel, within = z % kPanel;
    return (atPost(post) * (kPanel - within) + atPost(post + 1) * within) / kPanel;
}

void drawAbutments(Canvas& c, const BridgeSwatches& s) {
    for (const int z : {0, Plan::kLength - Plan::kAbutment})
        c.fill({0, 0, z}, {Plan::kWidth, kDeck - 3, z + Plan::kAbutment}, [&](ivec3 cell) {
            const int row = cell.y / 4, shifted = cell.x + cell.z + row % 2 * 4;
            return cell.y % 4 == 0 || shifted % 8 == 0
                       ? PaletteBuilder::pick(s.joint, cell)
                       : PaletteBuilder::pickFor(s.stone, hashCell(shifted / 8, row, 0, 193));
        });
}

/// Girders from truss to truss and stringers along them carry a slab with a road between two footways.
void drawDeck(Canvas& c, const BridgeSwatches& s) {
    for (int z = 0; z < Plan::kLength; z += kPanel)
        c.box({2, kDeck - 8, z}, {Plan::kWidth - 2, kDeck - 3, z + 3}, s.paint);
    for (int x = 8; x < Plan::kWidth - 4; x += 16) c.box({x, kDeck - 6, 0}, {x + 2, kDeck - 3, Plan::kLength}, s.dark);
    const int roadLow = kTrusses[0] + kChord + 1, roadHigh = kTrusses[1] - 1;
    c.fill({0, kDeck - 3, 0}, {Plan::kWidth, kDeck, Plan::kLength}, [&](ivec3 cell) {
        const bool isRoad = cell.x >= roadLow && cell.x < roadHigh;
        if (cell.y == kDeck - 3) return PaletteBuilder::pick(isRoad ? s.asphalt : s.concrete, cell);
        if (isRoad) return uint8_t(0);
        if (cell.y == kDeck - 2) return PaletteBuilder::pick(s.concrete, cell);
        return PaletteBuilder::pick(cell.z % 8 == 0 ? s.concrete : s.paving, cell);
    });
    const int middle = (roadLow + roadHigh) / 2;
    for (int z = 0; z < Plan::kLength; ++z)
        if (z % 40 < 24) c.box({middle - 1, kDeck - 3, z}, {middle + 1, kDeck - 2, z + 1}, s.white);
    // Railings of the footways.
    for (const int x : {0, Plan::kWidth - 1}) {
        for (const int y : {5, 10}) c.box({x, kDeck + y, 0}, {x + 1, kDeck + y + 1, Plan::kLength}, s.dark);
        for (int z = 0; z < Plan::kLength; z += 8) c.box({x, kDeck, z}, {x + 1, kDeck + 11, z + 1}, s.dark);
    }
}

/// A truss: chords, posts and diagonals that fall toward the middle, as tension takes them.
void drawTruss(Canvas& c, int x, const BridgeSwatches& s) {
    c.box({x, kDeck - 8, 0}, {x + kChord, kDeck + 2, Plan::kLength}, s.paint);
    const int first = kPanel, last = Plan::kLength / kPanel * kPanel - kPanel;
    for (int z = first; z <= last + 3; ++z) {
        const int y = kDeck + chordHeight(std::min(z, last));
        c.box({x, y - 1, z}, {x + kChord, y + 4, z + 1}, s.paint);
    }
    for (int z = first; z <= last; z += kPanel) {
        c.box({x, kDeck, z}, {x + kChord, kDeck + chordHeight(z) + 4, z + 3}, s.paint);
        const int way = 2 * z + 3 < Plan::kLength ? 1 : -1;
        if (z + way * kPanel < first || z + way * kPanel > last) continue;
        c.bar({x, kDeck + chordHeight(z), z}, {x, kDeck, z + way * kPanel}, 3, s.paint);
    }
    // The sloping ends, from the bearings to the top chord.
    c.bar({x, kDeck, 2}, {x, kDeck + chordHeight(first), first}, 4, s.paint);
    c.bar({x, kDeck, Plan::kLength - 6}, {x, kDeck + chordHeight(last), last}, 4, s.paint);
    for (int z = 4; z < Plan::kLength - 4; z += 5)  // rivets
        c.box({x, kDeck, z}, {x + 1, kDeck + 1, z + 1}, s.rust);
}

/// Struts and crosses between the top chords.
void drawBracing(Canvas& c, const BridgeSwatches& s) {
    const int low = kTrusses[0], high = kTrusses[1];
    for (int z = 2 * kPanel; z <= Plan::kLength - 2 * kPanel; z += kPanel) {
        const int y = kDeck + chordHeight(z);
        c.box({low, y + 1, z}, {high + kChord, y + 4, z + 2}, s.paint);
        if (z + kPanel > Plan::kLength - 2 * kPanel) continue;
        const int next = kDeck + chordHeight(z + kPanel);
        c.bar({low, y + 1, z}, {high, next + 1, z + kPanel}, 2, s.paint);
        c.bar({high, y + 1, z}, {low, next + 1, z + kPanel}, 2, s.paint);
    }
}

}  // namespace

void addSteelBridge(Level& level, ivec3 cell) {
    Canvas c({Plan::kWidth, kDeck + kRise + 6, Plan::kLength});
    const BridgeSwatches s(c);
    drawAbutments(c, s);
    drawDeck(c, s);
    for (const int x : kTrusses) drawTruss(c, x, s);
    drawBracing(c, s);
    c.stain({0, 0, 0}, c.size(), s.rust, 9);
    c.removeUnanchored();
    addStatic(level, c.finish("steel bridge"), cell - ivec3(0, kDeck, 0));
}

}  // namespace rubble::scenes
