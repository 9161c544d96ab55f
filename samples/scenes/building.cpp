#include "samples/scenes/building.h"

#include <algorithm>

#include "runtime/core/random.h"

namespace rubble::scenes {

WallFrames wallFrames(ivec3 low, ivec3 high) {
    const int sx = high.x - low.x, sz = high.z - low.z;
    return {{{low.x, 0, high.z - 1}, {1, 0, 0}, {0, 0, -1}, sx},
            {{high.x - 1, 0, high.z - 1}, {0, 0, -1}, {-1, 0, 0}, sz},
            {{high.x - 1, 0, low.z}, {-1, 0, 0}, {0, 0, 1}, sx},
            {{low.x, 0, low.z}, {0, 0, 1}, {1, 0, 0}, sz}};
}

namespace {

/// Bricks of three cells and a joint, each course shifted by half a brick. Each brick has a colour; some are darker.
uint8_t stoneEntry(const WallSwatches& s, ivec3 cell, int u, int y) {
    if (!s.courses) return PaletteBuilder::pick(s.stone, cell);
    const int shifted = u + (y % 2) * 2 + 400;
    if (shifted % 4 == 0) return PaletteBuilder::pickFor(s.joint, hashCell(u, y, 0, 41));
    const uint32_t brick = hashCell(shifted / 4, y, 0, 42);
    return brick % 11 == 0 ? PaletteBuilder::pickFor(s.dirty, brick >> 8)
                           : PaletteBuilder::pickFor(s.stone, brick >> 8);
}

/// The panels of a door in the middle of a wall, with a knob on both sides.
void drawLeaf(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch leaf, Swatch knob) {
    for (int du = 0; du < kDoorWidth; ++du)
        for (int dy = 0; dy < kDoorHeight; ++dy) {
            const bool panel = du > 1 && du < 7 && dy > 2 && dy < 18 && dy != 10;
            canvas.setEntry(wall.cell(u + du, y + dy, 1), PaletteBuilder::pickFor(leaf, panel ? 1 : 0));
        }
    for (const int k : {0, 2}) canvas.set(wall.cell(u + 7, y + 10, k), knob);
}

}  // namespace

void drawWall(Canvas& canvas, const WallFrame& wall, int low, int high, const WallSwatches& s) {
    for (int u = 0; u < wall.length; ++u)
        for (int y = low; y < high; ++y) {
            const int foot = y - low;
            const bool grime = foot < 6 && hashCell(u / 2, y / 2, wall.length, 43) % 8 >= uint32_t(foot + 1);
            for (int k = 0; k < 2; ++k) {
                const ivec3 cell = wall.cell(u, y, k);
                canvas.setEntry(cell, grime ? PaletteBuilder::pick(s.dirty, cell) : stoneEntry(s, cell, u, y));
            }
            canvas.set(wall.cell(u, y, 2), s.plaster);
            // Behind the plaster: wires up from the floor and a pipe along it.
            if (u % 31 == 9 && foot > 2) canvas.set(wall.cell(u, y, 1), s.wire);
            if (foot == 5) canvas.set(wall.cell(u, y, 1), s.pipe);
        }
}

void drawWindow(Canvas& canvas, const WallFrame& wall, int u, int y, int width, int height, const WindowSwatches& s,
                bool curtains) {
    for (int du = -1; du <= width; ++du) {
        for (int k = 0; k < 2; ++k) canvas.set(wall.cell(u + du, y + height, k), s.sill);
        canvas.set(wall.cell(u + du, y - 1, -1), s.sill);
        canvas.set(wall.cell(u + du, y - 1, 0), s.sill);
        canvas.set(wall.cell(u + du, y - 1, 1), s.sill);
    }
    for (int du = 0; du < width; ++du)
        for (int dy = 0; dy < height; ++dy) {
            canvas.setEntry(wall.cell(u + du, y + dy, 0), 0);
            canvas.setEntry(wall.cell(u + du, y + dy, 2), 0);
            const bool rim = du == 0 || dy == 0 || du == width - 1 || dy == height - 1;
            const bool cross = du == width / 2 || dy == height * 3 / 5;
            canvas.set(wall.cell(u + du, y + dy, 1), rim || cross ? s.frame : s.glass);
        }
    // Rain runs off the sill's ends and middle.
    for (int du = 0; du < width; ++du) {
        const int length = int(hashCell(u + du, y, wall.length, 51) % 9) - 1;
        for (int d = 2; d < 2 + length; ++d)
            if (canvas.at(wall.cell(u + du, y - d, 0))) canvas.set(wall.cell(u + du, y - d, 0), s.soot);
    }
    if (!curtains) return;
    for (int du = -2; du < width + 2; ++du)
        for (int dy = -3; dy <= height; ++dy) {
            const bool drawn = du < 2 || du >= width - 2 || dy >= height - 1;
            if (drawn && !canvas.at(wall.cell(u + du, y + dy, 3))) canvas.set(wall.cell(u + du, y + dy, 3), s.curtain);
        }
}

void drawDoorFrame(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch frame) {
    for (int du = -1; du <= kDoorWidth; ++du)
        for (int dy = 0; dy <= kDoorHeight; ++dy) {
            const bool rim = du < 0 || du == kDoorWidth || dy == kDoorHeight;
            for (int k = 0; k < 3; ++k) {
                const ivec3 cell = wall.cell(u + du, y + dy, k);
                canvas.setEntry(cell, rim ? PaletteBuilder::pick(frame, cell) : uint8_t(0));
            }
        }
}

void drawDoor(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch leaf, Swatch frame, Swatch knob) {
    drawDoorFrame(canvas, wall, u, y, frame);
    drawLeaf(canvas, wall, u, y, leaf, knob);
}

LevelShape makeDoorLeaf(std::string name, const SurfaceStyle& style) {
    const ivec3 size(kDoorWidth, kDoorHeight, 3);
    Canvas canvas(size);
    drawLeaf(canvas, wallFrames(ivec3(0), size).front, 0, 0, canvas.addSurface(style), canvas.addSurface(kDarkSteel));
    return canvas.finish(std::move(name));
}

void drawFloor(Canvas& canvas, ivec3 low, ivec3 high, int y, const FloorSwatches& s, bool ceiling) {
    for (int x = low.x; x < high.x; x += 1)
        for (int z = low.z; z < high.z; ++z) {
            const int board = z / 4;
            const bool joist = (x - low.x) % 7 == 3;
            const bool seam = z % 4 == 3;
            // Boards end on joists, each row on other ones; some stretches of the seams are open.
            const uint32_t dice = hashCell(x / 9, board, y, 61);
            const bool end = joist && hashCell(x, board, y, 62) % 3 == 0;
            const bool open = seam && dice % 4 == 0 && !joist;
            const uint32_t plank = hashCell((x + int(hashCell(0, board, y, 63) % 40)) / 40, board, y, 64);
            if (seam || end)
                canvas.setEntry({x, y, z}, open ? uint8_t(0) : PaletteBuilder::pick(s.seam, {x, y, z}));
            else
                canvas.setEntry({x, y, z}, hashCell(x / 3, y, z, 65) % 4
                                               ? PaletteBuilder::pickFor(s.board, plank)
                                               : PaletteBuilder::pick(s.board, {x / 3, y, z}));
            for (int d = 1; d <= 2; ++d)
                if (joist) canvas.set({x, y - d, z}, s.joist);
            if (ceiling) canvas.set({x, y - 3, z}, s.ceiling);
        }
}

void drawInnerWall(Canvas& canvas, ivec3 low, ivec3 high, Swatch skin, Swatch otherSkin, Swatch stud, Swatch wire) {
    const bool alongX = high.x - low.x > high.z - low.z;
    for (int x = low.x; x < high.x; ++x)
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y) {
                const int u = alongX ? x - low.x : z - low.z, k = alongX ? z - low.z : x - low.x;
                if (k == 0)
                    canvas.set({x, y, z}, skin);
                else if (k == 2)
                    canvas.set({x, y, z}, otherSkin);
                else if (u % 6 == 0 || y == low.y || y == high.y - 1)
                    canvas.set({x, y, z}, stud);
                else if (y == low.y + 9)
                    canvas.set({x, y, z}, wire);
            }
}

int gableHeight(int z, int lowZ, int highZ) {
    const int fromEave = std::min(z - lowZ, highZ - 1 - z);
    return fromEave / 3 * 2;
}

void drawGableRoof(Canvas& canvas, ivec3 low, ivec3 high, int y, const RoofSwatches& s) {
    const int top = y + gableHeight((low.z + high.z) / 2, low.z, high.z) + 3;
    for (int z = low.z; z < high.z; ++z) {
        const int height = y + gableHeight(z, low.z, high.z);
        const int row = std::min(z - low.z, high.z - 1 - z) / 3;
        for (int x = low.x; x < high.x; ++x) {
            const bool edge = x == low.x || x == high.x - 1;
            const uint32_t tile = hashCell((x + row % 2 * 2) / 4, row, z > (low.z + high.z) / 2, 71);
            const bool seam = (x + row % 2 * 2) % 4 == 0;
            for (int d = 0; d < 3; ++d)
                canvas.setEntry({x, height + d, z}, edge ? PaletteBuilder::pick(s.barge, {x, height, z})
                                                    : seam || tile % 9 == 0
                                                        ? PaletteBuilder::pickFor(s.tileDark, tile >> 8)
                                                        : PaletteBuilder::pickFor(s.tile, tile >> 8));
            if ((x - low.x) % 8 == 4)
                for (int d = 1; d <= 2; ++d)
                    if (!canvas.at({x, height - d, z})) canvas.set({x, height - d, z}, s.rafter);
        }
    }
    const int middle = (low.z + high.z) / 2;
    canvas.box({low.x, top, middle - 2}, {high.x, top + 1, middle + 2}, s.ridge);
}

}  // namespace rubble::scenes
