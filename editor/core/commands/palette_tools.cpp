// What works on whole palettes: sort, merge, reduce. Voxels keep their looks, or get the nearest.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "editor/core/palette.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

const Parameter kShapes{"shape", Type::Objects, "the shapes whose palette it is", "selected"};

using Counts = std::array<uint64_t, 256>;
using Map = std::array<uint8_t, 256>;  ///< for each entry the one that its voxels get

Map identity() {
    Map map;
    std::iota(map.begin(), map.end(), uint8_t(0));
    return map;
}

/// How many voxels have each entry; a layer of the grid at a time.
Counts countEntries(const rubble::World& world, rubble_shape shape) {
    Counts counts{};
    Cells layer = gridOf(world, shape);
    const int layers = layer.size.z;
    for (layer.size.z = 1; layer.low.z < layers; ++layer.low.z)
        for (const uint8_t index : readCells(world, shape, layer)) ++counts[index];
    counts[0] = 0;
    return counts;
}

void remap(Editor& editor, rubble_shape shape, const Map& map) {
    if (map == identity()) return;
    CellWriter(editor.world(), shape).write(gridOf(editor.world(), shape), [&](glm::ivec3, uint8_t before) {
        return map[before];
    });
}

bool areEqual(const rubble_palette_entry& a, const rubble_palette_entry& b) {
    return std::equal(a.color, a.color + 3, b.color) && a.opacity == b.opacity && a.roughness == b.roughness &&
           a.metallic == b.metallic && a.reflectivity == b.reflectivity && a.material == b.material &&
           a.emission == b.emission && a.light_group == b.light_group;
}

/// Squares of differences in colour; more where a voxel would become something else.
int distance(const rubble_palette_entry& a, const rubble_palette_entry& b) {
    int sum = (a.material != b.material) + (a.light_group != b.light_group) + ((a.emission > 0) != (b.emission > 0));
    sum <<= 18;
    for (int i = 0; i < 3; ++i) sum += (a.color[i] - b.color[i]) * (a.color[i] - b.color[i]);
    return sum + (a.opacity - b.opacity) * (a.opacity - b.opacity);
}

void mergeEntries(Editor& editor, const Arguments& arguments) {
    size_t merged = 0;
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) {
        const std::vector<rubble_palette_entry> entries = paletteOf(editor.world(), shape);
        const Counts counts = countEntries(editor.world(), shape);
        Map map = identity();
        for (size_t i = 2; i < 256; ++i)
            for (size_t j = 1; j < i && counts[i]; ++j) {
                if (!counts[j] || map[j] != j || !areEqual(entries[i], entries[j])) continue;
                map[i] = uint8_t(j);
                ++merged;
                break;
            }
        remap(editor, shape, map);
    }
    editor.say(rubble::counted(merged, "entry", "entries") + " merged");
}

/// The rarest entry becomes the nearest other one, until there are few enough.
void reduceEntries(Editor& editor, const Arguments& arguments) {
    const int most = arguments.whole("count");
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) {
        const std::vector<rubble_palette_entry> entries = paletteOf(editor.world(), shape);
        Counts counts = countEntries(editor.world(), shape);
        Map map = identity();
        std::vector<uint8_t> used;
        for (size_t i = 1; i < 256; ++i)
            if (counts[i]) used.push_back(uint8_t(i));
        const size_t before = used.size();
        while (used.size() > size_t(most)) {
            const auto rarest =
                std::min_element(used.begin(), used.end(), [&](uint8_t a, uint8_t b) { return counts[a] < counts[b]; });
            const uint8_t gone = *rarest;
            used.erase(rarest);
            const uint8_t to = *std::min_element(used.begin(), used.end(), [&](uint8_t a, uint8_t b) {
                return distance(entries[a], entries[gone]) < distance(entries[b], entries[gone]);
            });
            counts[to] += counts[gone];
            for (uint8_t& each : map)
                if (each == gone) each = to;
        }
        remap(editor, shape, map);
        editor.say(fmt::format("{} of {} entries are used", used.size(), before));
    }
}

/// What entries are sorted by: used ones first.
double keyOf(const rubble_palette_entry& entry, bool byHue) {
    const double red = entry.color[0], green = entry.color[1], blue = entry.color[2];
    const double value = std::max({red, green, blue}), chroma = value - std::min({red, green, blue});
    const double bright = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    if (!byHue) return bright;
    if (chroma < 1.0) return bright / 256.0 - 1.0;  // greys come first
    const double hue = value == red     ? (green - blue) / chroma
                       : value == green ? 2 + (blue - red) / chroma
                                        : 4 + (red - green) / chroma;
    return (hue < 0 ? hue + 6 : hue) + bright / 1e6;
}

void sortEntries(Editor& editor, const Arguments& arguments) {
    const bool byHue = arguments.text("by") == "hue";
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) {
        const std::vector<rubble_palette_entry> entries = paletteOf(editor.world(), shape);
        const Counts counts = countEntries(editor.world(), shape);
        std::vector<uint8_t> order(255);
        std::iota(order.begin(), order.end(), uint8_t(1));
        std::stable_sort(order.begin(), order.end(), [&](uint8_t a, uint8_t b) {
            if (!counts[a] || !counts[b]) return counts[a] && !counts[b];
            return keyOf(entries[a], byHue) < keyOf(entries[b], byHue);
        });
        Map map{};
        std::vector<rubble_palette_entry> sorted;
        for (size_t i = 0; i < order.size(); ++i) {
            map[order[i]] = uint8_t(i + 1);
            sorted.push_back(entries[order[i]]);
        }
        remap(editor, shape, map);
        editor.world().set_palette(paletteRange(shape, 1, 255), sorted.data());
    }
}

}  // namespace

std::vector<Command> paletteToolCommands() {
    return {
        {"merge_entries",
         "palette",
         Kind::Edit,
         "Gives voxels of equal entries the first of them.",
         {kShapes},
         mergeEntries,
         "merge_entries striped"},
        {"reduce_entries",
         "palette",
         Kind::Edit,
         "Leaves fewer entries in use: the rarest become the nearest other ones.",
         {{"count", Type::Whole, "how many are left at most", kRequired, 1, 254}, kShapes},
         reduceEntries,
         "reduce_entries 1 striped"},
        {"sort_entries",
         "palette",
         Kind::Edit,
         "Sorts the palette, those in use first; voxels keep their looks.",
         {{"by", Type::Choice, "what comes first", "hue", 0, 0, "hue brightness"}, kShapes},
         sortEntries,
         "sort_entries brightness striped"},
    };
}

}  // namespace editor
