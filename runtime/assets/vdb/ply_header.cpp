#include "runtime/assets/vdb/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// A property of an element; of a list the type of its length too.
struct Property {
    std::string count, type;  ///< count: empty where it is one number
};
struct Element {
    std::string name;
    uint64_t count = 0;
    std::vector<Property> properties;
};

/// What a header says.
class PlyHeader {
public:
    /// Takes in a line; an error: it is none of a header.
    std::string add(const std::string& line) {
        std::istringstream words(line);
        std::string keyword, first, second, third;
        words >> keyword >> first >> second >> third;
        if (keyword == "format") m_format = first;
        if (keyword == "element") return addElement(first, second);
        if (keyword != "property") return "";
        const bool isList = first == "list";
        if (sizeOf(isList ? second : first) == 0 || (isList && sizeOf(third) == 0))
            return fmt::format("expected a type of numbers in '{}'", line.substr(0, 80));
        if (!m_elements.empty())
            m_elements.back().properties.push_back(isList ? Property{second, third} : Property{"", first});
        return "";
    }
    bool isText() const { return m_format == "ascii"; }
    bool isBigEndian() const { return m_format == "binary_big_endian"; }
    const std::vector<Element>& elements() const { return m_elements; }
    /// Bytes of all elements at least; of a text a digit and what parts it from the next, of a list its length alone.
    uint64_t bytes() const {
        uint64_t all = 0;
        for (const Element& element : m_elements) {
            uint64_t size = 0;
            for (const Property& each : element.properties)
                size += isText() ? 2 : sizeOf(each.count.empty() ? each.type : each.count);
            all += element.count * std::max<uint64_t>(size, 1);
        }
        return all;
    }

private:
    std::string addElement(const std::string& name, const std::string& count) {
        uint64_t number = 0;
        const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), number);
        m_elements.push_back({name, number, {}});
        if (error == std::errc() && end == count.data() + count.size() && number <= UINT32_MAX) return "";
        return fmt::format("expected a number of elements, found '{}'", count.substr(0, 80));
    }

    std::string m_format;
    std::vector<Element> m_elements;
};

/// Goes through the numbers after a header.
class PlyBody {
public:
    PlyBody(const PlyHeader& header, std::string_view bytes) : m_header(header), m_left(bytes) {}

    /// Whether all lists have lengths that the file can hold; else an error.
    std::string listError() {
        for (const Element& element : m_header.elements()) {
            if (std::ranges::all_of(element.properties, &std::string::empty, &Property::count) && !m_header.isText()) {
                uint64_t size = 0;
                for (const Property& each : element.properties) size += sizeOf(each.type);
                skip(element.count * size);
                continue;
            }
            for (uint64_t i = 0; i < element.count; ++i)
                for (const Property& each : element.properties)
                    if (const std::string error = pass(each); !error.empty())
                        return fmt::format("{} {}: {}", element.name.substr(0, 80), i, error);
        }
        return "";
    }

private:
    std::string pass(const Property& property) {
        if (property.count.empty()) return passNumbers(1, property.type), "";
        double length = 0.0;
        std::string found;
        if (m_header.isText()) {
            const std::string_view word = takeWord();
            found = std::string(word.substr(0, 80));
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), length);
            if (error != std::errc() || end != word.data() + word.size()) length = -1.0;
        } else {
            length = takeNumber(property.count);
            found = fmt::format("{}", length);
        }
        const auto most = double(m_left.size());  // a byte at least for each
        if (!(length >= 0.0 && length <= most && length == std::floor(length)))
            return fmt::format("expected a list of 0 to {} numbers, found '{}'", m_left.size(), found);
        return passNumbers(uint64_t(length), property.type), "";
    }
    void passNumbers(uint64_t count, const std::string& type) {
        if (!m_header.isText()) return skip(count * sizeOf(type));
        for (; count > 0; --count) takeWord();
    }
    void skip(uint64_t bytes) { m_left.remove_prefix(size_t(std::min<uint64_t>(bytes, m_left.size()))); }
    std::string_view takeWord() {
        constexpr const char* kSpaces = " \t\r\n";
        m_left.remove_prefix(std::min(m_left.find_first_not_of(kSpaces), m_left.size()));
        const std::string_view word = m_left.substr(0, m_left.find_first_of(kSpaces));
        m_left.remove_prefix(word.size());
        return word;
    }
    /// A number of a binary file; NaN: the file has ended.
    double takeNumber(const std::string& type) {
        const size_t size = sizeOf(type);
        if (m_left.size() < size) return std::nan("");
        uint8_t bytes[8] = {};
        for (size_t i = 0; i < size; ++i) bytes[i] = uint8_t(m_left[m_header.isBigEndian() ? size - 1 - i : i]);
        m_left.remove_prefix(size);
        uint64_t bits = 0;
        std::memcpy(&bits, bytes, sizeof bits);
        if (type.starts_with("float") || type == "double")
            return size == 4 ? std::bit_cast<float>(uint32_t(bits)) : std::bit_cast<double>(bits);
        const bool isSigned = !type.starts_with('u');
        const uint64_t sign = uint64_t(1) << (8 * size - 1);
        return isSigned && (bits & sign) ? -double(2 * sign - bits) : double(bits);
    }

    const PlyHeader& m_header;
    std::string_view m_left;
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
            if (header.bytes() > left + 1)  // the last line of a text may end with the file
                return fmt::format("expected at least {} bytes after its header, found {}", header.bytes(), left);
            const bool isPair = all[end] == '\r' && at < all.size() && all[at] == '\n';  // that ends the line
            return PlyBody(header, all.substr(at + isPair)).listError();
        }
        if (const std::string error = header.add(line); !error.empty()) return error;
    }
    return "expected a header that ends with 'end_header', found none";
}

}  // namespace rubble
