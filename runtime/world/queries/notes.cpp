#include "runtime/world/queries/notes.h"

#include <algorithm>

namespace rubble {

bool isAlive(const WorldObjects& world, const AnyObject& object) {
    return std::visit([&](auto handle) { return mapOf<decltype(handle)>(world).find(handle) != nullptr; }, object);
}

const std::string& nameOf(const WorldData& world, const AnyObject& object) {
    const Note* note = world.findNote(bitsOf(object));
    if (note && note->setsName) return note->name;
    const auto given = [&](auto handle) -> const std::string& {
        return mapOf<decltype(handle)>(world).at(handle).name;
    };
    return std::visit(given, object);
}

const std::vector<std::string>& tagsOf(const WorldData& world, const AnyObject& object) {
    static const std::vector<std::string> none;
    const Note* note = world.findNote(bitsOf(object));
    if (note && note->setsTags) return note->tags;
    const auto given = [&](auto handle) -> const std::vector<std::string>& {
        const auto& value = mapOf<decltype(handle)>(world).at(handle);
        if constexpr (requires { value.tags; })
            return value.tags;
        else
            return none;
    };
    return std::visit(given, object);
}

std::vector<std::string>::const_iterator findTag(const std::vector<std::string>& tags, std::string_view name) {
    return std::find_if(tags.begin(), tags.end(), [&](const std::string& tag) { return tagName(tag) == name; });
}

}  // namespace rubble
