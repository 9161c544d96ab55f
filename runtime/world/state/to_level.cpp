#include "runtime/world/state/to_level.h"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "runtime/world/level/references.h"

namespace rubble {
namespace {

/// A name by which a level finds the first object that has it.
std::string uniqueName(std::set<std::string>& used, const std::string& wanted, const char* otherwise) {
    const std::string stem = wanted.empty() ? otherwise : wanted;
    std::string name = stem;
    for (size_t i = 2; used.contains(name); ++i) name = stem + " " + std::to_string(i);
    used.insert(name);
    return name;
}

class LevelWriter {
public:
    explicit LevelWriter(const WorldState& world) : m_world(world) {
        world.notes.forEach([&](NoteHandle, const Note& note) { m_notes.emplace(bitsOf(note.object), &note); });
        m_shapeNames.resize(world.shapes.slotCount());
        m_shapeReferences.resize(world.shapes.slotCount());
        m_groupReferences.resize(world.groups.slotCount());
    }

    Level write() {
        m_level.name = m_world.name;
        m_level.materials = m_world.materials;
        m_level.environment = m_world.environment;
        m_level.bounds = m_world.bounds;
        m_level.locations = m_world.locations;
        m_level.scripts = m_world.scripts;
        nameShapes();
        m_world.bodies.forEach([&](BodyHandle handle, const Body& body) { addBody(handle, body); });
        addGroups();
        addLights();
        addRegions();
        addJoints();
        return std::move(m_level);
    }

private:
    const Note* noteOf(const AnyObject& object) const {
        const auto found = m_notes.find(bitsOf(object));
        return found == m_notes.end() ? nullptr : found->second;
    }
    std::string nameOf(const AnyObject& object, const std::string& given) const {
        const Note* note = noteOf(object);
        return note && note->setsName ? note->name : given;
    }
    std::vector<std::string> tagsOf(const AnyObject& object, const std::vector<std::string>& given) const {
        const Note* note = noteOf(object);
        return note && note->setsTags ? note->tags : given;
    }
    /// Those of an object whose data have none.
    void addTags(TaggedKind kind, size_t number, const AnyObject& object) {
        const std::vector<std::string> tags = tagsOf(object, {});
        if (!tags.empty()) m_level.tags.push_back({kind, uint32_t(number), tags});
    }
    const std::string& referenceToShape(ShapeHandle shape) const {
        static const std::string none;
        return m_world.shapes.find(shape) ? m_shapeReferences[shape.slot()] : none;
    }

    std::set<uint64_t> namedShapes() const {
        std::set<uint64_t> out;
        m_world.joints.forEach([&](JointHandle, const Joint& joint) {
            for (const JointEnd& end : joint.ends) out.insert(end.shape.bits);
        });
        m_world.lights.forEach([&](LightHandle, const Light& light) { out.insert(light.shape.bits); });
        m_world.groups.forEach([&](LightGroupHandle, const LightGroup& group) { out.insert(group.supply.bits); });
        return out;
    }

    /// What others call an object, the next of its kind: its name, or its number where that is another one's name or
    /// none. It gets another name only if one has the number as its name.
    static std::string referenceTo(std::string& name, std::set<std::string>& used, size_t number,
                                   const std::set<std::string>& all, const char* otherwise) {
        const bool isFirst = !name.empty() && used.insert(name).second;
        if (isFirst) return name;
        if (std::string reference = numberReference(number); !all.contains(reference)) return reference;
        return name = uniqueName(used, name, otherwise);
    }

    /// In the order in which a level lists them, because of several of a name it finds the first.
    void nameShapes() {
        const std::set<uint64_t> named = namedShapes();
        std::set<std::string> all, used;
        m_world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
            all.insert(m_shapeNames[handle.slot()] = nameOf(handle, shape.name));
        });
        size_t number = 0;
        m_world.bodies.forEach([&](BodyHandle, const Body& body) {
            for (const ShapeHandle handle : body.shapes) {
                ++number;
                std::string& name = m_shapeNames[handle.slot()];
                if (named.contains(handle.bits))
                    m_shapeReferences[handle.slot()] = referenceTo(name, used, number, all, "shape");
                else
                    used.insert(name);
            }
        });
    }

    void addBody(BodyHandle handle, const Body& body) {
        LevelBody out{nameOf(handle, body.name),
                      body.pose,
                      body.isStatic,
                      body.velocity,
                      body.angularVelocity,
                      {},
                      tagsOf(handle, body.tags),
                      body.gravityScale,
                      body.linearDamping,
                      body.angularDamping};
        for (const ShapeHandle each : body.shapes) {
            const Shape& shape = m_world.shapes.at(each);
            const bool isUnanchored = body.isStatic && shape.anchors.empty();
            out.shapes.push_back({m_shapeNames[each.slot()], shape.local, shape.voxelSize, shape.grid, shape.palette,
                                  isUnanchored ? kNoAnchors : shape.anchors, tagsOf(each, shape.tags), false,
                                  shape.paintColors, shape.strength, shape.loadBearing, shape.collisionLayer,
                                  shape.collisionMask, shape.collisionShape, shape.density, shape.emission});
        }
        m_level.bodies.push_back(std::move(out));
    }

    /// One more than the last slot of a group that is there, or that a palette names.
    size_t groupSlots() const {
        size_t count = 0;
        m_world.groups.forEach(
            [&](LightGroupHandle handle, const LightGroup&) { count = std::max<size_t>(count, handle.slot() + 1); });
        const Palette* last = nullptr;  // shapes that share one follow each other
        m_world.shapes.forEach([&](ShapeHandle, const Shape& shape) {
            if (std::exchange(last, shape.palette.get()) == shape.palette.get()) return;
            for (const PaletteEntry& entry : *last) count = std::max<size_t>(count, entry.lightGroup);
        });
        return count;
    }

    /// Palettes name slots: an empty one has a group without voxels.
    void addGroups() {
        std::set<std::string> all, used;
        m_world.groups.forEach(
            [&](LightGroupHandle handle, const LightGroup& group) { all.insert(nameOf(handle, group.name)); });
        m_level.lightGroups.resize(groupSlots());
        m_world.groups.forEach([&](LightGroupHandle handle, const LightGroup& group) {
            LightGroup& out = m_level.lightGroups[handle.slot()] = group;
            out.name = nameOf(handle, group.name);
            m_groupReferences[handle.slot()] = referenceTo(out.name, used, handle.slot() + 1, all, "light group");
            if (group.supply) out.supplyShape = referenceToShape(group.supply);
            addTags(TaggedKind::LightGroup, handle.slot(), handle);
            out.supply = {};
            out.dark = false;
            if (group.failingSince) out.failingSince = 1;  // step 0 is the level's: it flickers from its start
        });
    }

    void addLights() {
        m_world.lights.forEach([&](LightHandle handle, const Light& light) {
            const bool isInGroup = m_world.groups.find(light.group) != nullptr;
            LevelLight out{light, referenceToShape(light.shape),
                           isInGroup ? m_groupReferences[light.group.slot()] : ""};
            out.light.name = nameOf(handle, light.name);
            out.light.shape = {};
            out.light.group = {};
            m_level.lights.push_back(std::move(out));
            addTags(TaggedKind::Light, m_level.lights.size() - 1, handle);
        });
    }

    void addRegions() {
        m_world.waters.forEach([&](WaterHandle handle, const Water& water) {
            m_level.waters.push_back(water);
            m_level.waters.back().name = nameOf(handle, water.name);
            addTags(TaggedKind::Water, m_level.waters.size() - 1, handle);
        });
        m_world.triggers.forEach([&](TriggerHandle handle, const Trigger& trigger) {
            Trigger& out = m_level.triggers.emplace_back(trigger);
            out.name = nameOf(handle, trigger.name);
            out.tags = tagsOf(handle, trigger.tags);
            out.inside.clear();
        });
        m_world.characters.forEach([&](CharacterHandle handle, const Character& each) {
            m_level.characters.push_back(each);
            m_level.characters.back().name = nameOf(handle, each.name);
            m_level.characters.back().ground = {};
            addTags(TaggedKind::Character, m_level.characters.size() - 1, handle);
        });
    }

    void addJoints() {
        m_world.joints.forEach([&](JointHandle handle, const Joint& joint) {
            LevelJoint out{joint, {}};
            out.joint.name = nameOf(handle, joint.name);
            for (size_t i = 0; i < 2; ++i) {
                out.shapeNames[i] = referenceToShape(joint.ends[i].shape);
                out.joint.ends[i].shape = {};
            }
            out.joint.points.clear();  // a level begins with straight ropes
            m_level.joints.push_back(std::move(out));
            addTags(TaggedKind::Joint, m_level.joints.size() - 1, handle);
        });
    }

    const WorldState& m_world;
    std::unordered_map<uint64_t, const Note*> m_notes;              ///< by the object's handle
    std::vector<std::string> m_shapeNames;                          ///< by slot, as the level has them
    std::vector<std::string> m_shapeReferences, m_groupReferences;  ///< by slot
    Level m_level;
};

}  // namespace

Level toLevel(const WorldState& world) {
    return LevelWriter(world).write();
}

}  // namespace rubble
