#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace rubble {

/// A box of sectors of the shadow volume; empty at first.
struct SectorBox {
    glm::ivec3 low{0}, high{0};  ///< high is excluded
    /// Grows to hold a box that is not empty.
    void include(glm::ivec3 first, glm::ivec3 end) {
        const bool isEmpty = low == high;
        low = isEmpty ? first : glm::min(low, first);
        high = isEmpty ? end : glm::max(high, end);
    }
    /// Grows to hold a sector.
    void include(glm::ivec3 sector) { include(sector, sector + 1); }
    /// Its sectors along each axis.
    glm::ivec3 size() const { return high - low; }
    /// Its sectors; boxes across the whole world have more than 64 bits count, so it is a rounded number.
    double volume() const { return double(size().x) * double(size().y) * double(size().z); }
};

/// Bricks in a sector. One sector may come several times, each with some of its bricks.
struct SectorBricksCount {
    glm::ivec3 sector{0};
    int64_t bricks = 1;
};

/// The middle of most bricks: for each axis the median. A few far away do not move it, wherever they are. (0, 0, 0) if
/// there are none.
glm::ivec3 middleOf(std::span<const SectorBricksCount> sectors);

/// Square of the distance between two sectors; in doubles exact for all that are within 1e8 m of the origin.
double squaredDistance(glm::ivec3 a, glm::ivec3 b);

/// Sorts sectors by their distance from a middle, nearest first; equally far ones by their place.
void sortByDistance(std::vector<SectorBricksCount>& sectors, glm::ivec3 middle);

/// The box of as many of the nearest sectors as go into maxVolume. sectors: sorted by sortByDistance().
SectorBox boxOfNearest(std::span<const SectorBricksCount> sectors, int64_t maxVolume);

/// The box of as many of the nearest sectors as possible that hold more than half of all bricks, and at least
/// bricksPerSector for each sector of the box or smallVolume sectors in any case. Empty if there is none.
SectorBox bulkOf(std::span<const SectorBricksCount> sectors, int64_t bricksPerSector, int64_t smallVolume);

}  // namespace rubble
