#include "runtime/assets/level_bytes.h"

#include "runtime/assets/binary_archive.h"
#include "runtime/assets/level_fields.h"

namespace rubble {
namespace {

enum BrickStorage : uint8_t { kFull, kUniform, kMixed };
constexpr uint8_t kPainted = 4;  // added to the kind: 512 bytes of paint follow

bool fitsGrid(const Brick& brick, glm::ivec3 position, glm::ivec3 size) {
    const glm::ivec3 remaining = size - position * kBrickSize;
    if (remaining.x >= kBrickSize && remaining.y >= kBrickSize && remaining.z >= kBrickSize) return true;
    bool fits = true;
    forEachVoxel(brick.occupancy, [&](int i) {
        const glm::ivec3 cell = voxelInBrick(i);
        fits = fits && cell.x < remaining.x && cell.y < remaining.y && cell.z < remaining.z;
    });
    return fits;
}

}  // namespace

std::vector<uint8_t> levelToBytes(const Level& level, PaletteList& palettes, uint64_t* memory) {
    std::vector<uint8_t> bytes;
    BinaryOutputArchive out(bytes, palettes);
    out.put(level);
    if (memory) *memory = out.memory();
    return bytes;
}

Level levelFromBytes(ByteReader& in, const std::vector<PaletteRef>& palettes) {
    Level level;
    level.materials.materials.clear();
    BinaryInputArchive(in, palettes).get(level);
    return level;
}

std::vector<uint8_t> palettesToBytes(const std::vector<PaletteRef>& palettes) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive out(bytes, unused);
    out.put(uint32_t(palettes.size()));
    for (const PaletteRef& palette : palettes)
        for (const PaletteEntry& entry : *palette) out.put(entry);
    return bytes;
}

std::vector<PaletteRef> palettesFromBytes(ByteReader& in) {
    std::vector<PaletteRef> palettes;
    const uint32_t count = in.readCount(256 * 16, "palettes");
    BinaryInputArchive archive(in, palettes);
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        auto palette = std::make_shared<Palette>();
        for (PaletteEntry& entry : *palette) archive.get(entry);
        palettes.push_back(std::move(palette));
    }
    return palettes;
}

void appendBrick(std::vector<uint8_t>& out, glm::ivec3 position, const Brick& brick) {
    PaletteList unused;
    BinaryOutputArchive archive(out, unused);
    for (int i = 0; i < 3; ++i) archive.put(uint16_t(position[i]));
    const BrickStorage kind = brick.indices ? kMixed : brick.full() ? kFull : kUniform;
    archive.put(uint8_t(kind | (brick.paint ? kPainted : 0)));
    if (kind == kMixed)
        out.insert(out.end(), brick.indices->begin(), brick.indices->end());
    else
        archive.put(brick.uniform);
    if (kind == kUniform) archive.put(brick.occupancy);
    if (brick.paint) out.insert(out.end(), brick.paint->begin(), brick.paint->end());
}

void readBrick(ByteReader& in, VoxelGrid& grid) {
    const size_t start = in.offset();
    glm::ivec3 position;
    for (int i = 0; i < 3; ++i) position[i] = in.read<uint16_t>();
    const auto kindByte = in.read<uint8_t>();
    const uint8_t kind = kindByte & ~kPainted;
    BrickIndices indices{};
    if (kind == kMixed) {
        const auto raw = in.readBytes(kBrickVoxels);
        if (!in.failed()) std::copy(raw.begin(), raw.end(), indices.begin());
    } else if (kind == kFull) {
        indices.fill(in.read<uint8_t>());
    } else if (kind == kUniform) {
        const auto value = in.read<uint8_t>();
        const auto occupancy = in.read<std::array<uint64_t, 8>>();
        forEachVoxel(occupancy, [&](int i) { indices[size_t(i)] = value; });
    } else {
        in.fail("a brick kind of 0 to 2", std::to_string(kind), start + 6);
    }
    const auto paint = kindByte & kPainted ? in.readBytes(kBrickVoxels) : std::span<const uint8_t>();
    if (!in.takeMemory(kBrickMemory)) return;
    BrickIndices layer;
    std::copy(paint.begin(), paint.end(), layer.begin());
    const glm::ivec3 bricks = grid.sizeInBricks();
    BrickRef brick = makeBrick(indices, paint.empty() ? nullptr : &layer);
    if (position.x >= bricks.x || position.y >= bricks.y || position.z >= bricks.z ||
        (brick && !fitsGrid(*brick, position, grid.size())))
        return in.fail(
            fmt::format("a brick inside a grid of {}x{}x{} cells", grid.size().x, grid.size().y, grid.size().z),
            fmt::format("brick ({}, {}, {})", position.x, position.y, position.z), start);
    if (!brick || grid.brickAt(position))
        return in.fail("each brick once and not empty",
                       fmt::format("brick ({}, {}, {})", position.x, position.y, position.z), start);
    grid.setBrick(position, std::move(brick));
}

}  // namespace rubble
