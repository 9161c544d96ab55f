#include "runtime/destruction/heat.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/random.h"
#include "runtime/destruction/spray.h"

// Heat by bricks, as lumped capacities in integers.
//
// A brick holds one heat Q (mJ above ambient) in the skin of its exposed voxels, which has the heat capacity C = sum of
// c rho face kSkin: one face of each such voxel, with its specific heat c and density rho. So the temperature above
// ambient is Q / C, the same over the brick.
//   * Cooling is Newton's law dQ/dt = -Q / tau: each update takes away Q / 2^kCoolingShift.
//   * A brick ignites when Q reaches C times the lowest ignition temperature of its voxels.
//   * A burning brick emits kFlux times the same faces of its burnable voxels, after a linear growth over
//     kGrowthUpdates. Fixed shares of that go to the bricks around (kShare...), most upward; the rest is smoke.
//   * Exposed voxels burn away at the rate 1 / burnTime each: a surface recedes by about a voxel in a burn time.
// The strength falls with charring, and with the temperature of what does not burn, as that of steel (EN 1993-1-2).

namespace rubble {
namespace {

constexpr double kSkin = 0.0008;      ///< m: depth of the surface layer that heats up at once
constexpr double kFlux = 400e3;       ///< W/m2 of burning surface; real fires release 100e3 to 300e3 and are slower
constexpr int kCoolingShift = 9;      ///< a brick loses 1/512 of its heat per update: a time constant of 51 s
constexpr int kNegligibleKelvin = 2;  ///< above ambient: a cooler brick is forgotten
constexpr int kGrowthUpdates = 20;    ///< until a fire reaches its full power
constexpr int kCharEvery = 4;         ///< updates between two rounds of charring
constexpr int kCharShare = 160;       ///< voxels that get darker in a round, of 256
constexpr int kCharLoss = 160;        ///< of the strength, in 1/256: what charring to black takes
constexpr int kMinFrontVoxels = 8;    ///< fewer burnable voxels burn as fast as this many, so that the last ones go too
/// Voxels burn away in the order of their covered faces, with noise up to the weight of three faces.
constexpr uint32_t kFaceWeight = 350, kOrderNoise = 1023;
constexpr int kMaxFlameBricks = 3;  ///< how far up flames heat the next brick
constexpr int kShareUp = 72;        ///< of emitted heat, in 1/256: to the next brick above; what is left over is smoke
constexpr int kShareUpAside = 14;   ///< to each of the four bricks diagonally above
constexpr int kShareAside = 24;     ///< to each of the four bricks at the side
constexpr int kShareDown = 8;       ///< to the brick below
constexpr int kSteelWeakens = 380;  ///< K above ambient: steel has its full strength (EN 1993-1-2, table 3.1)
constexpr int kSteelIsSoft = 900;   ///< K above ambient: steel has almost none; linear between the two
constexpr int kSteelFails = kSteelIsSoft + 40;  ///< K above ambient at which the line between them reaches zero

int32_t whole(double value) {
    return int32_t(std::clamp(std::floor(value), 0.0, 1e9));
}

bool burns(const Material& material) {
    return material.ignitionTemperature > 0.0f && material.hardness != Hardness::Unbreakable &&
           material.hardness != Hardness::Unphysical;
}

}  // namespace

HeatTable makeHeatTable(const Palette& palette, const MaterialTable& materials, double voxelSize, double burnTime) {
    HeatTable table{};
    const double face = voxelSize * voxelSize;
    for (size_t i = 1; i < 256; ++i) {
        const Material& material = materials[palette[i].material];
        EntryHeat& entry = table[i];
        entry.capacity = std::max(1, whole(double(material.heatCapacity) * material.density * face * kSkin * 1000.0));
        if (!burns(material)) continue;
        entry.ignition = std::max(1, whole(double(material.ignitionTemperature)) - kAmbientKelvin);
        entry.burnRate = std::max(
            1, whole(kWholeVoxel / std::max(0.1, double(material.burnTime) * burnTime * kHeatUpdatesPerSecond)));
        entry.power = whole(kFlux * face * 1000.0 / kHeatUpdatesPerSecond);
    }
    return table;
}

HeatSkin heatSkin(const VoxelGrid& grid, glm::ivec3 position, const HeatTable& table) {
    HeatSkin skin;
    const Brick* brick = grid.brickAt(position);
    if (!brick) return skin;
    int front = 0;
    forEachVoxel(exposedBits(grid, position, *brick).all(), [&](int i) {
        const EntryHeat& entry = table[brick->at(i)];
        skin.capacity += entry.capacity;
        if (!entry.ignition) return;
        skin.ignition = skin.ignition ? std::min(skin.ignition, entry.ignition) : entry.ignition;
        skin.burnRate += entry.burnRate;
        skin.power += entry.power;
        setVoxel(skin.burnable, i);
        ++front;
    });
    if (front > 0 && front < kMinFrontVoxels) skin.burnRate = skin.burnRate * kMinFrontVoxels / front;
    return skin;
}

HeatOutcome updateHeat(HotBrick& brick, const HeatSkin& skin) {
    HeatOutcome out;
    if (brick.wet > 0) {
        brick.heat = 0;
        out.isOver = --brick.wet == 0;
        return out;
    }
    if (!brick.burningFor) {
        brick.heat -= brick.heat >> kCoolingShift;
        out.wantsToBurn = skin.ignition > 0 && brick.heat >= skin.capacity * skin.ignition;
        out.isOver = !out.wantsToBurn && brick.heat < skin.capacity * kNegligibleKelvin;
        return out;
    }
    if (!skin.ignition) {
        extinguish(brick, 0);
        out.wentOut = true;
        return out;
    }
    brick.burningFor = uint16_t(std::min(65535, brick.burningFor + 1));
    out.emitted = skin.power * std::min<int>(brick.burningFor, kGrowthUpdates) / kGrowthUpdates;
    out.chars = brick.charred < kCharRounds && brick.burningFor % kCharEvery == 0;
    brick.charred = uint8_t(brick.charred + out.chars);
    if (brick.charred < kCharRounds / 2) return out;  // voxels turn black before they burn away
    const int64_t burned = brick.burned + skin.burnRate;
    out.consumed = int(std::min<int64_t>(kBrickVoxels, burned / kWholeVoxel));
    brick.burned = uint32_t(burned % kWholeVoxel);
    return out;
}

void ignite(HotBrick& brick) {
    brick.burningFor = std::max<uint16_t>(brick.burningFor, 1);
}

void extinguish(HotBrick& brick, uint32_t wetUpdates) {
    brick.burningFor = 0;
    brick.heat /= 2;
    brick.wet = uint16_t(std::clamp<uint32_t>(wetUpdates, brick.wet, 65535));
}

BrickBits charredCells(const HeatSkin& skin, glm::ivec3 brick, int round) {
    BrickBits out{};
    forEachVoxel(skin.burnable, [&](int i) {
        const glm::ivec3 cell = brick * kBrickSize + voxelInBrick(i);
        const bool isHit = int(hashCell(cell.x, cell.y, cell.z, uint32_t(round)) & 255) < kCharShare;
        if (isHit) setVoxel(out, i);
    });
    return out;
}

BrickBits consumedCells(const VoxelGrid& grid, glm::ivec3 brick, const HeatSkin& skin, int count) {
    std::vector<std::pair<uint32_t, int>> order;
    order.reserve(size_t(kBrickVoxels));
    forEachVoxel(skin.burnable, [&](int i) {
        const glm::ivec3 cell = brick * kBrickSize + voxelInBrick(i);
        uint32_t covered = 0;
        for (const glm::ivec3 step : kFaceOffsets) covered += grid.at(cell + step) != 0;
        order.emplace_back(covered * kFaceWeight + (hashCell(cell.x, cell.y, cell.z) & kOrderNoise), i);
    });
    const size_t taken = std::min(order.size(), size_t(count));
    std::partial_sort(order.begin(), order.begin() + ptrdiff_t(taken), order.end());
    BrickBits out{};
    for (size_t n = 0; n < taken; ++n) setVoxel(out, order[n].second);
    return out;
}

void spreadHeat(const VoxelGrid& grid, glm::ivec3 brick, int64_t emitted, std::vector<HeatDeposit>& out) {
    const auto give = [&](glm::ivec3 to, int64_t share) {
        if (!grid.brickAt(to)) return false;
        out.push_back({to, emitted * share / 256});
        return true;
    };
    bool isGiven = false;  // to the first brick above
    for (int up = 1; up <= kMaxFlameBricks && !isGiven; ++up)
        isGiven = give(brick + glm::ivec3(0, up, 0), kShareUp / up);
    give(brick - glm::ivec3(0, 1, 0), kShareDown);
    for (const glm::ivec3 aside :
         {glm::ivec3(-1, 0, 0), glm::ivec3(1, 0, 0), glm::ivec3(0, 0, -1), glm::ivec3(0, 0, 1)}) {
        give(brick + aside, kShareAside);
        give(brick + aside + glm::ivec3(0, 1, 0), kShareUpAside);
    }
}

int remainingStrength(const HotBrick& brick, const HeatSkin& skin) {
    int left = 256 - brick.charred * kCharLoss / kCharRounds;
    if (skin.capacity > 0 && skin.ignition == 0) {
        const int hot = int(std::min<int64_t>(brick.heat / skin.capacity, kSteelIsSoft));
        if (hot > kSteelWeakens) left = left * (kSteelFails - hot) / (kSteelFails - kSteelWeakens);
    }
    return left;
}

}  // namespace rubble
