#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

inline constexpr int kHeatInterval = 6;                           ///< steps between two updates of a brick
inline constexpr int kHeatUpdatesPerSecond = 60 / kHeatInterval;  ///< updates a second
inline constexpr int kAmbientKelvin = 293;                        ///< K
inline constexpr int kCharRounds = 16;                            ///< from unburnt to black
inline constexpr int kWholeVoxel = 65536;                         ///< of HotBrick::burned

/// A brick that is hot, burning or wet. Plain data: may be copied, compared and saved.
struct HotBrick {
    glm::ivec3 brick{0};
    int64_t heat = 0;         ///< mJ above ambient, in the skin of its exposed voxels
    uint32_t burned = 0;      ///< of the next voxel that burns away, in 1/65536
    uint16_t burningFor = 0;  ///< updates since it was lit, up to 65535; 0: does not burn
    uint16_t wet = 0;         ///< updates for which nothing can ignite it
    uint8_t charred = 0;      ///< rounds of charring done, of kCharRounds

    friend bool operator==(const HotBrick&, const HotBrick&) = default;
};

/// What heat does to one voxel of each palette entry. In integers from here on.
struct EntryHeat {
    int32_t capacity = 0;  ///< mJ/K of an exposed voxel
    int32_t ignition = 0;  ///< K above ambient; 0: does not burn
    int32_t burnRate = 0;  ///< 1/65536 voxel an update
    int32_t power = 0;     ///< mJ an update while it burns
};
using HeatTable = std::array<EntryHeat, 256>;

/// voxelSize in metres; burnTime: a multiple of the materials'.
HeatTable makeHeatTable(const Palette& palette, const MaterialTable& materials, double voxelSize, double burnTime);

/// What a brick's exposed voxels are to heat.
struct HeatSkin {
    int64_t capacity = 0;  ///< mJ/K
    int32_t ignition = 0;  ///< K above ambient: that of what burns first; 0: nothing burns
    int64_t burnRate = 0, power = 0;
    BrickBits burnable{};  ///< exposed voxels that burn
};
HeatSkin heatSkin(const VoxelGrid& grid, glm::ivec3 brick, const HeatTable& table);

/// What one update of a brick does besides changing its own state.
struct HeatOutcome {
    bool wantsToBurn = false;  ///< hot enough: the caller lights it if there is room
    bool wentOut = false;
    bool chars = false;   ///< one more round: see charredCells()
    int consumed = 0;     ///< voxels that burn away: see consumedCells()
    int64_t emitted = 0;  ///< mJ that what is near gets
    bool isOver = false;  ///< neither hot nor burning nor wet any more
};
HeatOutcome updateHeat(HotBrick& brick, const HeatSkin& skin);
void ignite(HotBrick& brick);
/// Puts it out, if it burns, and keeps it from burning for some updates.
void extinguish(HotBrick& brick, uint32_t wetUpdates);

/// Exposed voxels that darken in a round: scattered, others in each.
BrickBits charredCells(const HeatSkin& skin, glm::ivec3 brick, int round);
/// `count` of the burnable voxels, those with the most faces in the air first, so that holes grow from their rims.
BrickBits consumedCells(const VoxelGrid& grid, glm::ivec3 brick, const HeatSkin& skin, int count);

struct HeatDeposit {
    glm::ivec3 brick;
    int64_t heat;  ///< mJ
};
/// Who gets what a brick emits, within its own grid: mostly those above, across a gap too, least those below.
void spreadHeat(const VoxelGrid& grid, glm::ivec3 brick, int64_t emitted, std::vector<HeatDeposit>& out);

/// How much of its strength a brick has left, of 256: char weakens wood, heat weakens steel.
int remainingStrength(const HotBrick& brick, const HeatSkin& skin);

}  // namespace rubble
