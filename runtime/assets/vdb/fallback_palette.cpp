#include "runtime/assets/vdb/fallback_palette.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>
#include <vector>

#include "runtime/assets/vox_file.h"
#include "runtime/assets/vox_palette.h"

namespace rubble {
namespace {

PaletteEntry entryOf(uint8_t red, uint8_t green, uint8_t blue) {
    PaletteEntry entry;
    entry.red = red;
    entry.green = green;
    entry.blue = blue;
    entry.material = guessMaterial(entry);
    return entry;
}

template <class F>
void forEachCell(const VoxelGrid& grid, F&& f) {
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        forEachVoxel(content->occupancy, [&](int i) { f(brick * kBrickSize + voxelInBrick(i)); });
    });
}

/// A colour, 0xrrggbb, and how many voxels have it.
struct Counted {
    uint32_t color;
    uint64_t voxels;
};

int channel(uint32_t color, int axis) {
    return int(color >> (16 - 8 * axis) & 0xff);
}

/// Some of the colours, and the channel in which they differ most.
struct Group {
    size_t begin, end;
    int axis = 0, low = 0, high = 0;
};

Group groupOf(const std::vector<Counted>& all, size_t begin, size_t end) {
    Group group{begin, end};
    for (int axis = 0; axis < 3; ++axis) {
        int low = 255, high = 0;
        for (size_t i = begin; i < end; ++i) {
            low = std::min(low, channel(all[i].color, axis));
            high = std::max(high, channel(all[i].color, axis));
        }
        if (high - low > group.high - group.low) group.axis = axis, group.low = low, group.high = high;
    }
    return group;
}

/// Parts colours until there are 255 groups: that with the largest difference, in the middle of it.
std::vector<Group> groupColors(std::vector<Counted>& all) {
    std::vector<Group> groups;
    if (!all.empty()) groups.push_back(groupOf(all, 0, all.size()));
    while (!groups.empty() && groups.size() < 255) {
        const auto widest = std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
            return a.high - a.low < b.high - b.low;
        });
        const Group whole = *widest;
        if (whole.high == whole.low) break;
        const auto middle = std::stable_partition(
            all.begin() + ptrdiff_t(whole.begin), all.begin() + ptrdiff_t(whole.end),
            [&](const Counted& each) { return channel(each.color, whole.axis) * 2 < whole.low + whole.high + 1; });
        *widest = groupOf(all, whole.begin, size_t(middle - all.begin()));
        groups.push_back(groupOf(all, size_t(middle - all.begin()), whole.end));
    }
    return groups;
}

/// The mean of colours by their voxels; where one of them were farther from it than `limit`, the nearest colour to it
/// from which none is.
uint32_t meanOf(std::span<const Counted> colors, int limit) {
    uint32_t mean = 0;
    for (int axis = 0; axis < 3; ++axis) {
        uint64_t voxels = 0, sum = 0;
        int low = 255, high = 0;
        for (const Counted& each : colors) {
            const int value = channel(each.color, axis);
            voxels += each.voxels;
            sum += uint64_t(value) * each.voxels;
            low = std::min(low, value), high = std::max(high, value);
        }
        mean = mean << 8 | uint32_t(std::clamp(int((sum + voxels / 2) / voxels), high - limit, low + limit));
    }
    return mean;
}

}  // namespace

PaletteRef grayFallbackPalette() {
    auto palette = std::make_shared<Palette>();
    (*palette)[1] = entryOf(170, 170, 170);
    return palette;
}

PaletteRef voxFallbackPalette(const VoxelGrid& grid) {
    auto palette = std::make_shared<Palette>();
    const auto colors = defaultVoxColors();
    forEachCell(grid, [&](glm::ivec3 cell) {
        const uint8_t index = grid.at(cell);
        if (!(*palette)[index].material)
            (*palette)[index] = entryOf(colors[index][0], colors[index][1], colors[index][2]);
    });
    return palette;
}

uint32_t packSrgb(glm::vec3 linear) {
    return uint32_t(linearToSrgb(linear.r)) << 16 | uint32_t(linearToSrgb(linear.g)) << 8 | linearToSrgb(linear.b);
}

PaletteRef quantiseColors(VoxelGrid& grid, const std::function<uint32_t(glm::ivec3)>& colorAt, ColorCounts* counts) {
    std::map<uint32_t, uint64_t> voxels;
    forEachCell(grid, [&](glm::ivec3 cell) { ++voxels[colorAt(cell)]; });
    std::vector<Counted> all;
    for (const auto& [color, count] : voxels) all.push_back({color, count});
    const std::vector<Group> groups = groupColors(all);
    auto palette = std::make_shared<Palette>();
    std::map<uint32_t, uint8_t> entries;
    int widest = 0, error = 0;
    for (const Group& group : groups) widest = std::max(widest, group.high - group.low);
    for (size_t i = 0; i < groups.size(); ++i) {
        const std::span<const Counted> group(all.begin() + ptrdiff_t(groups[i].begin),
                                             all.begin() + ptrdiff_t(groups[i].end));
        const uint32_t mean = meanOf(group, (widest + 1) / 2);
        (*palette)[i + 1] = entryOf(uint8_t(mean >> 16), uint8_t(mean >> 8), uint8_t(mean));
        for (const Counted& each : group) {
            entries[each.color] = uint8_t(i + 1);
            for (int axis = 0; axis < 3; ++axis)
                error = std::max(error, std::abs(channel(each.color, axis) - channel(mean, axis)));
        }
    }
    if (counts) *counts = {all.size(), groups.size(), error};
    const VoxelGrid source = grid;
    GridWriter writer(grid);
    forEachCell(source, [&](glm::ivec3 cell) { writer.set(cell, entries.at(colorAt(cell))); });
    return palette;
}

}  // namespace rubble
