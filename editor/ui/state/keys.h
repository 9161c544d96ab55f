#pragma once
#include <string>
#include <string_view>

#include "editor/ui/state/session.h"

namespace editor {

/// A key with what is held beside it.
struct KeyPress {
    int key = 0;  ///< of GLFW
    bool hasCtrl = false, hasShift = false;
};
/// Keys as they are shown: "Ctrl+Shift+D", "F5", "Del". Throws Refused of others.
KeyPress readKeys(std::string_view shown);
/// Takes keys of the user's own from a file, which come before those of the editor: lines of keys and a command, as
/// "Ctrl+K lock" or "F5 duplicate 1,0,0". A command that needs more opens its form. Wrong lines are left out: what is
/// returned has a line for each, with its number. Empty: all were taken, or there is no such file.
std::string loadKeys(const std::string& path);
/// Where that file is: keys.txt in rubble of the user's folder of settings; empty: there is none.
std::string userKeys();

/// Does what the keys that went down ask for, unless a field is being typed into.
void handleKeys(Session& session, bool isTyping);
/// The keys of a command, as they are shown; empty: it has none.
std::string keyOf(std::string_view command);

}  // namespace editor
