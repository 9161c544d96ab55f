#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace rubble::script {

/// Whether a character breaks or hides a line of a message.
inline bool isControl(char letter) {
    return static_cast<unsigned char>(letter) < 32 || letter == 127;
}

/// Whether a path has an ending, which is given in small letters.
inline bool hasEnding(std::string path, std::string_view ending) {
    for (char& letter : path)
        if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
    return path.ends_with(ending);
}

/// Whether a level may name a script so: one line that ends in .lua.
inline bool isScriptName(std::string path) {
    if (std::any_of(path.begin(), path.end(), isControl)) return false;
    return hasEnding(std::move(path), ".lua");
}

}  // namespace rubble::script
