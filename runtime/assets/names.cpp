#include "runtime/assets/names.h"

#include <cstddef>
#include <cstdint>

namespace rubble {
namespace {

constexpr size_t kMaxNameBytes = 200;
constexpr size_t kMaxCharacterBytes = 4;  // of UTF-8

/// How many bytes the UTF-8 character at `at` has; 0 if it is not well-formed.
size_t characterLength(const std::string& text, size_t at) {
    const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : uint8_t(0); };
    const auto isTail = [&](size_t i) { return (byte(i) & 0xc0) == 0x80; };
    const uint8_t first = byte(at), second = byte(at + 1);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first <= 0xdf) return isTail(at + 1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f)) return 0;
        return isTail(at + 1) && isTail(at + 2) ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f)) return 0;
        return isTail(at + 1) && isTail(at + 2) && isTail(at + 3) ? 4 : 0;
    }
    return 0;
}

}  // namespace

bool isUtf8(const std::string& text) {
    for (size_t at = 0; at < text.size();) {
        const size_t length = characterLength(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

std::string printableName(const std::string& name) {
    std::string out;
    for (size_t at = 0; at < name.size() && out.size() + kMaxCharacterBytes <= kMaxNameBytes;) {
        const size_t length = characterLength(name, at);
        const bool control = length == 1 && (uint8_t(name[at]) < 32 || name[at] == 127);
        out += length == 0 || control ? "?" : name.substr(at, length);
        at += length ? length : 1;
    }
    return out.empty() ? "unnamed" : out;
}

std::string UniqueNames::unique(const std::string& name) {
    std::string candidate = name;
    while (!m_taken.insert(candidate).second) {
        int& next = m_next.try_emplace(name, 2).first->second;
        candidate = name + " " + std::to_string(next++);
    }
    return candidate;
}

}  // namespace rubble
