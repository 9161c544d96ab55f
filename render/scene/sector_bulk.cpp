#include "render/scene/sector_bulk.h"

#include <tuple>

namespace rubble {

glm::ivec3 middleOf(std::span<const SectorBricksCount> sectors) {
    glm::ivec3 middle(0);
    int64_t all = 0;
    for (const SectorBricksCount& each : sectors) all += each.bricks;
    std::vector<std::pair<int, int64_t>> places(sectors.size());
    for (int axis = 0; axis < 3; ++axis) {
        for (size_t i = 0; i < sectors.size(); ++i) places[i] = {sectors[i].sector[axis], sectors[i].bricks};
        std::sort(places.begin(), places.end());
        int64_t below = 0;
        for (const auto& [place, bricks] : places) {
            middle[axis] = place;
            below += bricks;
            if (2 * below >= all) break;
        }
    }
    return middle;
}

double squaredDistance(glm::ivec3 a, glm::ivec3 b) {
    const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
    return x * x + y * y + z * z;
}

void sortByDistance(std::vector<SectorBricksCount>& sectors, glm::ivec3 middle) {
    const auto key = [middle](const SectorBricksCount& s) {
        return std::tuple(squaredDistance(s.sector, middle), s.sector.z, s.sector.y, s.sector.x);
    };
    std::sort(sectors.begin(), sectors.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

SectorBox boxOfNearest(std::span<const SectorBricksCount> sectors, int64_t maxVolume) {
    SectorBox box;
    for (const SectorBricksCount& each : sectors) {
        SectorBox next = box;
        next.include(each.sector);
        if (next.volume() > double(maxVolume)) break;
        box = next;
    }
    return box;
}

SectorBox bulkOf(std::span<const SectorBricksCount> sectors, int64_t bricksPerSector, int64_t smallVolume) {
    int64_t all = 0, bricks = 0;
    for (const SectorBricksCount& each : sectors) all += each.bricks;
    SectorBox box, bulk;
    for (const SectorBricksCount& each : sectors) {
        box.include(each.sector);
        bricks += each.bricks;
        const int64_t room = std::max(smallVolume, bricks / bricksPerSector);
        if (2 * bricks > all && box.volume() <= double(room)) bulk = box;
    }
    return bulk;
}

}  // namespace rubble
