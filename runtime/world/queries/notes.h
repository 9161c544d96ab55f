#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "runtime/world/state/world_data.h"

namespace rubble {

/// Whether there is an object of this handle.
bool isAlive(const WorldObjects& world, const AnyObject& object);
/// The name of an object that is there: the one of its note, else that of its level.
const std::string& nameOf(const WorldData& world, const AnyObject& object);
/// The tags of an object that is there: those of its note, else those of its level.
const std::vector<std::string>& tagsOf(const WorldData& world, const AnyObject& object);
/// The tag of that name; tags.end() if there is none.
std::vector<std::string>::const_iterator findTag(const std::vector<std::string>& tags, std::string_view name);

}  // namespace rubble
