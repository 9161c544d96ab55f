#include "samples/sandbox/shell/drops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "runtime/script/binding/script_context.h"
#include "runtime/script/sandbox/script_name.h"

namespace sandbox {
namespace {

namespace fs = std::filesystem;
using rubble::script::hasEnding;
using rubble::script::sized;

constexpr size_t kMaxScript = 256 << 10;        ///< bytes
constexpr uint32_t kMaxGrids = 200;             ///< of a drop
constexpr int kMaxSide = 256;                   ///< cells of a grid
constexpr size_t kMaxCells = size_t(32) << 20;  ///< of all grids

fs::path pathOf(const std::string& utf8) {
    return fs::path(std::u8string(utf8.begin(), utf8.end()));
}

std::string utf8Of(const fs::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

/// An entry of the palette of all grids that looks the same; 0: there is no room for it.
uint8_t entryFor(std::vector<rubble_palette_entry>& palette, const rubble_palette_entry& wanted) {
    const auto looks = [](const rubble_palette_entry& e) {
        return std::array{double(e.color[0]), double(e.color[1]), double(e.color[2]), double(e.opacity), e.emission};
    };
    for (size_t i = 0; i < palette.size(); ++i)
        if (looks(palette[i]) == looks(wanted)) return uint8_t(i + 1);
    if (palette.size() == 255) return 255;
    palette.push_back(wanted);
    return uint8_t(palette.size());
}

}  // namespace

void Drops::add(const std::string& path) {
    Drop drop;
    drop.path = path;
    const fs::path file = pathOf(path);
    const std::string whole = utf8Of(file.filename());
    drop.name = utf8Of(file.stem());
    std::error_code ignored;
    const bool isScript = hasEnding(path, ".lua");
    const bool isModel = hasEnding(path, ".vox") || hasEnding(path, ".vdb") || hasEnding(path, ".rubble");
    if (!fs::is_regular_file(file, ignored))
        drop.error =
            fmt::format("{}: expected a file, found {}", whole, fs::exists(file, ignored) ? "another thing" : "none");
    else if (!isScript && !isModel)
        drop.error = fmt::format("{}: expected a .vox, .vdb, .rubble or .lua file", whole);
    else
        drop.error = isScript ? readScript(drop) : readModel(drop);
    if (const size_t at = drop.error.find(path); at != drop.error.npos)  // folder and function are no news
        drop.error = whole + drop.error.substr(at + path.size());
    if (!drop.error.empty()) drop.grids = {};
    m_all.push_back(std::move(drop));
}

std::string Drops::readScript(Drop& drop) const {
    std::ifstream file(pathOf(drop.path), std::ios::binary);
    drop.script.resize(kMaxScript + 1);
    file.read(drop.script.data(), std::streamsize(drop.script.size()));
    drop.script.resize(size_t(file.gcount()));
    if (drop.script.empty()) return drop.path + ": expected a text that can be read, found nothing";
    if (drop.script.size() <= kMaxScript) return m_test(utf8Of(pathOf(drop.path).filename()), drop.script);
    return fmt::format("{}: expected a prefab of at most {} KiB, found more", drop.path, kMaxScript >> 10);
}

/// Into a world of its own.
std::string Drops::readModel(Drop& drop) const {
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.physics_threads = 1;
    rubble_world scratch = 0;
    if (m_api.create_world(&settings, &scratch) != RUBBLE_OK) return m_api.get_last_error();
    const bool isLoaded = m_api.load_level(scratch, drop.path.c_str(), m_vdbTool.c_str()) == RUBBLE_OK;
    const std::string what = isLoaded ? readGrids(drop, scratch) : m_api.get_last_error();
    m_api.destroy_world(scratch);
    drop.isFree = hasEnding(drop.path, ".vox");
    return what;
}

std::string Drops::readGrids(Drop& drop, rubble_world scratch) const {
    uint32_t count = 0;
    m_api.get_shape_states(scratch, 0, nullptr, 0, &count);
    if (count == 0) return drop.path + ": expected voxels, found none";
    if (count > kMaxGrids)
        return fmt::format("{}: expected a model of at most {} shapes, found {}", drop.path, kMaxGrids, count);
    std::vector<rubble_shape_state> states(count);
    if (m_api.get_shape_states(scratch, 0, states.data(), count, &count) != RUBBLE_OK) return m_api.get_last_error();
    size_t cells = 0;
    for (const rubble_shape_state& state : states) {
        if (std::max({state.size[0], state.size[1], state.size[2]}) > kMaxSide)
            return fmt::format("{}: expected shapes of at most {} cells a side, found {} x {} x {}", drop.path,
                               kMaxSide, state.size[0], state.size[1], state.size[2]);
        cells += size_t(state.size[0]) * size_t(state.size[1]) * size_t(state.size[2]);
    }
    if (cells > kMaxCells)
        return fmt::format("{}: expected a model of at most {} million cells, found {}", drop.path, kMaxCells >> 20,
                           cells >> 20);
    for (const rubble_shape_state& state : states)
        if (std::string what = readGrid(drop, scratch, state); !what.empty()) return what;
    return "";
}

std::string Drops::readGrid(Drop& drop, rubble_world scratch, const rubble_shape_state& state) const {
    DropGrid grid;
    std::copy_n(state.position, 3, grid.position.begin());
    std::copy_n(state.rotation, 4, grid.rotation.begin());
    std::copy_n(state.size, 3, grid.size.begin());
    grid.voxel = state.voxel_size;
    auto box = sized<rubble_voxel_box>();
    box.shape = state.shape;
    std::copy_n(state.size, 3, box.size);
    uint64_t count = uint64_t(state.size[0]) * uint64_t(state.size[1]) * uint64_t(state.size[2]);
    grid.cells.resize(count);
    auto range = sized<rubble_palette_range>();
    range.shape = state.shape;
    range.first = 1, range.count = 255, range.entry_size = sizeof(rubble_palette_entry);
    std::vector<rubble_palette_entry> palette(255);
    if (m_api.read_voxels(scratch, &box, grid.cells.data(), count, &count) != RUBBLE_OK ||
        m_api.get_palette(scratch, &range, palette.data()) != RUBBLE_OK)
        return m_api.get_last_error();
    std::array<uint8_t, 256> entries = {};
    for (uint8_t& cell : grid.cells) {
        if (cell == 0) continue;
        if (!entries[cell]) entries[cell] = entryFor(drop.palette, palette[size_t(cell) - 1]);
        cell = entries[cell];
    }
    drop.grids.push_back(std::move(grid));
    return "";
}

DropGrid coarser(const DropGrid& grid, int times) {
    DropGrid made = grid;
    for (int& side : made.size) side = (side + times - 1) / times;
    made.voxel *= times;
    made.cells.assign(size_t(made.size[0]) * size_t(made.size[1]) * size_t(made.size[2]), 0);
    const uint8_t* cell = grid.cells.data();
    for (int z = 0; z < grid.size[2]; ++z)
        for (int y = 0; y < grid.size[1]; ++y)
            for (int x = 0; x < grid.size[0]; ++x, ++cell) {
                const size_t row = size_t(z / times) * size_t(made.size[1]) + size_t(y / times);
                uint8_t& to = made.cells[row * size_t(made.size[0]) + size_t(x / times)];
                if (to == 0) to = *cell;
            }
    return made;
}

}  // namespace sandbox
