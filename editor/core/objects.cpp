// Which objects the values of commands name.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "editor/core/editor.h"

namespace editor {
namespace {

using Kinds = std::initializer_list<uint32_t>;

bool contains(Kinds kinds, uint32_t kind) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::string namesOf(Kinds kinds) {
    std::string all;
    for (const uint32_t kind : kinds) all += (all.empty() ? "" : " or ") + std::string(nameOfKind(kind));
    return all;
}

void add(std::vector<uint64_t>& to, uint64_t object) {
    if (std::find(to.begin(), to.end(), object) == to.end()) to.push_back(object);
}

/// An object as one of these kinds: itself, its shapes or its body.
void addAs(const rubble::World& world, uint64_t object, Kinds kinds, std::vector<uint64_t>& to) {
    const int kind = kindOf(world, object);
    if (kind >= 0 && contains(kinds, uint32_t(kind))) return add(to, object);
    if (kind == RUBBLE_KIND_BODY && contains(kinds, RUBBLE_KIND_SHAPE))
        for (const uint64_t shape : world.get_objects_of(object, RUBBLE_KIND_SHAPE)) add(to, shape);
    if (kind == RUBBLE_KIND_SHAPE && contains(kinds, RUBBLE_KIND_BODY)) add(to, world.get_shape_state(object).body);
}

void addNamed(const rubble::World& world, const std::string& name, Kinds kinds, std::vector<uint64_t>& to) {
    const size_t before = to.size();
    for (const uint32_t kind : kinds)
        for (const uint64_t each : world.find_by_name(kind, name.c_str())) add(to, each);
    if (to.size() != before) return;
    for (const uint32_t kind : {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE})
        for (const uint64_t each : world.find_by_name(kind, name.c_str())) addAs(world, each, kinds, to);
}

/// "NAME" or "NAME=VALUE".
void addTagged(const rubble::World& world, const std::string& tag, Kinds kinds, std::vector<uint64_t>& to) {
    const size_t equals = tag.find('=');
    const std::string name = tag.substr(0, equals), value = equals == tag.npos ? "" : tag.substr(equals + 1);
    for (uint32_t kind = RUBBLE_KIND_BODY; kind <= RUBBLE_KIND_JOINT; ++kind)
        for (const uint64_t each : world.find_by_tag(kind, name.c_str(), equals == tag.npos ? nullptr : value.c_str()))
            addAs(world, each, kinds, to);
}

template <class Read>
bool isThere(Read&& read) {
    try {
        read();
        return true;
    } catch (const rubble::Error&) {
        return false;
    }
}

}  // namespace

bool isLocked(const rubble::World& world, uint64_t object) {
    if (!world.get_tag(object, kLockedTag).empty()) return true;
    return kindOf(world, object) == RUBBLE_KIND_SHAPE &&
           !world.get_tag(world.get_shape_state(object).body, kLockedTag).empty();
}

int kindOf(const rubble::World& world, uint64_t handle) {
    if (isThere([&] { world.get_body_state(handle); })) return RUBBLE_KIND_BODY;
    if (isThere([&] { world.get_shape_state(handle); })) return RUBBLE_KIND_SHAPE;
    if (isThere([&] { world.get_light_settings(handle); })) return RUBBLE_KIND_LIGHT;
    if (isThere([&] { world.get_joint_state(handle); })) return RUBBLE_KIND_JOINT;
    if (isThere([&] { world.get_light_group(handle); })) return RUBBLE_KIND_LIGHT_GROUP;
    for (const uint32_t kind : {RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER, RUBBLE_KIND_CHARACTER}) {
        const std::vector<uint64_t> all = world.get_objects(kind);
        if (std::find(all.begin(), all.end(), handle) != all.end()) return int(kind);
    }
    return -1;
}

const char* nameOfKind(uint32_t kind) {
    static constexpr const char* kNames[] = {"body",  "shape",   "light",     "light group",
                                             "water", "trigger", "character", "joint"};
    return kind < std::size(kNames) ? kNames[kind] : "object";
}

std::string nameOf(const rubble::World& world, uint64_t handle) {
    const std::vector<char> text = world.get_name(handle);
    return text.empty() ? "" : text.data();
}

std::string shownName(const rubble::World& world, uint64_t object) {
    std::string name = nameOf(world, object);
    if (name.empty() && kindOf(world, object) == RUBBLE_KIND_SHAPE)
        name = nameOf(world, world.get_shape_state(object).body);
    return name.empty() ? fmt::format("#{}", object) : name;
}

void Editor::giveName(const Arguments& arguments, uint64_t object) {
    const std::string& name = arguments.text("name");
    if (std::ranges::any_of(name, [](unsigned char c) { return std::iscntrl(c); }))
        arguments.refuse("name", "no control characters, as of a terminal, found some");
    const bool isWord = name == "all" || name == "selected" || name == "world";
    if (isWord || name.find(',') != name.npos || name.starts_with("#") || name.starts_with("tag:"))
        arguments.refuse("name", fmt::format("no comma, no # or tag: at its beginning, and none of all, selected and "
                                             "world, by which no command would find it, found '{}'",
                                             name));
    if (!name.empty()) world().set_name(object, name.c_str());
}

std::vector<uint64_t> Editor::objects(const Arguments& arguments, std::string_view parameter, Kinds kinds) const {
    const std::string& text = arguments.text(parameter);
    const Kind kind = arguments.command().kind;
    const bool isEdit = kind == Kind::Edit || (kind == Kind::Tool && !m_document.isPlaying());
    // reload_models leaves them alone itself, and names them
    const bool takesLocked = arguments.command().name == "unlock" || arguments.command().name == "reload_models";
    std::vector<uint64_t> all;
    for (size_t begin = 0; begin <= text.size();) {
        const std::string part = partAt(text, begin, kinds);
        if (part.empty()) arguments.refuse(parameter, fmt::format("names, found an empty one in '{}'", text));
        std::vector<uint64_t> found = objectsOf(part, kinds);
        if (found.empty())
            arguments.refuse(parameter,
                             fmt::format("a {}, found {} by '{}'", namesOf(kinds), foundInstead(part), part));
        if (isEdit && !takesLocked) {
            const std::string first = nameOf(m_document.world(), found.front());
            std::erase_if(found, [&](uint64_t each) { return isLocked(m_document.world(), each); });
            if (found.empty())
                arguments.refuse(parameter, fmt::format("what is not locked, found '{}'{}: unlock it first", part,
                                                        first.empty() || first == part ? "" : ", such as " + first));
        }
        for (const uint64_t each : found) add(all, each);
        begin += part.size() + 1;
    }
    return all;
}

/// What begins at a place of a value: up to the next comma. The value of a tag may have commas itself, as a file's
/// name: it is the longest one that there is.
std::string Editor::partAt(const std::string& text, size_t begin, Kinds kinds) const {
    const size_t comma = std::min(text.find(',', begin), text.size());
    if (text.compare(begin, 4, "tag:") != 0) return text.substr(begin, comma - begin);
    size_t end = text.size();
    while (end > comma && objectsOf(text.substr(begin, end - begin), kinds).empty()) end = text.rfind(',', end - 1);
    return text.substr(begin, end - begin);
}

std::string Editor::foundInstead(const std::string& part) const {
    const std::vector<uint64_t> others =
        part == "all"
            ? std::vector<uint64_t>{}
            : objectsOf(part, {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP,
                               RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER, RUBBLE_KIND_CHARACTER, RUBBLE_KIND_JOINT});
    const int kind = others.empty() ? -1 : kindOf(m_document.world(), others.front());
    return kind < 0 ? "none" : fmt::format("a {}", nameOfKind(uint32_t(kind)));
}

std::vector<uint64_t> Editor::objectsOf(const std::string& part, Kinds kinds) const {
    const rubble::World& all = m_document.world();
    std::vector<uint64_t> found;
    uint64_t handle = 0;
    if (part == "selected") {
        for (const uint64_t each : m_selection.objects) addAs(all, each, kinds, found);
    } else if (part == "all") {
        for (const uint32_t kind : kinds)
            for (const uint64_t each : all.get_objects(kind)) add(found, each);
    } else if (part.starts_with("tag:")) {
        addTagged(all, part.substr(4), kinds, found);
    } else if (part.starts_with("#") &&
               std::from_chars(part.data() + 1, part.data() + part.size(), handle).ptr == part.data() + part.size()) {
        addAs(all, handle, kinds, found);
    } else {
        addNamed(all, part, kinds, found);
    }
    return found;
}

uint64_t Editor::object(const Arguments& arguments, std::string_view parameter, Kinds kinds) const {
    const std::vector<uint64_t> found = objects(arguments, parameter, kinds);
    if (found.size() > 1) {
        std::string all;
        for (size_t i = 0; i < std::min<size_t>(found.size(), 4); ++i) all += fmt::format(" #{}", found[i]);
        arguments.refuse(parameter, fmt::format("one {}, found {} by '{}':{}{}", namesOf(kinds), found.size(),
                                                arguments.text(parameter), all, found.size() > 4 ? " ..." : ""));
    }
    return found.front();
}

}  // namespace editor
