#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

using Cell = std::array<int32_t, 3>;

constexpr int64_t kMaxCells = 1 << 24;  ///< that one call writes

Cell cellAt(lua_State* L, int index) {
    Cell cell;
    for (int i = 0; i < 3; ++i) {
        const double place = clampedAt(L, index + i, nullptr, -4096.0, 4096.0);
        cell[size_t(i)] = int32_t(std::floor(place));
    }
    return cell;
}

/// The copy of a shape's grid that this step draws in; null: the shape is gone.
GridCopy* gridOf(lua_State* L, rubble_shape shape) {
    std::map<rubble_shape, GridCopy>& grids = ScriptContext::of(L).shared.grids;
    if (ScriptContext::of(L).shared.reframed.count(shape))
        luaL_error(L,
                   "%s: expected a shape whose cells are known, found one that TrimShape() or MergeShape() moves in "
                   "the next step: wait(0) first",
                   runningFunction(L).name().c_str());
    if (const auto found = grids.find(shape); found != grids.end()) return &found->second;
    rubble_shape_state state = {};
    if (!isDone(L, apiOf(L).get_shape_state(worldOf(L), shape, &state))) return nullptr;
    auto box = sized<rubble_voxel_box>();
    box.shape = shape;
    std::copy_n(state.size, 3, box.size);
    const int64_t cells = int64_t(box.size[0]) * box.size[1] * box.size[2];
    Sandbox::of(L).charge(L, cells / 16);
    if (cells > kMaxCells)
        luaL_error(L, "%s: expected a grid of at most %d cells", runningFunction(L).name().c_str(), int(kMaxCells));
    GridCopy grid{{box.size[0], box.size[1], box.size[2]}, std::vector<uint8_t>(size_t(cells))};
    uint64_t count = 0;
    if (!isDone(L, apiOf(L).read_voxels(worldOf(L), &box, grid.voxels.data(), grid.voxels.size(), &count)))
        return nullptr;
    return &(grids[shape] = std::move(grid));
}

/// What an edit of so many cells costs the step: see chargeStep().
int64_t stepWorkOf(int64_t cells) {
    return 30 + cells / 20;
}

/// Writes one cell in the next step.
void writeCell(lua_State* L, rubble_shape shape, const Cell& cell, uint8_t voxel) {
    auto box = sized<rubble_voxel_box>();
    box.shape = shape;
    std::copy(cell.begin(), cell.end(), box.low);
    std::fill_n(box.size, 3, 1);
    isDone(L, apiOf(L).write_voxels(worldOf(L), &box, &voxel, 1));
}

/// Changes the cells of a box by `edit(cell, voxel)`, which says whether it names the cell: others stay as the edits
/// before have left them, which the copy of the grid does not know. Cells outside of the grid are left out.
template <class Edit>
void editBox(lua_State* L, rubble_shape shape, const Cell& low, const Cell& high, Edit&& edit) {
    GridCopy* grid = gridOf(L, shape);
    if (!grid) return;
    auto box = sized<rubble_voxel_box>();
    box.shape = shape;
    size_t cells = 1;
    for (size_t i = 0; i < 3; ++i) {
        box.low[i] = std::max(low[i], 0);
        box.size[i] = std::min(high[i], grid->size[i] - 1) - box.low[i] + 1;
        if (box.size[i] <= 0) return;
        cells *= size_t(box.size[i]);
    }
    Sandbox::of(L).charge(L, int64_t(cells / 8));
    chargeStep(L, stepWorkOf(int64_t(cells)));
    std::vector<uint8_t> voxels, mask;
    voxels.reserve(cells), mask.reserve(cells);
    for (int32_t z = box.low[2]; z < box.low[2] + box.size[2]; ++z)
        for (int32_t y = box.low[1]; y < box.low[1] + box.size[1]; ++y)
            for (int32_t x = box.low[0]; x < box.low[0] + box.size[0]; ++x) {
                uint8_t& voxel = grid->voxels[grid->at(x, y, z)];
                mask.push_back(edit(Cell{x, y, z}, voxel));
                voxels.push_back(voxel);
            }
    box.mask = mask.data();
    isDone(L, apiOf(L).write_voxels(worldOf(L), &box, voxels.data(), voxels.size()));
    if (const auto cell = std::exchange(grid->placeholder, {}))
        writeCell(L, shape, *cell, grid->voxels[grid->at((*cell)[0], (*cell)[1], (*cell)[2])]);
}

/// Gives all cells of a box one entry of the palette.
void fillBox(lua_State* L, rubble_shape shape, const Cell& low, const Cell& high, uint8_t entry) {
    editBox(L, shape, low, high, [&](const Cell&, uint8_t& voxel) {
        voxel = entry;
        return true;
    });
}

/// Gives the copy of a grid another box of cells.
void resizeCopy(GridCopy& grid, const Cell& low, const Cell& size) {
    GridCopy resized{size, std::vector<uint8_t>(size_t(size[0]) * size_t(size[1]) * size_t(size[2]))};
    for (int32_t z = std::max(low[2], 0); z < std::min(low[2] + size[2], grid.size[2]); ++z)
        for (int32_t y = std::max(low[1], 0); y < std::min(low[1] + size[1], grid.size[1]); ++y)
            for (int32_t x = std::max(low[0], 0); x < std::min(low[0] + size[0], grid.size[0]); ++x)
                resized.voxels[resized.at(x - low[0], y - low[1], z - low[2])] = grid.voxels[grid.at(x, y, z)];
    grid = std::move(resized);
}

/// Whether a box of cells has no voxel.
bool isEmptyIn(const GridCopy& grid, const Cell& low, const Cell& size) {
    for (int32_t z = std::max(low[2], 0); z < std::min(low[2] + size[2], grid.size[2]); ++z)
        for (int32_t y = std::max(low[1], 0); y < std::min(low[1] + size[1], grid.size[1]); ++y)
            for (int32_t x = std::max(low[0], 0); x < std::min(low[0] + size[0], grid.size[0]); ++x)
                if (grid.voxels[grid.at(x, y, z)]) return false;
    return true;
}

/// A cell of a grid within a box; nothing: the box does not meet the grid.
std::optional<Cell> cellWithin(const GridCopy& grid, const Cell& low, const Cell& size) {
    Cell cell;
    for (size_t i = 0; i < 3; ++i) {
        cell[i] = std::clamp(low[i], 0, grid.size[i] - 1);
        if (cell[i] < low[i] || cell[i] >= low[i] + size[i]) return std::nullopt;
    }
    return cell;
}

/// Resizes a shape, and the copy of its grid. One of which no voxel stays gets a placeholder, for what is drawn next.
bool resizeShape(lua_State* L, rubble_shape shape, const Cell& low, const Cell& size) {
    auto edit = sized<rubble_resize>();
    edit.shape = shape;
    std::copy(low.begin(), low.end(), edit.low);
    std::copy(size.begin(), size.end(), edit.size);
    const int64_t cells = int64_t(size[0]) * size[1] * size[2];
    Sandbox::of(L).charge(L, cells / 16);
    if (cells > kMaxCells)
        luaL_error(L, "%s: expected at most %d cells", runningFunction(L).name().c_str(), int(kMaxCells));
    GridCopy* grid = gridOf(L, shape);
    if (!grid) return false;
    const std::optional<Cell> kept = cellWithin(*grid, low, size);
    if (!kept && isEmptyIn(*grid, {0, 0, 0}, grid->size))
        luaL_error(L, "%s: expected a box that meets the grid of an empty shape", runningFunction(L).name().c_str());
    chargeStep(L, stepWorkOf(cells));
    const bool isEmpty = kept && isEmptyIn(*grid, low, size);
    if (isEmpty) writeCell(L, shape, *kept, 1);
    if (grid->placeholder && (!isEmpty || *grid->placeholder != *kept)) writeCell(L, shape, *grid->placeholder, 0);
    if (!isDone(L, apiOf(L).resize_shape(worldOf(L), &edit))) return false;
    resizeCopy(*grid, low, size);
    grid->placeholder.reset();
    if (isEmpty) grid->placeholder = Cell{(*kept)[0] - low[0], (*kept)[1] - low[1], (*kept)[2] - low[2]};
    return true;
}

int create(lua_State* L) {
    auto settings = sized<rubble_shape_settings>();
    settings.body = handleAt(L, 1, "body");
    const Placement placement = poseAt(L, 2, "transform");
    copy(settings.position, placement.position);
    copy(settings.rotation, placement.rotation);
    settings.source = RUBBLE_SHAPE_EMPTY;
    std::fill_n(settings.size, 3, 8);
    if (!lua_isnoneornil(L, 3)) {
        settings.palette_of = handleAt(L, 3, "refShape");
        rubble_shape_state state = {};
        if (settings.palette_of && isDone(L, apiOf(L).get_shape_state(worldOf(L), settings.palette_of, &state)))
            settings.voxel_size = state.voxel_size;
    }
    rubble_shape made = 0;
    ScriptContext& context = ScriptContext::of(L);
    if (isDone(L, apiOf(L).create_shape(worldOf(L), &settings, &made))) {
        context.shared.pending.created[made] = RUBBLE_KIND_SHAPE;
        context.shared.grids[made] = {{8, 8, 8}, std::vector<uint8_t>(512)};
    }
    pushHandle(L, made);
    return 1;
}

int clear(lua_State* L) {
    fillBox(L, handleAt(L, 1, "shape"), {0, 0, 0}, {4095, 4095, 4095}, 0);
    return 0;
}

int resize(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    const Cell low = cellAt(L, 2), high = cellAt(L, 5);
    Cell size;
    for (size_t i = 0; i < 3; ++i) {
        if (high[i] < low[i]) refuseArgument(L, 5 + int(i), nullptr, "no less than the other corner");
        size[i] = high[i] - low[i] + 1;
    }
    resizeShape(L, shape, low, size);
    return 0;
}

int trim(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    if (isDone(L, apiOf(L).trim_shape(worldOf(L), shape))) ScriptContext::of(L).shared.reframed.insert(shape);
    return 0;
}

/// After the step: what came off the shape.
int giveSplit(lua_State* L, int, lua_KContext shape) {
    auto events = sized<rubble_events>();
    std::vector<uint64_t> pieces;
    if (isDone(L, apiOf(L).get_events(worldOf(L), &events)))
        for (uint32_t i = 0; i < events.split_count; ++i)
            if (events.splits[i].parent == rubble_shape(shape)) pieces.push_back(events.splits[i].piece);
    return endCall(L, pushHandles(L, pieces.data(), pieces.size()));
}

int split(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    if (!isDone(L, apiOf(L).split_shape(worldOf(L), shape))) {
        lua_newtable(L);
        return 1;
    }
    return waitForStep(L, lua_KContext(shape), giveSplit);
}

int merge(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape"), into = lua_isnoneornil(L, 2) ? 0 : handleAt(L, 2, "into");
    if (isDone(L, apiOf(L).merge_shape(worldOf(L), shape, into)))
        ScriptContext::of(L).shared.reframed.insert({shape, into});
    return 0;
}

int copyContent(lua_State* L) {
    const rubble_shape from = handleAt(L, 1, "src"), to = handleAt(L, 2, "dst");
    const GridCopy *source = gridOf(L, from), *target = gridOf(L, to);
    if (!source || !target) return 0;
    const GridCopy content = *source;
    Sandbox::of(L).require(L, int64_t(content.voxels.size()) / 4 + 1000);  // no stop between the two edits
    requireStep(L, 2 * stepWorkOf(int64_t(content.voxels.size())));
    if (!resizeShape(L, to, {0, 0, 0}, content.size)) return 0;
    editBox(L, to, {0, 0, 0}, content.size, [&](const Cell& cell, uint8_t& voxel) {
        voxel = content.voxels[content.at(cell[0], cell[1], cell[2])];
        return true;
    });
    return 0;
}

int copyPalette(lua_State* L) {
    auto range = sized<rubble_palette_range>();
    range.shape = handleAt(L, 1, "src");
    const rubble_shape to = handleAt(L, 2, "dst");
    range.first = 1;
    range.count = 255;
    range.entry_size = sizeof(rubble_palette_entry);
    std::vector<rubble_palette_entry> entries(255);
    if (!isDone(L, apiOf(L).get_palette(worldOf(L), &range, entries.data()))) return 0;
    range.shape = to;
    isDone(L, apiOf(L).set_palette(worldOf(L), &range, entries.data()));
    return 0;
}

int setBrush(lua_State* L) {
    const std::string kind = textAt(L, 1, "type");
    const double size = numberOr(L, 2, "size", 1.0), entry = numberOr(L, 3, "entry", 1.0);
    if (kind != "sphere" && kind != "cube" && kind != "noise")
        refuseArgument(L, 1, "type", "\"sphere\", \"cube\" or \"noise\"");
    if (!(size >= 0.0 && size <= 64.0)) refuseArgument(L, 2, "size", "0 to 64 cells");
    if (!(entry >= 0.0 && entry <= 255.0)) refuseArgument(L, 3, "entry", "0 to 255");
    ScriptContext::of(L).brush = {kind == "cube", kind == "noise", size, uint8_t(entry)};
    return 0;
}

/// The brush along a line of cells: each cell that is near enough to it.
int drawLine(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    const Cell from = cellAt(L, 2), to = cellAt(L, 5);
    const bool keeps = boolOr(L, 9, false);
    const Brush brush = ScriptContext::of(L).brush;
    const Vector start{double(from[0]), double(from[1]), double(from[2])};
    const Vector way = Vector{double(to[0]), double(to[1]), double(to[2])} - start;
    const double squared = std::max(dot(way, way), 1e-9), radius = std::max(brush.size * 0.5, 0.5);
    const int32_t reach = int32_t(std::ceil(radius));
    Cell low, high;
    for (int i = 0; i < 3; ++i) {
        low[i] = std::min(from[i], to[i]) - reach;
        high[i] = std::max(from[i], to[i]) + reach;
    }
    editBox(L, shape, low, high, [&](const Cell& cell, uint8_t& voxel) {
        const Vector here = Vector{double(cell[0]), double(cell[1]), double(cell[2])} - start;
        const Vector off = here - way * std::clamp(dot(here, way) / squared, 0.0, 1.0);
        const double distance =
            brush.isCube ? std::max({std::abs(off[0]), std::abs(off[1]), std::abs(off[2])}) : length(off);
        const bool isHit =
            !brush.isNoise || (uint32_t(cell[0] * 73856093 ^ cell[1] * 19349663 ^ cell[2] * 83492791) >> 7 & 1);
        const bool isNamed = distance <= radius && isHit && !(keeps && voxel);
        if (isNamed) voxel = brush.entry;
        return isNamed;
    });
    return 0;
}

int drawBox(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    const Cell from = cellAt(L, 2), to = cellAt(L, 5);
    const uint8_t entry = ScriptContext::of(L).brush.entry;
    Cell low, high;
    for (int i = 0; i < 3; ++i) {
        low[i] = std::min(from[i], to[i]);
        high[i] = std::max(from[i], to[i]);
    }
    fillBox(L, shape, low, high, entry);
    return 0;
}

/// Grows or digs a row of cells from a cell on, along a direction.
int extrude(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    const Cell from = cellAt(L, 2), along = cellAt(L, 5);
    const int32_t steps = int32_t(std::clamp(finiteOr(L, 8, "steps", 1.0), 1.0, 4096.0));
    const uint8_t entry = ScriptContext::of(L).brush.entry;
    Cell low, high;
    int axes = 0;
    for (int i = 0; i < 3; ++i) {
        if (along[i] < -1 || along[i] > 1) refuseArgument(L, 5 + i, nullptr, "-1, 0 or 1");
        axes += along[i] != 0;
        const int32_t end = from[i] + along[i] * steps;
        low[i] = std::min(from[i] + along[i], end);
        high[i] = std::max(from[i] + along[i], end);
    }
    if (axes != 1) refuseArgument(L, 5, nullptr, "one axis, such as 0, 1, 0");
    fillBox(L, shape, low, high, entry);
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"CreateShape(body, transform, refShape) -> shape",
     "A shape of 8 x 8 x 8 empty cells on a body, with the palette of another one. It must get voxels before the step: "
     "DrawShapeBox() on it.",
     create, 200},
    {"ClearShape(shape)", "Removes all its voxels.", clear},
    {"ResizeShape(shape, xmin, ymin, zmin, xmax, ymax, zmax)", "Gives its grid other corners, in present cells.",
     resize},
    {"TrimShape(shape)", "Shrinks its grid to its voxels.", trim, 5000},
    {"SplitShape(shape, removeResidual) -> list",
     "Makes shapes of its parts that do not touch. Waits for the step that does it.", split, 5000},
    {"MergeShape(shape, into)", "Adds it to a shape of the same body that it touches.", merge, 5000},
    {"CopyShapeContent(src, dst)", "Gives a shape the size and the voxels of another.", copyContent},
    {"CopyShapePalette(src, dst)", "Gives a shape the palette of another.", copyPalette, 3000},
    {"SetBrush(type, size, entry)",
     "\"sphere\", \"cube\" or \"noise\", its size in cells, and the entry of the palette that it draws; 0 removes.",
     setBrush},
    {"DrawShapeLine(shape, x0, y0, z0, x1, y1, z1, paint, noOverwrite)", "Draws a line of cells with the brush.",
     drawLine},
    {"DrawShapeBox(shape, x0, y0, z0, x1, y1, z1)", "Fills a box of cells with the brush's entry.", drawBox},
    {"ExtrudeShape(shape, x, y, z, dx, dy, dz, steps)", "Draws a row of cells beside a cell, along an axis.", extrude},
};

}  // namespace

std::span<const ScriptFunction> shapeEditFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
