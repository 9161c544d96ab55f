#pragma once
#include <string>

#include "runtime/world/edits/edit.h"

namespace rubble {

/// What is wrong with the numbers of an edit, by runtime/core/ranges.h; empty: nothing. A World leaves such an edit
/// out. Handles are not checked.
std::string editError(const Edit& edit);
/// The name of an edit's kind: the function by which a host makes it.
const char* editName(const Edit& edit);

}  // namespace rubble
