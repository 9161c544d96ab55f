#pragma once
#include <string>
#include <string_view>

#include "editor/ui/state/session.h"

namespace editor {

/// Does what the keys that went down ask for, unless a field is being typed into.
void handleKeys(Session& session, bool isTyping);
/// The keys of a command, as they are shown; empty: it has none.
std::string keyOf(std::string_view command);

}  // namespace editor
