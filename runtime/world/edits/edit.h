#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/brush.h"
#include "runtime/world/edits/body_edits.h"
#include "runtime/world/edits/create_edits.h"
#include "runtime/world/edits/joint_edits.h"
#include "runtime/world/edits/light_edits.h"
#include "runtime/world/edits/material_edits.h"
#include "runtime/world/edits/note_edits.h"
#include "runtime/world/edits/shape_edits.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/collision_shape.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"
#include "runtime/world/settings/paint_settings.h"
#include "runtime/world/settings/world_settings.h"

namespace rubble {

/// Removes the voxels inside a sphere, box or capsule, with a radius for each hardness class. World space, metres.
struct CarveEdit {
    BrushKind kind = BrushKind::Sphere;
    glm::dvec3 position{0.0};               ///< sphere and box: centre; capsule: one end
    glm::dvec3 end{0.0};                    ///< capsule: other end
    glm::dvec3 halfSize{0.0};               ///< box
    glm::dquat rotation{1, 0, 0, 0};        ///< box
    std::array<double, 3> radii{};          ///< for soft, medium, hard voxels, none above the one before; box: unused
    Hardness maxHardness = Hardness::Hard;  ///< box: the hardest class that it removes
    ShapeHandle shape;                      ///< empty: all in reach
    Tool tool = Tool::Any;                  ///< removes only materials that this tool breaks
};

/// Breaks the voxels inside a sphere out of their shapes, as fragments and dust in the style of each material. Glass
/// breaks by the whole pane.
struct BreakEdit {
    glm::dvec3 position{0.0};
    std::array<double, 3> radii{};  ///< metres, for soft, medium and hard materials
    Tool tool = Tool::Any;
    uint32_t seed = 0;  ///< decides where the cracks run
    ShapeHandle shape;  ///< empty: all in reach
};

/// Breaks, paints soot, and pushes bodies away from the centre.
struct ExplodeEdit {
    glm::dvec3 position{0.0};
    double size = 1.0;     ///< 0.5 to 4, as in Teardown: radii are 1.0, 0.7 and 0.4 of it, in metres
    double impulse = 0.0;  ///< N s on a body at the centre; 0: by size. No body gets faster than 9 m/s times size
};

/// Blends the colours of voxels at the surface toward a paint colour, a little each time: sprays, soot, skid marks.
struct PaintEdit {
    glm::dvec3 position{0.0};
    double radius = 0.5;                      ///< metres
    std::array<uint8_t, 3> color{255, 0, 0};  ///< sRGB
    uint8_t strength = 64;                    ///< weight of the paint in the blend, of 255
    uint8_t probability = 255;                ///< share of voxels painted at the rim, of 255; at the centre all are
    uint32_t seed = 0;
    uint8_t falloff = 255;                ///< share of the strength that is left at the rim, of 255
    PaintMode mode = PaintMode::Default;  ///< blend or layer
    BrushKind kind = BrushKind::Sphere;   ///< or Capsule: a stroke, as of a skid
    glm::dvec3 end{0.0};                  ///< capsule: its other end
    ShapeHandle shape;                    ///< empty: all
};

/// Loads a shape as a whole by an impact, while StressSettings are on: it breaks where it is weakest, not only where it
/// is hit. Standing shapes carry the load to their anchors; pieces balance it by their inertia.
struct ImpactLoadEdit {
    ShapeHandle shape;
    glm::dvec3 position{0.0};
    glm::dvec3 impulse{0.0};  ///< N s, on the shape
};

/// Pushes a free body at a point, after the other edits of the step have split what they split.
struct ImpulseEdit {
    BodyHandle body;
    glm::dvec3 position{0.0};
    glm::dvec3 impulse{0.0};  ///< N s
};

/// Replaces the world's settings, so that a change of them is part of a recording.
struct SettingsEdit {
    WorldSettings settings;
};

/// Replaces WorldSettings::bounds.
struct SetBoundsEdit {
    BoundsSettings bounds;
};

enum class HistoryAction : uint8_t { Mark, Undo, Redo };
/// Undo and redo; see UndoHistory. They happen before the other edits of their step.
struct HistoryEdit {
    HistoryAction action = HistoryAction::Mark;
};

/// Heats the bricks in a sphere, each by its share of the surface there. What gets hot enough ignites by itself.
struct HeatEdit {
    glm::dvec3 position{0.0};
    double radius = 0.5;  ///< metres
    double joules = 0.0;  ///< in all; wood needs some 300 kJ for each square metre that lies in the sphere
    bool ignite = false;  ///< ignites what can burn at once
    ShapeHandle shape;    ///< empty: all
};
/// Ignites what can burn within `radius` metres of a place.
inline HeatEdit spawnFire(glm::dvec3 position, double radius = 0.25) {
    return {.position = position, .radius = radius, .ignite = true};
}

/// Puts fires out and wets the bricks there: wet bricks take no heat.
struct ExtinguishEdit {
    glm::dvec3 position{0.0};
    double radius = 1.0;      ///< metres
    double wetSeconds = 0.0;  ///< 0: nothing gets wet, as with carbon dioxide
};
/// A hose or a bucket of water: puts fires out and wets for 20 s.
inline ExtinguishEdit pourWater(glm::dvec3 position, double radius) {
    return {.position = position, .radius = radius, .wetSeconds = 20.0};
}

/// Puts out the fires in a box along the world's axes.
struct RemoveFiresEdit {
    glm::dvec3 low{0.0}, high{0.0};
};

/// Gives a shape another collision layer and mask: two shapes collide if each one's layer is in the other's mask.
struct SetCollisionFilterEdit {
    ShapeHandle shape;
    uint8_t layer = 1, mask = 255;  ///< bits
};

/// Says what physics takes a shape for where it touches others: see CollisionShape.
struct SetCollisionShapeEdit {
    ShapeHandle shape;
    CollisionShape kind = CollisionShape::Voxels;
};

/// Adds a body of water; FrameChanges::waters names it.
struct AddWaterEdit {
    Water water;
};
/// Erases a body of water.
struct RemoveWaterEdit {
    WaterHandle water;
};
/// Adds a trigger; FrameChanges::triggers names it. Bodies inside are found in the same step.
struct AddTriggerEdit {
    Trigger trigger;
};
/// Erases a trigger.
struct RemoveTriggerEdit {
    TriggerHandle trigger;
};
/// Adds a character; FrameChanges::characters names it.
struct AddCharacterEdit {
    Character character;
};
/// Erases a character.
struct RemoveCharacterEdit {
    CharacterHandle character;
};
/// Sets what a character wants from now on.
struct MoveCharacterEdit {
    CharacterHandle character;
    glm::dvec3 wish{0.0};  ///< velocity wished for, m/s, world; the vertical part counts in water only
    bool jump = false;     ///< in this step, if it stands or swims
    bool crouch = false;
};
/// Puts a character somewhere else.
struct TeleportCharacterEdit {
    CharacterHandle character;
    glm::dvec3 position{0.0};  ///< of the feet, metres, world
    glm::dvec3 velocity{0.0};  ///< m/s
};

/// The kinds of edits.
using AnyEdit =
    std::variant<CarveEdit, ExplodeEdit, PaintEdit, ImpulseEdit, SettingsEdit, HistoryEdit, HeatEdit, ExtinguishEdit,
                 RemoveFiresEdit, BreakEdit, SplitShapeEdit, MergeShapeEdit, TrimShapeEdit, ResizeShapeEdit,
                 ImpactLoadEdit, SetCollisionFilterEdit, AddWaterEdit, RemoveWaterEdit, AddTriggerEdit,
                 RemoveTriggerEdit, AddCharacterEdit, RemoveCharacterEdit, MoveCharacterEdit, TeleportCharacterEdit,
                 AddJointEdit, RemoveJointEdit, SetJointMotorEdit, DetachJointEdit, GrabEdit, ReleaseEdit, DriveEdit,
                 SetEnvironmentEdit, SetLightEdit, AddLightEdit, RemoveLightEdit, SetBoundsEdit, SetCollisionShapeEdit,
                 SetBodyEdit, DestroyBodyEdit, WriteVoxelsEdit, DestroyShapeEdit, CreateBodyEdit, CreateShapeEdit,
                 SetNameEdit, SetTagEdit, RemoveTagEdit, SetUserValueEdit, SetPaletteEdit, SetMaterialsEdit,
                 SetShapeEdit, SetLightGroupEdit, CreateLightGroupEdit, ConstrainEdit, SetScriptsEdit>;
/// One command for the World: any of the kinds above. It is a class of its own so that its copies, moves and
/// destructor, which are long over so many kinds, are compiled once (edit.cpp) and not wherever a list of edits is
/// held.
struct Edit : AnyEdit {
    using AnyEdit::AnyEdit;
    /// Of an edit that makes something: the handle that it gets, which is reserved (SlotMap::reserve()); empty: any.
    AnyHandle made;
    Edit();                 ///< an empty carve, for containers and readers
    Edit(const Edit&);      ///< compiled once
    Edit(Edit&&) noexcept;  ///< compiled once
    Edit& operator=(const Edit&);
    Edit& operator=(Edit&&) noexcept;
    ~Edit();
};
/// Edits in the order in which the step applies them.
using Edits = std::vector<Edit>;

/// Collects edits for the next step. Owned by the main thread.
class EditQueue {
public:
    /// Adds an edit behind the others.
    void push(Edit edit) { m_edits.push_back(std::move(edit)); }
    /// Makes room for so many more: they are pushed without taking memory.
    void makeRoom(size_t count) {
        const size_t needed = m_edits.size() + count;
        if (needed > m_edits.capacity()) m_edits.reserve(std::max(needed, 2 * m_edits.capacity()));
    }
    /// Adds edits behind the others, in their order.
    void push(Edits edits) {
        if (m_edits.empty())
            m_edits = std::move(edits);
        else
            m_edits.insert(m_edits.end(), edits.begin(), edits.end());
    }
    /// Hands over all edits and forgets them.
    Edits take() { return std::exchange(m_edits, {}); }
    /// Uses the memory of edits that are done for those of the next step, unless it is much more than they needed:
    /// taking memory costs more than queuing the edits.
    void recycle(Edits done) {
        constexpr size_t kAlwaysKept = 256, kMaxUnusedRatio = 8;
        if (!m_edits.empty() || done.capacity() > std::max(kAlwaysKept, kMaxUnusedRatio * done.size())) return;
        done.clear();
        m_edits = std::move(done);
    }
    /// The edits that wait.
    const Edits& waiting() const { return m_edits; }
    /// Whether no edit waits.
    bool empty() const { return m_edits.empty(); }

private:
    Edits m_edits;
};

}  // namespace rubble
