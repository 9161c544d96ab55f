#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/core/progress.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

// The container of all of Rubble's binary files (levels, saved games, recordings): a header, then chunks. Each chunk
// has a kind, a codec, its sizes and an XXH3 hash over its header and its stored bytes, so that every flipped bit is
// noticed. A reader skips chunks of kinds that it does not know.

inline constexpr std::array<char, 8> kFileMagic = {'R', 'U', 'B', 'B', 'L', 'E', '\r', '\n'};
inline constexpr uint32_t kFileVersion = 16;
inline constexpr uint64_t kMaxFileBytes = uint64_t(8) << 30;  ///< larger files are neither written nor read
inline constexpr size_t kGridChunkBytes = 8u << 20;           ///< a GRID chunk ends once it holds this much

/// The first 32 bytes of a file.
struct FileHeader {
    std::array<char, 8> magic = kFileMagic;
    uint32_t version = kFileVersion;
    uint32_t chunks = 0;
    uint64_t contentHash = 0;  ///< of what the file describes: hashLevel(), World::hash()
    uint64_t headerHash = 0;   ///< of the bytes before it
};
/// The 32 bytes before the stored bytes of a chunk.
struct ChunkHeader {
    std::array<char, 4> kind{};
    uint32_t codec = 0;  ///< of the stored bytes; 0: none, 1: one LZ4 block
    uint64_t rawBytes = 0;
    uint64_t storedBytes = 0;
    uint64_t hash = 0;  ///< of the fields before it and the stored bytes
};
static_assert(sizeof(FileHeader) == 32 && sizeof(ChunkHeader) == 32);

/// A header with its hash.
FileHeader makeFileHeader(uint32_t chunks, uint64_t contentHash);

/// Packs chunks one after the other.
class ChunkWriter {
public:
    /// Adds a chunk of raw bytes, packed with LZ4 if that makes them fewer. `memory`: what reading takes for their
    /// content, as archives count it.
    void add(std::array<char, 4> kind, const std::vector<uint8_t>& raw, uint64_t memory = 0);
    /// Adds a chunk of zeros that readers skip if a file with these chunks, and `otherBytes` with what takes
    /// `otherMemory`, would be too short for the budget of its reader.
    void pad(uint64_t otherBytes = 0, uint64_t otherMemory = 0);
    /// A whole file: a header and the chunks, padded.
    std::vector<uint8_t> file(uint64_t contentHash);
    /// The chunks alone.
    const std::vector<uint8_t>& bytes() const { return m_bytes; }
    /// How many chunks there are.
    uint32_t count() const { return m_count; }
    /// The memory that reading them takes.
    uint64_t memory() const { return m_memory; }

private:
    void append(ChunkHeader header, std::span<const uint8_t> stored);

    std::vector<uint8_t> m_bytes;
    uint32_t m_count = 0;
    uint64_t m_memory = 0;
};

/// Writes the bricks of grids as GRID chunks: the shape's number and the number of bricks (32 bits each), then each
/// brick as appendBrick() writes it.
class GridChunkWriter {
public:
    /// `out` must outlive it.
    explicit GridChunkWriter(ChunkWriter& out) : m_out(out) {}
    /// Adds one chunk or more; none for an empty grid.
    void addGrid(uint32_t shape, const VoxelGrid& grid);

private:
    void begin(uint32_t shape);
    void flush();
    ChunkWriter& m_out;
    std::vector<uint8_t> m_raw;
    uint32_t m_bricks = 0;
};
/// Puts the bricks of one GRID chunk into the grid that the chunk's shape number means. Fails in the reader.
void readGridChunk(ByteReader& in, const std::vector<VoxelGrid*>& grids);

/// The header of a file. Fails in the reader if magic, version or hash are wrong.
FileHeader readFileHeader(ByteReader& in);
/// The raw bytes of the next chunk, and its header. Fails in the reader if sizes or hash are wrong.
std::vector<uint8_t> readChunk(ByteReader& in, ChunkHeader& header);
/// Reads a whole file: calls read(header, raw bytes, index) for each chunk until something fails in the reader, and
/// returns the file's header.
template <class F>
FileHeader readChunkFile(ByteReader& in, F&& read) {
    const FileHeader file = readFileHeader(in);
    for (uint32_t i = 0; i < file.chunks && !in.failed(); ++i) {
        ChunkHeader chunk;
        const std::vector<uint8_t> raw = readChunk(in, chunk);
        if (!in.failed()) read(chunk, raw, i);
        reportProgress(double(i + 1) / double(file.chunks));
    }
    in.expectEnd("file");
    return file;
}

}  // namespace rubble
