#include "editor/core/body_copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "editor/core/joints.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

/// Makes one set of copies.
class BodyCopies {
public:
    BodyCopies(Editor& editor, glm::dvec3 by, std::set<std::string>& notes)
        : m_editor(editor), m_world(editor.world()), m_by(by), m_notes(notes) {}

    rubble_body copyBody(rubble_body from) {
        const rubble_body_state state = m_world.get_body_state(from);
        const rubble_body_properties now = m_world.get_body_properties(from);
        rubble_body_settings body{};
        body.flags = state.flags & RUBBLE_BODY_STATIC ? RUBBLE_BODY_STATIC : RUBBLE_BODY_ASLEEP;
        put(body.position, vectorOf(state.position) + m_by);
        put(body.rotation, quaternionOf(state.rotation));
        const rubble_body made = m_world.create_body(body);
        rubble_body_change change{};
        change.body = made;
        change.fields = RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
        change.gravity_scale = now.gravity_scale;
        change.linear_damping = now.linear_damping, change.angular_damping = now.angular_damping;
        m_world.set_body(change);
        for (const rubble_shape_state& each : m_world.get_shape_states(from)) copyShape(each, state, made);
        m_made.emplace_back(from, made);
        return made;
    }
    /// After all bodies: what is on them, or among them.
    void copyRest() {
        for (const auto& [from, to] : m_shapes)
            for (const rubble_light each : m_world.get_objects_of(from, RUBBLE_KIND_LIGHT)) copyLight(each, to);
        m_editor.document().applyNow();
        for (const auto& [from, to] : m_made) copyNotes(from, to);
        copyJoints();
    }

private:
    void copyShape(const rubble_shape_state& from, const rubble_body_state& body, rubble_body to) {
        const glm::dquat inverse = glm::inverse(quaternionOf(body.rotation));
        rubble_shape_settings shape{};
        shape.source = RUBBLE_SHAPE_COPY;
        shape.copied = from.shape;
        shape.body = to;
        for (int a = 0; a < 3; ++a) shape.size[a] = from.size[a];
        put(shape.position, inverse * (vectorOf(from.position) - vectorOf(body.position)));
        put(shape.rotation, inverse * quaternionOf(from.rotation));
        const rubble_shape made = m_world.create_shape(shape);
        m_shapes.emplace(from.shape, made);
        m_made.emplace_back(from.shape, made);
    }
    void copyLight(rubble_light from, rubble_shape shape) {
        rubble_light_settings light = m_world.get_light_settings(from);
        light.light = 0;
        light.shape = shape;
        m_made.emplace_back(from, m_world.create_light(light));
    }
    /// The name and the tags of an object, which are all that its copy has then.
    void copyNotes(uint64_t from, uint64_t to) {
        if (const std::string name = nameOf(m_world, from); !name.empty()) m_world.set_name(to, name.c_str());
        const std::vector<char> all = m_world.get_tags(to);
        for (auto begin = all.begin(); begin != all.end();) {
            const auto end = std::find(begin, all.end(), '\0');
            const std::string tag(begin, std::find(begin, end, '='));
            if (m_world.get_tag(from, tag.c_str()).empty()) m_world.remove_tag(to, tag.c_str());
            begin = end == all.end() ? end : end + 1;
        }
        setTags(m_world, to, m_world.get_tags(from));
    }
    /// None: an end is on what is not copied.
    std::optional<std::pair<rubble_shape, rubble_shape>> endsOf(rubble_joint joint) const {
        const rubble_joint_state state = m_world.get_joint_state(joint);
        rubble_shape ends[2] = {};
        for (int end = 0; end < 2; ++end) {
            if (!state.shapes[end]) continue;
            const auto found = m_shapes.find(state.shapes[end]);
            if (found == m_shapes.end()) return std::nullopt;
            ends[end] = found->second;
        }
        return std::pair(ends[0], ends[1]);
    }
    void copyJoints() {
        std::set<rubble_joint> all;
        for (const auto& [from, to] : m_shapes)
            for (const rubble_joint each : m_world.get_objects_of(from, RUBBLE_KIND_JOINT)) all.insert(each);
        std::vector<std::pair<rubble_joint, JointCopy>> copies;
        for (const rubble_joint each : all) {
            const auto ends = endsOf(each);
            if (!ends) continue;
            if (!hasFrame(m_world, each)) {
                m_notes.insert(shownName(m_world, each) + " is not copied: ropes and steered wheels are not");
                continue;
            }
            JointCopy copy = copyOf(m_world, each);
            copy.settings.shapes[0] = ends->first, copy.settings.shapes[1] = ends->second;
            put(copy.settings.position, vectorOf(copy.settings.position) + m_by);
            copies.emplace_back(m_world.create_joint(copy.settings), std::move(copy));
        }
        m_editor.document().applyNow(true);
        for (const auto& [joint, copy] : copies)
            if (kindOf(m_world, joint) == RUBBLE_KIND_JOINT)
                nameJoint(m_world, joint, copy);
            else
                m_notes.insert(fmt::format("{} is not copied: it finds no voxel to hold on to",
                                           copy.name.empty() ? "a joint" : copy.name.data()));
    }

    Editor& m_editor;
    rubble::World& m_world;
    glm::dvec3 m_by;
    std::set<std::string>& m_notes;
    std::map<rubble_shape, rubble_shape> m_shapes;      ///< their copies
    std::vector<std::pair<uint64_t, uint64_t>> m_made;  ///< the same of all objects but joints
};

}  // namespace

std::vector<rubble_body> copyBodies(Editor& editor, const std::vector<rubble_body>& bodies, glm::dvec3 by,
                                    std::set<std::string>& notes) {
    BodyCopies copies(editor, by, notes);
    std::vector<rubble_body> made;
    for (const rubble_body each : bodies) made.push_back(copies.copyBody(each));
    copies.copyRest();
    return made;
}

}  // namespace editor
