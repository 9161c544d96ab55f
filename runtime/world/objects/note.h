#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/core/handle.h"

namespace rubble {

/// The handle of an object of any kind that has a name.
using AnyObject = std::variant<BodyHandle, ShapeHandle, LightHandle, LightGroupHandle, WaterHandle, TriggerHandle,
                               CharacterHandle, JointHandle>;
/// Its bits; 0: of no object.
inline uint64_t bitsOf(const AnyObject& object) {
    return std::visit([](auto handle) { return handle.bits; }, object);
}

/// What edits have said about an object beyond what its struct holds: a side table, so that objects of which nothing
/// was said take no memory for it. There is one note an object at most; it goes with the object. A piece gets a copy of
/// the note of the shape that it came off.
struct Note {
    AnyObject object;
    bool setsName = false;  ///< else the object has the name that its level gave it
    std::string name;
    bool setsTags = false;          ///< else the object has the tags that its level gave it
    std::vector<std::string> tags;  ///< "TAG" or "TAG=VALUE", in the order in which they were set
    uint64_t userValue = 0;         ///< the host's own
    ShapeHandle parent;             ///< of a piece: the shape that it came off, which may be gone; empty: not known
    ShapeHandle root;               ///< of a piece: the first shape of that line, which is no piece

    /// A hash of all of it; handles count by their slots.
    uint64_t hash() const;
};

/// The part of a tag before its "="; all of it if there is none.
inline std::string_view tagName(std::string_view tag) {
    return tag.substr(0, tag.find('='));
}
/// The part of a tag behind its "="; empty if there is none.
inline std::string_view tagValue(std::string_view tag) {
    const size_t end = tag.find('=');
    return end == tag.npos ? std::string_view() : tag.substr(end + 1);
}

}  // namespace rubble
