#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/core/constants.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

inline constexpr int kHeatInterval = 6;                                        ///< steps between two updates of a brick
inline constexpr int kHeatUpdatesPerSecond = kStepsPerSecond / kHeatInterval;  ///< of a brick
inline constexpr int kAmbientKelvin = 293;                                     ///< temperature of the surroundings
inline constexpr int kCharRounds = 16;                 ///< rounds of charring from unburnt to black
inline constexpr int kWholeVoxel = 65536;              ///< HotBrick::burned of a voxel that is gone
inline constexpr int64_t kMaxHeat = int64_t(1) << 56;  ///< mJ of a brick

/// A brick that is hot, burning or wet. Plain data: it may be copied, compared and saved.
struct HotBrick {
    glm::ivec3 brick{0};
    int64_t heat = 0;         ///< mJ above ambient, in the skin of its exposed voxels: 0 to kMaxHeat
    uint32_t burned = 0;      ///< how much of the next voxel has burned, in 1/65536
    uint16_t burningFor = 0;  ///< updates since it was ignited, at most 65535; 0: it does not burn
    uint16_t wet = 0;         ///< updates during which nothing can ignite it
    uint8_t charred = 0;      ///< rounds of charring done, at most kCharRounds

    friend bool operator==(const HotBrick&, const HotBrick&) = default;
};

/// The thermal properties of one voxel of a palette entry, in integers.
struct EntryHeat {
    int32_t capacity = 0;  ///< mJ/K of an exposed voxel
    int32_t ignition = 0;  ///< K above ambient; 0: does not burn
    int32_t burnRate = 0;  ///< 1/65536 voxel per update
    int32_t power = 0;     ///< mJ per update while it burns
};
using HeatTable = std::array<EntryHeat, 256>;

/// The table of a palette. voxelSize: metres. burnTime: multiplies the materials' burn times.
HeatTable makeHeatTable(const Palette& palette, const MaterialTable& materials, double voxelSize, double burnTime);

/// The thermal properties of a brick's exposed voxels together.
struct HeatSkin {
    int64_t capacity = 0;  ///< mJ/K
    int32_t ignition = 0;  ///< K above ambient: the lowest of its voxels; 0: none burns
    int64_t burnRate = 0;  ///< 1/65536 voxel per update
    int64_t power = 0;     ///< mJ per update while it burns
    BrickBits burnable{};  ///< exposed voxels that burn
};
/// Sums over the exposed voxels of a brick; zero if the brick is empty.
HeatSkin heatSkin(const VoxelGrid& grid, glm::ivec3 brick, const HeatTable& table);

/// What one update of a brick asks its caller to do.
struct HeatOutcome {
    bool wantsToBurn = false;  ///< it is hot enough: call ignite(), unless there are too many fires
    bool wentOut = false;      ///< it stopped burning
    bool chars = false;        ///< one more round of charring: see charredCells()
    int consumed = 0;          ///< voxels that burn away: see consumedCells()
    int64_t emitted = 0;       ///< mJ for its surroundings: see spreadHeat()
    bool isOver = false;       ///< neither hot nor burning nor wet any more: forget it
};
/// One update, every kHeatInterval steps: cooling, ignition or burning. Changes the brick's state.
HeatOutcome updateHeat(HotBrick& brick, const HeatSkin& skin);
/// Sets it on fire.
void ignite(HotBrick& brick);
/// Stops its burning, halves its heat, and keeps it from burning for `wetUpdates` updates.
void extinguish(HotBrick& brick, uint32_t wetUpdates);

/// The exposed voxels that get darker in a round: about five of eight, other ones in each round.
BrickBits charredCells(const HeatSkin& skin, glm::ivec3 brick, int round);
/// `count` of the burnable voxels, roughly those with the most exposed faces first, so that holes grow from their rims.
BrickBits consumedCells(const VoxelGrid& grid, glm::ivec3 brick, const HeatSkin& skin, int count);

/// Heat for a brick.
struct HeatDeposit {
    glm::ivec3 brick;
    int64_t heat;  ///< mJ
};
/// Appends how a brick's emitted heat (mJ) is shared among the bricks of its grid: mostly to those above, also across a
/// gap; least to those below.
void spreadHeat(const VoxelGrid& grid, glm::ivec3 brick, int64_t emitted, std::vector<HeatDeposit>& out);

/// The strength that a brick has left, in 1/256: char weakens wood, heat weakens steel.
int remainingStrength(const HotBrick& brick, const HeatSkin& skin);

}  // namespace rubble
