#pragma once
#include <fstream>
#include <string>
#include <vector>

#include "generated/paths.h"

namespace rubble::script {

/// A script of attacks.lua.
struct Attack {
    std::string name, outcome, text;
};

/// All scripts of attacks.lua.
inline std::vector<Attack> readAttacks() {
    std::vector<Attack> attacks;
    std::ifstream file(RUBBLE_SOURCE_DIR "/tests/runtime/script/attacks.lua");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("--- ")) {
            const size_t colon = line.find(": ");
            attacks.push_back({line.substr(4, colon - 4), line.substr(colon + 2), ""});
        } else if (!attacks.empty()) {
            attacks.back().text += line + "\n";
        }
    }
    return attacks;
}

}  // namespace rubble::script
