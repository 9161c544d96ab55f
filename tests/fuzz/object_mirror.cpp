#include "tests/fuzz/object_mirror.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

void require(bool holds, const char* what, uint64_t handle) {
    if (holds) return;
    std::fprintf(stderr, "the mirror of a world differs: %s of object %llx\n", what, (unsigned long long)handle);
    std::abort();
}

}  // namespace

void ObjectMirror::forget() {
    m_reads = true;
    m_names.clear(), m_tags.clear(), m_values.clear();
}

std::set<uint64_t> ObjectMirror::list(uint32_t kind) const {
    uint32_t count = 0;
    m_api.get_objects(m_world, kind, nullptr, 0, &count);
    std::vector<uint64_t> rows(count);
    if (count) m_api.get_objects(m_world, kind, rows.data(), count, &count);
    return {rows.begin(), rows.end()};
}

void ObjectMirror::step() {
    uint32_t count = 0;
    m_api.get_refusals(m_world, nullptr, 0, &count);
    std::vector<rubble_refusal> refusals(count);
    if (count) m_api.get_refusals(m_world, refusals.data(), count, &count);
    std::set<uint64_t> refused;
    for (const rubble_refusal& each : refusals) refused.insert(each.handle);
    for (auto& [number, kind] : m_kinds) compareKind(number, kind, refused);
    if (m_reads) m_names.clear(), m_tags.clear(), m_values.clear();
    m_reads = false;
    compareNotes();
}

void ObjectMirror::compareKind(uint32_t number, Kind& kind, const std::set<uint64_t>& refused) {
    const std::set<uint64_t> now = list(number);
    if (!m_reads) {
        std::set<uint64_t> expected = kind.live;
        expected.insert(kind.made.begin(), kind.made.end());
        for (const uint64_t each : kind.removed) expected.erase(each);
        for (const uint64_t each : refused) expected.erase(each);
        for (const uint64_t each : expected) require(now.contains(each), "it is gone, the existence", each);
        for (const uint64_t each : kind.removed) require(!now.contains(each), "it is still there, the removal", each);
        require(now.size() <= expected.size() + kind.added, "there are more than were made, the number", number);
        if (!kind.made.empty()) reached("objects made as the mirror has them");
    }
    kind = {.live = now, .made = {}, .removed = {}};
}

void ObjectMirror::compareNotes() {
    char bytes[64];
    uint32_t count = 0;
    std::erase_if(m_names, [&](const auto& each) {
        const auto& [object, name] = each;
        if (m_api.get_name(m_world, object, bytes, sizeof bytes, &count) != RUBBLE_OK) return true;
        require(name == bytes, "the name", object);
        reached("names as the mirror has them");
        return false;
    });
    std::erase_if(m_tags, [&](const auto& each) {
        const auto& [object, tag] = each.first;
        if (m_api.get_tag(m_world, object, tag.c_str(), bytes, sizeof bytes, &count) != RUBBLE_OK) return true;
        require(each.second == (count ? bytes : ""), "the value of a tag", object);
        return false;
    });
    std::erase_if(m_values, [&](const auto& each) {
        uint64_t value = 0;
        if (m_api.get_user_value(m_world, each.first, &value) != RUBBLE_OK) return true;
        require(value == each.second, "the user value", each.first);
        return false;
    });
}

}  // namespace rubble
