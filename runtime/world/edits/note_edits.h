#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/world/objects/named_data.h"
#include "runtime/world/objects/note.h"

namespace rubble {

/// Gives an object another name. Names need not be unique.
struct SetNameEdit {
    AnyObject object;
    std::string name;
};

/// Gives an object a tag, or a tag that it has another value.
struct SetTagEdit {
    AnyObject object;
    std::string tag;    ///< without "="
    std::string value;  ///< may be empty
};

/// Takes a tag away. An object without it stays as it is.
struct RemoveTagEdit {
    AnyObject object;
    std::string tag;
};

/// Gives an object a number of the host's own.
struct SetUserValueEdit {
    AnyObject object;
    uint64_t value = 0;
};

/// Names the scripts of the level.
struct SetScriptsEdit {
    std::vector<LevelScript> scripts;
    bool adds = false;  ///< to those that it names, as a prefab does; else in their place
};

}  // namespace rubble
