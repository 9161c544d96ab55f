#include "runtime/assets/names.h"

#include <cstdint>

#include "runtime/core/utf8.h"

namespace rubble {
namespace {

constexpr size_t kMaxNameBytes = 200;
constexpr size_t kMaxCharacterBytes = 4;  // of UTF-8

}  // namespace

std::string printableName(std::string_view name) {
    std::string out;
    for (size_t at = 0; at < name.size() && out.size() + kMaxCharacterBytes <= kMaxNameBytes;) {
        const size_t length = utf8Length(name, at);
        const bool control = length == 1 && (uint8_t(name[at]) < 32 || name[at] == 127);
        out += length == 0 || control ? std::string_view("?") : name.substr(at, length);
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
