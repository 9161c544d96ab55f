#include "runtime/assets/vdb/vdb_header.h"

#include "runtime/assets/byte_reader.h"

namespace rubble {
namespace {

constexpr int64_t kMagic = 0x56444220;
constexpr uint32_t kOldest = 222, kNewest = 224;  // file versions of OpenVDB 1.2 to 12
constexpr uint32_t kMaxGrids = 1u << 20;
constexpr size_t kUuidCharacters = 36;

void skipMetadata(ByteReader& in) {
    const uint32_t count = in.readCount(12, "metadata");
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        in.readString();
        in.readString();
        in.readBytes(in.readCount(1, "bytes of metadata"));
    }
}

/// Reads a row of the grid table and skips the grid.
VdbGridEntry readGridEntry(ByteReader& in) {
    VdbGridEntry entry;
    entry.name = in.readString();
    entry.type = in.readString();
    in.readString();  // the grid that this one is an instance of
    const size_t start = in.offset();
    const auto grid = in.read<int64_t>(), blocks = in.read<int64_t>(), end = in.read<int64_t>();
    const auto here = int64_t(in.offset());
    if (in.failed()) return entry;
    if (grid < here || blocks < grid || end < blocks || end - here > int64_t(in.remaining()))
        in.fail(fmt::format("rising offsets from {} to {}", here, size_t(here) + in.remaining()),
                fmt::format("{}, {}, {}", grid, blocks, end), start);
    else
        in.readBytes(size_t(end - here));
    return entry;
}

}  // namespace

Result<std::vector<VdbGridEntry>> scanVdbHeader(std::span<const uint8_t> bytes, const std::string& name) {
    ByteReader in(bytes, "OpenVDB header");
    if (const auto magic = in.read<int64_t>(); magic != kMagic) in.fail("an OpenVDB file", "other bytes", 0);
    if (const auto version = in.read<uint32_t>(); version < kOldest || version > kNewest)
        in.fail(fmt::format("file version {} to {}", kOldest, kNewest), std::to_string(version), 8);
    in.read<std::array<uint32_t, 2>>();  // of the library
    if (const auto hasOffsets = in.read<uint8_t>(); hasOffsets != 1)
        in.fail("a file with grid offsets (1)", std::to_string(hasOffsets), in.offset() - 1);
    in.readBytes(kUuidCharacters);
    skipMetadata(in);
    const uint32_t count = in.readCount(36, "grids");
    if (count > kMaxGrids) in.fail(fmt::format("at most {} grids", kMaxGrids), std::to_string(count));
    std::vector<VdbGridEntry> entries;
    for (uint32_t i = 0; i < count && !in.failed(); ++i) entries.push_back(readGridEntry(in));
    if (in.failed()) return Error{name + ": " + in.error()};
    return entries;
}

}  // namespace rubble
