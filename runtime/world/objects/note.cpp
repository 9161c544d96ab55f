#include "runtime/world/objects/note.h"

#include "runtime/core/hash.h"

namespace rubble {

uint64_t Note::hash() const {
    const auto slotOf = [](auto handle) { return uint64_t(handle.bits & 0xffffffu) << 1 | uint64_t(handle.bits != 0); };
    uint64_t hash = hashValue(object.index(), std::visit(slotOf, object));
    const auto addText = [&](const std::string& text) {
        hash = hashBytes(text.data(), text.size(), hashValue(text.size(), hash));
    };
    addText(setsName ? "=" + name : "");
    hash = hashValue(setsTags ? tags.size() + 1 : 0, hash);
    for (const std::string& tag : tags) addText(tag);
    return hashValue(slotOf(root), hashValue(slotOf(parent), hashValue(userValue, hash)));
}

}  // namespace rubble
