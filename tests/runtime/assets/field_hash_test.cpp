#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "runtime/assets/state_fields.h"
#include "runtime/world/queries/world_hash.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

/// An archive (fields.h) that changes one field of an object, the given one of all in order: numbers, texts, choices.
class ChangeField {
public:
    static constexpr bool kIsBinary = true;
    explicit ChangeField(int number) : m_left(number) {}

    template <class T>
    void operator()(const char* name, T& value) {
        const std::string outer = m_path;
        if (!m_isDone) m_path += std::string(".") + name;
        visit(value);
        if (!m_isDone) m_path = outer;
    }
    /// Whether there was such a field.
    bool isDone() const { return m_isDone; }
    /// The field that it changed.
    const std::string& path() const { return m_path; }

private:
    bool isIt() {
        m_isDone = m_isDone || m_left == 0;
        return m_left-- == 0;
    }
    template <class T>
    void visit(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            if (isIt()) value = !value;
        } else if constexpr (std::is_arithmetic_v<T>) {
            if (isIt()) value = T(value + 1);
        } else if constexpr (std::is_enum_v<T>) {
            if (isIt()) value = T((size_t(value) + 1) % enumNames(value).size());
        } else if constexpr (std::is_same_v<T, std::string>) {
            if (isIt()) value += "x";
        } else if constexpr (HasFields<T>) {
            fields(*this, value);
        }
    }
    template <class T>
    void visit(glm::vec<3, T>& v) {
        visit(v.x), visit(v.y), visit(v.z);
    }
    void visit(glm::dquat& q) { visit(q.w), visit(q.x), visit(q.y), visit(q.z); }
    template <class T, size_t kSize>
    void visit(std::array<T, kSize>& values) {
        for (T& value : values) visit(value);
    }

    int m_left;
    bool m_isDone = false;
    std::string m_path;
};

/// What is in no hash, and what it is beside that.
const std::set<std::string> kNotHashed = {
    "body.name",              // as the level has it: edits name by notes
    "shape.name",             // the same
    "shape.known_connected",  // what a search has found, of the voxels
    "light.name",             // as the level has it
    "group.name",             // the same
    "group.supply_shape",     // the same: the supply's handle counts
    "water.name",             // the same
    "trigger.name",           // the same
    "character.name",         // the same
    "joint.name",             // the same
    "water.color",            // nothing happens by how water looks
    "water.clarity",          // the same
    "water.waves.height",     // the same
    "water.waves.length",     // the same
    "water.waves.speed",      // the same
    "water.waves.direction",  // the same
    "joint.rope.red",         // nothing happens by how a rope looks
    "joint.rope.green",       // the same
    "joint.rope.blue",        // the same
    "settings.undo_marks",    // the host's
};

/// Each field of an object that `at` finds in a state, changed alone, gives another hash.
template <class At>
void expectAllHashed(const WorldState& state, const std::string& kind, int atLeast, At&& at) {
    std::set<uint64_t> seen = {resolvedHash(state)};
    int changed = 0;
    for (int number = 0;; ++number, ++changed) {
        WorldState other = state;
        ChangeField change(number);
        fields(change, at(other));
        if (!change.isDone()) break;
        const std::string path = kind + change.path();
        EXPECT_EQ(seen.insert(resolvedHash(other)).second, !kNotHashed.contains(path)) << path;
    }
    EXPECT_GE(changed, atLeast) << kind;
}

TEST(FieldHash, EachFieldThatIsSavedIsHashed) {
    WorldState state = World().state();
    const BodyHandle body = state.bodies.insert({});
    const ShapeHandle shape = state.shapes.insert({.body = body, .palette = std::make_shared<const Palette>()});
    state.bodies.at(body).shapes = {shape};
    const LightHandle light = state.lights.insert({});
    const LightGroupHandle group = state.groups.insert({});
    const WaterHandle water = state.waters.insert({});
    const TriggerHandle trigger = state.triggers.insert({});
    const CharacterHandle character = state.characters.insert({});
    const JointHandle joint = state.joints.insert({});
    const NoteHandle note = state.notes.insert({.object = body, .setsName = true});
    expectAllHashed(
        state, "body", 20, [&](WorldState & s) -> auto& { return s.bodies.at(body); });
    expectAllHashed(
        state, "shape", 15, [&](WorldState & s) -> auto& { return s.shapes.at(shape); });
    expectAllHashed(
        state, "light", 15, [&](WorldState & s) -> auto& { return s.lights.at(light); });
    expectAllHashed(
        state, "group", 8, [&](WorldState & s) -> auto& { return s.groups.at(group); });
    expectAllHashed(
        state, "water", 5, [&](WorldState & s) -> auto& { return s.waters.at(water); });
    expectAllHashed(
        state, "trigger", 8, [&](WorldState & s) -> auto& { return s.triggers.at(trigger); });
    expectAllHashed(
        state, "character", 15, [&](WorldState & s) -> auto& { return s.characters.at(character); });
    expectAllHashed(
        state, "joint", 40, [&](WorldState & s) -> auto& { return s.joints.at(joint); });
    expectAllHashed(
        state, "note", 4, [&](WorldState & s) -> auto& { return s.notes.at(note); });
    expectAllHashed(
        state, "material", 10, [](WorldState & s) -> auto& { return s.materials.materials[3]; });
    expectAllHashed(
        state, "environment", 30, [](WorldState & s) -> auto& { return s.environment; });
    expectAllHashed(
        state, "settings", 35, [](WorldState & s) -> auto& { return s.settings; });
}

}  // namespace
}  // namespace rubble
