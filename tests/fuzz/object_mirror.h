#pragma once
#include <rubble/rubble.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace rubble {

/// What a host that remembers its calls may conclude about names, tags and values of objects, and about which light
/// groups, waters, triggers and characters there are. Each check aborts, with a reason, where the world says something
/// else. Tell it of calls that were accepted alone.
class ObjectMirror {
public:
    /// Both must outlive it.
    ObjectMirror(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) {}

    /// From the end of the next step on all is read again: the world was loaded, or goes back in time.
    void forget();
    /// A call of set_name().
    void setName(uint64_t object, const char* name) { m_names[object] = name; }
    /// A call of set_tag().
    void setTag(uint64_t object, const char* tag, const char* value) { m_tags[{object, tag}] = value ? value : ""; }
    /// A call of remove_tag().
    void removeTag(uint64_t object, const char* tag) { m_tags[{object, tag}] = ""; }
    /// A call of set_user_value().
    void setUserValue(uint64_t object, uint64_t value) { m_values[object] = value; }
    /// A call that makes an object of a kind, RUBBLE_KIND_..., and gives its handle.
    void made(uint32_t kind, uint64_t handle) { m_kinds.at(kind).made.insert(handle); }
    /// A call that makes one and does not.
    void added(uint32_t kind) { ++m_kinds.at(kind).added; }
    /// A call that removes one.
    void removed(uint32_t kind, uint64_t handle) { m_kinds.at(kind).removed.insert(handle); }
    /// Compares after a step.
    void step();

private:
    struct Kind {
        std::set<uint64_t> live, made, removed;  ///< the last two: by calls since the last step
        size_t added = 0;
    };
    std::set<uint64_t> list(uint32_t kind) const;
    void compareKind(uint32_t number, Kind& kind, const std::set<uint64_t>& refused);
    void compareNotes();

    const rubble_api& m_api;
    rubble_world m_world;
    bool m_reads = true;  ///< all is to be read again
    std::map<uint32_t, Kind> m_kinds = {
        {RUBBLE_KIND_LIGHT_GROUP, {}}, {RUBBLE_KIND_WATER, {}}, {RUBBLE_KIND_TRIGGER, {}}, {RUBBLE_KIND_CHARACTER, {}}};
    std::map<uint64_t, std::string> m_names;
    std::map<std::pair<uint64_t, std::string>, std::string> m_tags;  ///< "": the tag has no value, or is not there
    std::map<uint64_t, uint64_t> m_values;
};

}  // namespace rubble
