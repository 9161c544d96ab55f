#include "runtime/assets/vdb/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

namespace rubble {
namespace {

/// Bytes of a number in a binary file; 0: there is no such type.
uint64_t sizeOf(std::string_view type) {
    static constexpr std::pair<std::string_view, uint64_t> kTypes[] = {
        {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
        {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
        {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = std::ranges::find(kTypes, type, &std::pair<std::string_view, uint64_t>::first);
    return found == std::end(kTypes) ? 0 : found->second;
}

/// The least that the elements of a header take.
class PlyHeader {
public:
    /// Takes in a line; an error: it is none of a header.
    std::string add(const std::string& line) {
        std::istringstream words(line);
        std::string keyword, first, second;
        words >> keyword >> first >> second;
        if (keyword == "format") m_isText = first == "ascii";
        if (keyword == "element") return addElement(second);
        if (keyword != "property") return "";
        const uint64_t size = sizeOf(first == "list" ? second : first);
        if (size == 0) return fmt::format("expected a type of numbers in '{}'", line.substr(0, 80));
        m_size += m_isText ? 2 : size;  // a digit and what parts it from the next; of a list its length alone
        return "";
    }
    /// Bytes of all elements at least.
    uint64_t bytes() const { return m_bytes + m_count * std::max<uint64_t>(m_size, 1); }

private:
    std::string addElement(const std::string& count) {
        m_bytes = bytes();
        m_count = m_size = 0;
        const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), m_count);
        if (error == std::errc() && end == count.data() + count.size() && m_count <= UINT32_MAX) return "";
        return fmt::format("expected a number of elements, found '{}'", count.substr(0, 80));
    }

    bool m_isText = false;
    uint64_t m_bytes = 0, m_count = 0, m_size = 0;  ///< of elements before; of the last one
};

}  // namespace

std::string plyHeaderError(std::span<const uint8_t> bytes) {
    const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!all.starts_with("ply")) return "expected a PLY file, which begins with 'ply'";
    PlyHeader header;
    for (size_t at = 0; at < all.size();) {
        const size_t end = all.find_first_of("\r\n", at);
        if (end == all.npos) break;
        const std::string line(all.substr(at, end - at));
        at = end + 1;
        if (line == "end_header") {
            const uint64_t left = all.size() - at;
            if (header.bytes() <= left + 1) return "";  // the last line of a text may end with the file
            return fmt::format("expected at least {} bytes after its header, found {}", header.bytes(), left);
        }
        if (const std::string error = header.add(line); !error.empty()) return error;
    }
    return "expected a header that ends with 'end_header', found none";
}

}  // namespace rubble
