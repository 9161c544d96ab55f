#pragma once
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "runtime/assets/chunk_file.h"

namespace rubble {

/// Reads a file by `reader`, which takes its bytes and gives a Result. If nothing but its content hash is wrong, it is
/// read again with the hash that the error names.
template <class Reader>
auto readWithItsHash(std::vector<uint8_t> file, Reader&& reader) {
    auto content = reader(file);
    const std::string error = content ? std::string() : content.error(), expected = "expected the hash of the ";
    const size_t at = error.find(expected), number = error.find(", ", at);
    if (at == std::string::npos || number == std::string::npos) return content;
    uint32_t chunks = 0;
    std::memcpy(&chunks, file.data() + offsetof(FileHeader, chunks), sizeof chunks);
    const FileHeader header = makeFileHeader(chunks, std::strtoull(error.c_str() + number + 2, nullptr, 16));
    std::memcpy(file.data(), &header, sizeof header);
    return reader(file);
}

}  // namespace rubble
