#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/hash.h"

namespace rubble {

/// A script that a level names: who runs scripts reads it.
struct LevelScript {
    std::string path;        ///< in the level's folder
    std::string parameters;  ///< "name=value", a line each
    bool operator==(const LevelScript&) const = default;
};

/// A hash of a list of them; of none it is `hash`.
inline uint64_t hashScripts(const std::vector<LevelScript>& scripts, uint64_t hash = 0) {
    for (const LevelScript& script : scripts)
        for (const std::string* text : {&script.path, &script.parameters})
            hash = hashBytes(text->data(), text->size(), hashValue(uint64_t(text->size()), hash));
    return hash;
}

/// What a host keeps with a game under a name.
struct HostData {
    std::string name, bytes;
    bool operator==(const HostData&) const = default;
};

}  // namespace rubble
