#include "runtime/assets/rubble_file.h"

#include <new>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/assets/level_validation.h"
#include "runtime/core/hash.h"

namespace rubble {
namespace {

/// What the chunks read so far have given.
struct ParsedLevel {
    std::vector<PaletteRef> palettes;
    Level level;
    std::vector<VoxelGrid*> grids;  ///< of all shapes, by the numbers that GRID chunks use
    bool haveLevel = false;
};

/// Reads the content of one chunk. Failures go to the reader of the file.
void readContent(const ChunkHeader& header, const std::vector<uint8_t>& raw, size_t chunk, ParsedLevel& out,
                 ByteReader& file) {
    const std::string kind(header.kind.data(), 4);
    ByteReader in(raw,
                  fmt::format("of chunk {} ({}) unpacked", chunk,
                              kind == "PALT" || kind == "LEVL" || kind == "GRID" ? kind : "other"),
                  file);
    if (kind == "PALT") {
        out.palettes = palettesFromBytes(in);
    } else if (kind == "LEVL" && !out.haveLevel) {
        out.level = levelFromBytes(in, out.palettes);
        out.haveLevel = true;
        for (LevelBody& body : out.level.bodies)
            for (LevelShape& shape : body.shapes) out.grids.push_back(&shape.grid);
    } else if (kind == "GRID") {
        readGridChunk(in, out.grids);
    } else if (kind == "SAVE") {
        return file.fail("a level", "a saved game, which load_game() reads");
    } else {
        return;
    }
    in.expectEnd("chunk");
    file.takeErrorOf(in);
}

}  // namespace

uint64_t hashLevel(const Level& level) {
    PaletteList palettes;
    const std::vector<uint8_t> bytes = levelToBytes(level, palettes);
    const std::vector<uint8_t> paletteBytes = palettesToBytes(palettes.palettes());
    uint64_t hash = hashBytes(bytes.data(), bytes.size());
    hash = hashBytes(paletteBytes.data(), paletteBytes.size(), hash);
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) hash = hashValue(shape.grid.contentHash(), hash);
    return hash;
}

std::vector<uint8_t> levelToRubble(const Level& level) {
    ChunkWriter out;
    PaletteList palettes;
    uint64_t memory = 0;
    const std::vector<uint8_t> levelBytes = levelToBytes(level, palettes, &memory);
    out.add({'P', 'A', 'L', 'T'}, palettesToBytes(palettes.palettes()));
    out.add({'L', 'E', 'V', 'L'}, levelBytes, memory);
    GridChunkWriter grids(out);
    uint32_t shape = 0;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& item : body.shapes) grids.addGrid(shape++, item.grid);
    return out.file(hashLevel(level));
}

Result<Level> levelFromRubble(std::span<const uint8_t> bytes, const std::string& name) {
    ByteReader in(bytes, "baked level");
    ParsedLevel parsed;
    const FileHeader header = readChunkFile(in, [&](const ChunkHeader& chunk, const std::vector<uint8_t>& raw,
                                                    uint32_t i) { readContent(chunk, raw, i, parsed, in); });
    if (!parsed.haveLevel) in.fail("a LEVL chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    if (const Result<Done> checked = validateLevel(parsed.level); !checked) return Error{name + ": " + checked.error()};
    if (const uint64_t hash = hashLevel(parsed.level); hash != header.contentHash)
        return Error{fmt::format("{}: byte 16: expected the hash of the level, {:016x}, found {:016x}", name, hash,
                                 header.contentHash)};
    return std::move(parsed.level);
}

Result<Level> readRubble(const std::string& path) {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    try {
        return levelFromRubble(*bytes, path);
    } catch (const std::bad_alloc&) {
        return Error{path + ": not enough memory for what it describes"};
    }
}

Result<Done> writeRubble(const std::string& path, const Level& level) {
    if (const Result<Done> checked = validateLevel(level); !checked) return Error{path + ": " + checked.error()};
    return writeFileAtomically(path, levelToRubble(level), kMaxFileBytes);
}

}  // namespace rubble
