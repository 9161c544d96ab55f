#pragma once
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace editor {

/// A text with small letters of ASCII, to compare by.
inline std::string lower(std::string_view text) {
    std::string all(text);
    std::transform(all.begin(), all.end(), all.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return all;
}

}  // namespace editor
