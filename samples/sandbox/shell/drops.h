#pragma once
#include <rubble/rubble.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

/// A grid of a model that was dropped: what its image is made of.
struct DropGrid {
    std::array<double, 3> position;  ///< of its first corner, in the model's frame
    std::array<double, 4> rotation;  ///< of its axes
    double voxel;                    ///< metres
    std::array<int, 3> size;         ///< cells
    std::vector<uint8_t> cells;      ///< a byte each, x first, then y, then z: a number of the palette, 0: nothing
};

/// A file that was dropped on the window.
struct Drop {
    std::string path, name;                     ///< UTF-8; the name without folder and ending
    std::string error;                          ///< why it cannot be placed; "": it can
    std::string script;                         ///< of a .lua file: its text
    bool isFree = false;                        ///< a model whose format knows nothing of what moves: its bodies shall
    std::vector<rubble_palette_entry> palette;  ///< of all grids, its entries from 1 on
    std::vector<DropGrid> grids;
};

/// The files that were dropped on the window, in their order, until the game ends.
class Drops {
public:
    /// Tries a prefab of a name and a text where it can do no harm; what is wrong, or "".
    using PrefabTest = std::function<std::string(const std::string& name, const std::string& text)>;

    /// `vdbTool`: the program that reads .vdb.
    Drops(const rubble_api& api, std::string vdbTool, PrefabTest test)
        : m_api(api), m_vdbTool(std::move(vdbTool)), m_test(std::move(test)) {}
    /// Reads one: a model or level (.vox, .vdb, .rubble), or a prefab (.lua).
    void add(const std::string& path);
    /// All of them, also those that cannot be read.
    const std::vector<Drop>& all() const { return m_all; }

private:
    std::string readScript(Drop& drop) const;
    std::string readModel(Drop& drop) const;
    std::string readGrids(Drop& drop, rubble_world scratch) const;
    std::string readGrid(Drop& drop, rubble_world scratch, const rubble_shape_state& state) const;

    const rubble_api& m_api;
    std::string m_vdbTool;
    PrefabTest m_test;
    std::vector<Drop> m_all;
};

/// The same grid in cells that are so many times as wide, each of them the first of what lies in it.
DropGrid coarser(const DropGrid& grid, int times);

}  // namespace sandbox
