#pragma once
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <set>
#include <string>
#include <vector>

#include "editor/core/editor.h"

namespace editor {

/// Makes copies of bodies, moved by metres, as an edit: with their shapes, what is set of them, their lights, the
/// joints among them or to the world, and all names and tags. Adds notes on joints that cannot be copied. Throws
/// Refused and rubble::Error.
std::vector<rubble_body> copyBodies(Editor& editor, const std::vector<rubble_body>& bodies, glm::dvec3 by,
                                    std::set<std::string>& notes);

}  // namespace editor
