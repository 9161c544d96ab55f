#include "runtime/assets/names.h"

#include <cstdint>

#include "runtime/core/utf8.h"

namespace rubble {
namespace {

constexpr size_t kMaxNameBytes = 200;
constexpr size_t kMaxCharacterBytes = 4;  // of UTF-8

/// The character at a byte, or "?" instead of one that cannot be printed, which is one byte long.
std::string_view printableCharacter(std::string_view text, size_t at) {
    const size_t length = utf8Length(text, at);
    const bool isControl = length == 1 && (uint8_t(text[at]) < 32 || text[at] == 127);
    return length == 0 || isControl ? std::string_view("?") : text.substr(at, length);
}

}  // namespace

std::string printableText(std::string_view text) {
    std::string out;
    for (size_t at = 0; at < text.size();) {
        const std::string_view next = text[at] == '\n' ? text.substr(at, 1) : printableCharacter(text, at);
        out += next;
        at += next.size();
    }
    return out;
}

std::string printableName(std::string_view name) {
    std::string out;
    for (size_t at = 0; at < name.size() && out.size() + kMaxCharacterBytes <= kMaxNameBytes;) {
        const std::string_view next = printableCharacter(name, at);
        out += next;
        at += next.size();
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
