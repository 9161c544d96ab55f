#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

// What all of Rubble's files are made of: a header and chunks, each with kind, codec, sizes and an XXH3 hash over its
// header and stored bytes, so that no flipped bit passes. A reader skips chunks of kinds that it does not know.

inline constexpr std::array<char, 8> kFileMagic = {'R', 'U', 'B', 'B', 'L', 'E', '\r', '\n'};
inline constexpr uint32_t kFileVersion = 5;
inline constexpr uint64_t kMaxFileBytes = uint64_t(8) << 30;
inline constexpr size_t kGridChunkBytes = 8u << 20;  ///< a GRID chunk is closed once it holds this much

struct FileHeader {
    std::array<char, 8> magic = kFileMagic;
    uint32_t version = kFileVersion;
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

FileHeader makeFileHeader(uint32_t chunks, uint64_t contentHash);

/// Packs chunks one behind the other.
class ChunkWriter {
public:
    void add(std::array<char, 4> kind, const std::vector<uint8_t>& raw);
    /// The chunks behind a header.
    std::vector<uint8_t> file(uint64_t contentHash) const;
    const std::vector<uint8_t>& bytes() const { return m_bytes; }
    uint32_t count() const { return m_count; }

private:
    std::vector<uint8_t> m_bytes;
    uint32_t m_count = 0;
};

/// Collects GRID chunks: u32 shape, u32 bricks, then each brick.
class GridChunkWriter {
public:
    explicit GridChunkWriter(ChunkWriter& out) : m_out(out) {}
    void addGrid(uint32_t shape, const VoxelGrid& grid);

private:
    void begin(uint32_t shape);
    void flush();
    ChunkWriter& m_out;
    std::vector<uint8_t> m_raw;
    uint32_t m_bricks = 0;
};
/// The bricks of one such chunk, into the grids by number.
void readGridChunk(ByteReader& in, const std::vector<VoxelGrid*>& grids);

/// Checked; fails in the reader.
FileHeader readFileHeader(ByteReader& in);
/// Bytes of one chunk, checked and unpacked.
std::vector<uint8_t> readChunk(ByteReader& in, ChunkHeader& header);
/// A whole file: its header, and read(header, raw bytes, index) for each chunk, until something fails in the reader.
template <class F>
FileHeader readChunkFile(ByteReader& in, F&& read) {
    const FileHeader file = readFileHeader(in);
    for (uint32_t i = 0; i < file.chunks && !in.failed(); ++i) {
        ChunkHeader chunk;
        const std::vector<uint8_t> raw = readChunk(in, chunk);
        if (!in.failed()) read(chunk, raw, i);
    }
    if (in.remaining() > 0) in.fail("the end of the file", std::to_string(in.remaining()) + " more bytes");
    return file;
}

}  // namespace rubble
