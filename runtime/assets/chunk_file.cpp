#include "runtime/assets/chunk_file.h"

#include <lz4.h>

#include "runtime/core/hash.h"

namespace rubble {
namespace {

template <class Header>
uint64_t hashHeader(const Header& header) {
    return hashBytes(&header, sizeof header - sizeof(uint64_t));
}

/// The bytes as one LZ4 block; empty if that is not shorter, or if they are more than a block can hold.
std::vector<uint8_t> pack(const std::vector<uint8_t>& raw) {
    if (raw.size() > LZ4_MAX_INPUT_SIZE) return {};
    std::vector<uint8_t> packed(size_t(LZ4_compressBound(int(raw.size()))));
    const int length =
        LZ4_compress_default(reinterpret_cast<const char*>(raw.data()), reinterpret_cast<char*>(packed.data()),
                             int(raw.size()), int(packed.size()));
    packed.resize(length > 0 && size_t(length) < raw.size() ? size_t(length) : 0);
    return packed;
}

}  // namespace

void ChunkWriter::add(std::array<char, 4> kind, const std::vector<uint8_t>& raw, uint64_t memory) {
    const std::vector<uint8_t> packed = pack(raw);
    const bool isPacked = !packed.empty();
    append({kind, isPacked ? 1u : 0u, raw.size(), isPacked ? packed.size() : raw.size(), 0}, isPacked ? packed : raw);
    m_memory += chunkMemory(raw.size()) + memory;
}

void ChunkWriter::append(ChunkHeader header, std::span<const uint8_t> stored) {
    header.hash = hashBytes(stored.data(), stored.size(), hashHeader(header));
    const auto* bytes = reinterpret_cast<const uint8_t*>(&header);
    m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof header);
    m_bytes.insert(m_bytes.end(), stored.begin(), stored.end());
    ++m_count;
}

void ChunkWriter::pad(uint64_t otherBytes, uint64_t otherMemory) {
    const uint64_t memory = m_memory + otherMemory, bytes = m_bytes.size() + otherBytes;
    if (memory <= MemoryBudget::kFree) return;
    // The padding is read too, and takes chunkMemory() of its size.
    const uint64_t wanted = (memory - MemoryBudget::kFree) / (MemoryBudget::kPerByte - chunkMemory(1)) + 1;
    if (wanted <= bytes) return;
    const std::vector<uint8_t> zeros(size_t(wanted - bytes));
    append({{'P', 'A', 'D', ' '}, 0, zeros.size(), zeros.size(), 0}, zeros);
    m_memory += chunkMemory(zeros.size());
}

FileHeader makeFileHeader(uint32_t chunks, uint64_t contentHash) {
    FileHeader header;
    header.chunks = chunks;
    header.contentHash = contentHash;
    header.headerHash = hashHeader(header);
    return header;
}

std::vector<uint8_t> ChunkWriter::file(uint64_t contentHash) {
    pad();
    const FileHeader header = makeFileHeader(m_count, contentHash);
    const auto* bytes = reinterpret_cast<const uint8_t*>(&header);
    std::vector<uint8_t> out;
    out.reserve(sizeof header + m_bytes.size());
    out.insert(out.end(), bytes, bytes + sizeof header);
    out.insert(out.end(), m_bytes.begin(), m_bytes.end());
    return out;
}

void GridChunkWriter::addGrid(uint32_t shape, const VoxelGrid& grid) {
    begin(shape);
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        if (m_raw.size() > kGridChunkBytes) flush(), begin(shape);
        appendBrick(m_raw, position, *brick);
        ++m_bricks;
    });
    flush();
}

void GridChunkWriter::begin(uint32_t shape) {
    m_raw.assign(8, 0);
    std::memcpy(m_raw.data(), &shape, 4);
    m_bricks = 0;
}

void GridChunkWriter::flush() {
    if (m_bricks == 0) return;
    std::memcpy(m_raw.data() + 4, &m_bricks, 4);
    m_out.add({'G', 'R', 'I', 'D'}, m_raw, m_bricks * kBrickMemory);
}

void readGridChunk(ByteReader& in, const std::vector<VoxelGrid*>& grids) {
    const auto shape = in.read<uint32_t>();
    const auto bricks = in.read<uint32_t>();
    if (shape >= grids.size()) in.fail(fmt::format("a shape number below {}", grids.size()), std::to_string(shape), 0);
    for (uint32_t i = 0; i < bricks && !in.failed(); ++i) readBrick(in, *grids[shape]);
}

FileHeader readFileHeader(ByteReader& in) {
    const auto header = in.read<FileHeader>();
    if (!in.failed() && header.magic != kFileMagic) in.fail("a file of Rubble (\"RUBBLE\")", "other bytes", 0);
    if (header.version != kFileVersion)
        in.fail(fmt::format("version {}", kFileVersion),
                fmt::format("{}, of {} version of Rubble", header.version,
                            header.version < kFileVersion ? "an older" : "a newer"),
                8);
    if (header.headerHash != hashHeader(header))
        in.fail("a header whose checksum fits", "another checksum: the file is damaged", 0);
    return header;
}

std::vector<uint8_t> readChunk(ByteReader& in, ChunkHeader& header) {
    const size_t start = in.offset();
    header = in.read<ChunkHeader>();
    if (in.failed()) return {};
    if (header.storedBytes > in.remaining())
        return in.fail(fmt::format("{} bytes of a chunk", header.storedBytes), fmt::format("{}", in.remaining()),
                       start + 16),
               std::vector<uint8_t>{};
    const auto stored = in.readBytes(size_t(header.storedBytes));
    if (hashBytes(stored.data(), stored.size(), hashHeader(header)) != header.hash)
        return in.fail("a chunk whose checksum fits", "another checksum: the file is damaged", start),
               std::vector<uint8_t>{};
    // LZ4 packs at most 255 to 1: a larger size cannot be right and would only cost memory.
    const bool isBlock = header.codec == 1 && header.rawBytes <= LZ4_MAX_INPUT_SIZE &&
                         header.storedBytes <= LZ4_MAX_INPUT_SIZE && header.rawBytes <= header.storedBytes * 255 + 64;
    if (!isBlock && !(header.codec == 0 && header.rawBytes == header.storedBytes))
        return in.fail("a possible size and codec",
                       fmt::format("{} bytes from {}, codec {}", header.rawBytes, header.storedBytes, header.codec),
                       start),
               std::vector<uint8_t>{};
    if (!in.takeMemory(chunkMemory(header.rawBytes))) return {};
    if (header.codec == 0) return {stored.begin(), stored.end()};
    std::vector<uint8_t> raw(size_t(header.rawBytes));
    const int length = LZ4_decompress_safe(reinterpret_cast<const char*>(stored.data()),
                                           reinterpret_cast<char*>(raw.data()), int(stored.size()), int(raw.size()));
    if (length != int(raw.size())) in.fail(fmt::format("{} bytes unpacked", raw.size()), std::to_string(length), start);
    return raw;
}

}  // namespace rubble
