#include "runtime/assets/rubble_file.h"

#include <lz4.h>

#include <new>

#include "runtime/assets/file_bytes.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/assets/level_check.h"
#include "runtime/core/hash.h"

namespace rubble {
namespace {

constexpr std::array<char, 8> kMagic = {'R', 'U', 'B', 'B', 'L', 'E', '\r', '\n'};
constexpr uint32_t kVersion = 1;
constexpr size_t kGridChunkBytes = 8u << 20;  // a GRID chunk is closed once it holds this much
constexpr uint64_t kMaxChunkBytes = 512u << 20;
constexpr uint64_t kMaxFileBytes = uint64_t(8) << 30;

struct FileHeader {
    std::array<char, 8> magic = kMagic;
    uint32_t version = kVersion;
    uint32_t chunks = 0;
    uint64_t contentHash = 0;
    uint64_t headerHash = 0;
};
struct ChunkHeader {
    std::array<char, 4> kind{};
    uint32_t codec = 0;  ///< 0: as it is, 1: LZ4 block
    uint64_t rawBytes = 0;
    uint64_t storedBytes = 0;
    uint64_t hash = 0;
};
static_assert(sizeof(FileHeader) == 32 && sizeof(ChunkHeader) == 32);

template <class Header>
uint64_t hashHeader(const Header& header) {
    return hashBytes(&header, sizeof header - sizeof(uint64_t));
}

void appendChunk(std::vector<uint8_t>& out, std::array<char, 4> kind, const std::vector<uint8_t>& raw) {
    std::vector<uint8_t> packed(size_t(LZ4_compressBound(int(raw.size()))));
    const int length =
        LZ4_compress_default(reinterpret_cast<const char*>(raw.data()), reinterpret_cast<char*>(packed.data()), int(raw.size()), int(packed.size()));
    const bool smaller = length > 0 && size_t(length) < raw.size();
    if (smaller) packed.resize(size_t(length));
    const std::vector<uint8_t>& stored = smaller ? packed : raw;
    ChunkHeader header{kind, smaller ? 1u : 0u, raw.size(), stored.size(), 0};
    header.hash = hashBytes(stored.data(), stored.size(), hashHeader(header));
    const auto* bytes = reinterpret_cast<const uint8_t*>(&header);
    out.insert(out.end(), bytes, bytes + sizeof header);
    out.insert(out.end(), stored.begin(), stored.end());
}

/// Collects chunks of bricks: u32 shape, u32 bricks, then each brick.
class GridChunks {
public:
    explicit GridChunks(std::vector<uint8_t>& out) : m_out(out) {}

    void addGrid(uint32_t shape, const VoxelGrid& grid) {
        begin(shape);
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            if (m_raw.size() > kGridChunkBytes) flush(), begin(shape);
            appendBrick(m_raw, position, *brick);
            ++m_bricks;
        });
        flush();
    }
    uint32_t count() const { return m_count; }

private:
    void begin(uint32_t shape) {
        m_raw.assign(8, 0);
        std::memcpy(m_raw.data(), &shape, 4);
        m_bricks = 0;
    }
    void flush() {
        if (m_bricks == 0) return;
        std::memcpy(m_raw.data() + 4, &m_bricks, 4);
        appendChunk(m_out, {'G', 'R', 'I', 'D'}, m_raw);
        ++m_count;
    }
    std::vector<uint8_t>& m_out;
    std::vector<uint8_t> m_raw;
    uint32_t m_bricks = 0, m_count = 0;
};

void appendPaintColors(std::vector<uint8_t>& out, uint32_t shape, const PaintColors& colors) {
    std::vector<uint8_t> raw(4);
    std::memcpy(raw.data(), &shape, 4);
    const std::vector<uint8_t> bytes = paintColorsToBytes(colors);
    raw.insert(raw.end(), bytes.begin(), bytes.end());
    appendChunk(out, {'P', 'C', 'O', 'L'}, raw);
}

/// Bytes of one chunk, checked and unpacked.
std::vector<uint8_t> readChunk(ByteReader& in, ChunkHeader& header) {
    const size_t start = in.offset();
    header = in.read<ChunkHeader>();
    if (in.failed()) return {};
    if (header.storedBytes > in.remaining())
        return in.fail(fmt::format("{} bytes of a chunk", header.storedBytes), fmt::format("{}", in.remaining()), start + 16), std::vector<uint8_t>{};
    const auto stored = in.readBytes(size_t(header.storedBytes));
    if (hashBytes(stored.data(), stored.size(), hashHeader(header)) != header.hash)
        return in.fail("a chunk whose checksum fits", "a damaged one", start), std::vector<uint8_t>{};
    // LZ4 cannot pack by more than 255 to 1: a larger claim is a lie that would only cost memory.
    if (header.rawBytes > kMaxChunkBytes || header.rawBytes > header.storedBytes * 255 + 64 || header.codec > 1 ||
        (header.codec == 0 && header.rawBytes != header.storedBytes))
        return in.fail("a possible size and codec", fmt::format("{} bytes from {}, codec {}", header.rawBytes, header.storedBytes, header.codec),
                       start),
               std::vector<uint8_t>{};
    if (header.codec == 0) return {stored.begin(), stored.end()};
    std::vector<uint8_t> raw(size_t(header.rawBytes));
    const int length =
        LZ4_decompress_safe(reinterpret_cast<const char*>(stored.data()), reinterpret_cast<char*>(raw.data()), int(stored.size()), int(raw.size()));
    if (length != int(raw.size())) in.fail(fmt::format("{} bytes unpacked", raw.size()), std::to_string(length), start);
    return raw;
}

struct Parsed {
    std::vector<PaletteRef> palettes;
    Level level;
    std::vector<LevelShape*> shapes;
    bool haveLevel = false;
};

void readContent(const ChunkHeader& header, const std::vector<uint8_t>& raw, size_t chunk, Parsed& out, ByteReader& file) {
    const std::string kind(header.kind.data(), 4);
    ByteReader in(
        raw, fmt::format("of chunk {} ({}) unpacked", chunk, kind == "PALT" || kind == "LEVL" || kind == "GRID" || kind == "PCOL" ? kind : "other"));
    if (kind == "PALT") {
        out.palettes = palettesFromBytes(in);
    } else if (kind == "LEVL" && !out.haveLevel) {
        out.level = levelFromBytes(in, out.palettes);
        out.haveLevel = true;
        for (LevelBody& body : out.level.bodies)
            for (LevelShape& shape : body.shapes) out.shapes.push_back(&shape);
    } else if (kind == "GRID") {
        const auto shape = in.read<uint32_t>();
        const auto bricks = in.read<uint32_t>();
        if (shape >= out.shapes.size()) in.fail(fmt::format("a shape number below {}", out.shapes.size()), std::to_string(shape), 0);
        for (uint32_t i = 0; i < bricks && !in.failed(); ++i) readBrick(in, out.shapes[shape]->grid);
    } else if (kind == "PCOL") {
        const auto shape = in.read<uint32_t>();
        if (shape >= out.shapes.size()) in.fail(fmt::format("a shape number below {}", out.shapes.size()), std::to_string(shape), 0);
        PaintColorsRef colors = paintColorsFromBytes(in);
        if (!in.failed()) out.shapes[shape]->paintColors = std::move(colors);
    } else {
        return;
    }
    if (!in.failed() && in.remaining() > 0) in.fail("the end of the chunk", fmt::format("{} more bytes", in.remaining()));
    file.adopt(in);
}

}  // namespace

uint64_t hashLevel(const Level& level) {
    PaletteList palettes;
    const std::vector<uint8_t> bytes = levelToBytes(level, palettes);
    const std::vector<uint8_t> paletteBytes = palettesToBytes(palettes.palettes());
    uint64_t hash = hashBytes(bytes.data(), bytes.size());
    hash = hashBytes(paletteBytes.data(), paletteBytes.size(), hash);
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            hash = hashValue(shape.grid.contentHash(), hash);
            if (!shape.paintColors) continue;
            const std::vector<uint8_t> colors = paintColorsToBytes(*shape.paintColors);
            hash = hashBytes(colors.data(), colors.size(), hash);
        }
    return hash;
}

std::vector<uint8_t> levelToRubble(const Level& level) {
    std::vector<uint8_t> out(sizeof(FileHeader));
    PaletteList palettes;
    const std::vector<uint8_t> levelBytes = levelToBytes(level, palettes);
    appendChunk(out, {'P', 'A', 'L', 'T'}, palettesToBytes(palettes.palettes()));
    appendChunk(out, {'L', 'E', 'V', 'L'}, levelBytes);
    GridChunks grids(out);
    uint32_t shape = 0, paintChunks = 0;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& item : body.shapes) {
            grids.addGrid(shape, item.grid);
            if (item.paintColors) appendPaintColors(out, shape, *item.paintColors), ++paintChunks;
            ++shape;
        }
    FileHeader header;
    header.chunks = 2 + grids.count() + paintChunks;
    header.contentHash = hashLevel(level);
    header.headerHash = hashHeader(header);
    std::memcpy(out.data(), &header, sizeof header);
    return out;
}

Result<Level> levelFromRubble(std::span<const uint8_t> bytes, const std::string& name) {
    ByteReader in(bytes, "baked level");
    const auto header = in.read<FileHeader>();
    if (!in.failed() && header.magic != kMagic) in.fail("a baked level (\"RUBBLE\")", "other bytes", 0);
    if (header.version != kVersion) in.fail(fmt::format("version {}", kVersion), std::to_string(header.version), 8);
    if (header.headerHash != hashHeader(header)) in.fail("a header whose checksum fits", "a damaged one", 0);
    Parsed parsed;
    for (uint32_t i = 0; i < header.chunks && !in.failed(); ++i) {
        ChunkHeader chunk;
        const std::vector<uint8_t> raw = readChunk(in, chunk);
        if (!in.failed()) readContent(chunk, raw, i, parsed, in);
    }
    if (in.remaining() > 0) in.fail("the end of the file", fmt::format("{} more bytes", in.remaining()));
    if (!parsed.haveLevel) in.fail("a LEVL chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    if (const Result<Done> checked = checkLevel(parsed.level); !checked) return Error{name + ": " + checked.error()};
    if (hashLevel(parsed.level) != header.contentHash) return Error{name + ": byte 16: expected the hash of the level, found another"};
    return std::move(parsed.level);
}

Result<Level> readRubble(const std::string& path) try {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    return levelFromRubble(*bytes, path);
} catch (const std::bad_alloc&) {
    return Error{path + ": not enough memory for what it describes"};
}

Result<Done> writeRubble(const std::string& path, const Level& level) {
    if (const Result<Done> checked = checkLevel(level); !checked) return Error{path + ": " + checked.error()};
    return writeFileAtomically(path, levelToRubble(level));
}

}  // namespace rubble
