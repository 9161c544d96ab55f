#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "runtime/assets/chunk_file.h"

namespace rubble {

/// A file without the chunk that writers add so that it can be read within its budget, with a valid header.
inline std::vector<uint8_t> withoutPadding(std::vector<uint8_t> file) {
    const std::array<char, 4> kind{'P', 'A', 'D', ' '};
    const auto padding = std::search(file.begin(), file.end(), kind.begin(), kind.end());
    if (padding == file.end()) return file;
    file.erase(padding, file.end());
    uint32_t chunks = 0;
    uint64_t hash = 0;
    std::memcpy(&chunks, file.data() + 12, 4), std::memcpy(&hash, file.data() + 16, 8);
    const FileHeader header = makeFileHeader(chunks - 1, hash);
    std::memcpy(file.data(), &header, sizeof header);
    return file;
}

}  // namespace rubble
