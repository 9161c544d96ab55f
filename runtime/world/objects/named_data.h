#pragma once
#include <string>

namespace rubble {

/// A script that a level names: who runs scripts reads it.
struct LevelScript {
    std::string path;        ///< in the level's folder
    std::string parameters;  ///< "name=value", a line each
    bool operator==(const LevelScript&) const = default;
};

/// What a host keeps with a game under a name.
struct HostData {
    std::string name, bytes;
    bool operator==(const HostData&) const = default;
};

}  // namespace rubble
