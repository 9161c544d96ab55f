#include "samples/scenes/tree.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

/// A clump of leaves: an ellipsoid with a ragged rim and gaps, through which light falls.
void drawClump(Canvas& c, ivec3 center, ivec3 radius, Swatch leaf, Swatch shade) {
    c.fill(glm::max(center - radius, ivec3(0)), glm::min(center + radius + 1, c.size()), [&](ivec3 cell) {
        if (c.at(cell)) return c.at(cell);
        const ivec3 d = cell - center;
        const int distance = d.x * d.x * 1024 / (radius.x * radius.x) + d.y * d.y * 1024 / (radius.y * radius.y) +
                             d.z * d.z * 1024 / (radius.z * radius.z);
        const int ragged = int(hashCell(cell.x / 2, cell.y / 2, cell.z / 2, 91) % 480);
        if (distance + ragged > 1130) return uint8_t(0);
        if (distance < 560 && hashCell(cell.x / 3, cell.y / 3, cell.z / 3, 92) % 3 != 0) return uint8_t(0);
        return PaletteBuilder::pick(d.y < -radius.y / 4 ? shade : leaf, cell);
    });
}

}  // namespace

LevelShape makeTree(std::string name, int height, const SurfaceStyle& leaves, uint64_t seed) {
    const int half = height * 2 / 5;
    Canvas c({2 * half + 1, height + kTreeRoot, 2 * half + 1});
    const Swatch bark = c.addSurface(kBark), leaf = c.addSurface(leaves), shade = c.addSurface(leaves, 78);
    Random random(seed);
    const ivec3 foot(half, 0, half);
    const int fork = kTreeRoot + height * 2 / 5;
    c.ring(1, 0, kTreeRoot + 2, {2 * half + 1, 0, 2 * half + 1}, -1, 7, bark);
    c.ring(1, 0, fork, {2 * half + 1, 0, 2 * half + 1}, -1, 5, bark);

    struct Clump {
        ivec3 center, radius;
    };
    std::vector<Clump> clumps;
    const int branches = 6 + int(random.below(3));
    for (int i = 0; i < branches; ++i) {
        // Branches grow in eight directions in turn, with jitter.
        static constexpr ivec3 kBranchDirections[8] = {{4, 0, 0},  {-3, 0, 3}, {0, 0, -4}, {3, 0, 3},
                                                       {-4, 0, 0}, {3, 0, -3}, {0, 0, 4},  {-3, 0, -3}};
        const int start = fork - int(random.below(uint32_t(height / 7 + 1)));
        const int length = half * random.between(38, 62) / 100;
        const int rise = height * random.between(12, 38) / 100;
        const int jitterX = random.between(-3, 3), jitterZ = random.between(-3, 3);
        const ivec3 direction = kBranchDirections[(i + int(seed % 8)) % 8];
        const ivec3 tip = ivec3(half, start + rise, half) + direction * length / 4 + ivec3(jitterX, 0, jitterZ);
        c.bar({half, start, half}, tip, i < 4 ? 2 : 1, bark);
        const int size = half * random.between(42, 58) / 100;
        clumps.push_back({tip + ivec3(0, 2, 0), {size, size * 3 / 4, size}});
    }
    const ivec3 crown(half, kTreeRoot + height * 3 / 4, half);
    c.bar({half, fork - 2, half}, crown, 2, bark);
    clumps.push_back({crown, {half * 6 / 10, height / 5, half * 6 / 10}});
    for (const Clump& clump : clumps) drawClump(c, clump.center, clump.radius, leaf, shade);
    c.removeUnanchored();
    return c.finish(std::move(name));
}

LevelShape makeHedge(std::string name, ivec3 size) {
    Canvas c({size.x, size.y + kHedgeRoot, size.z});
    const Swatch leaf = c.addSurface(kHedge), dark = c.addSurface(kHedge, 80), bark = c.addSurface(kBark);
    const ivec3 full = c.size();
    c.fill(ivec3(0), full, [&](ivec3 cell) {
        const bool rim =
            cell.x == 0 || cell.z == 0 || cell.x == full.x - 1 || cell.z == full.z - 1 || cell.y == full.y - 1;
        const uint32_t dice = hashCell(cell.x / 2, cell.y / 2, cell.z / 2, 95);
        if (rim && dice % 5 < 2) return uint8_t(0);
        const bool isInside =
            std::min({cell.x, cell.z, full.x - 1 - cell.x, full.z - 1 - cell.z}) > 2 && cell.y < full.y - 3;
        if (isInside && cell.y > 1) return (cell.x + cell.z) % 5 == 0 ? PaletteBuilder::pick(bark, cell) : uint8_t(0);
        return PaletteBuilder::pick(dice % 7 < 2 ? dark : leaf, cell);
    });
    c.removeUnanchored();
    return c.finish(std::move(name));
}

}  // namespace rubble::scenes
