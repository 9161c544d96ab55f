#pragma once
#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/brush.h"
#include "runtime/world/edits/joint_edits.h"
#include "runtime/world/edits/light_edits.h"
#include "runtime/world/edits/shape_edits.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"
#include "runtime/world/settings/paint_settings.h"
#include "runtime/world/settings/world_settings.h"

namespace rubble {

/// Removes what is inside, class by class. World space, metres. Touches every shape its bounds meet, or only `shape`.
struct CarveEdit {
    BrushKind kind = BrushKind::Sphere;
    glm::dvec3 position{0.0};         ///< sphere and box: centre; capsule: one end
    glm::dvec3 end{0.0};              ///< capsule: other end
    glm::dvec3 halfSize{0.0};         ///< box
    glm::dquat rotation{1, 0, 0, 0};  ///< box
    std::array<double, 3> radii{};  ///< soft, medium, hard (MakeHole's r0 >= r1 >= r2); box: unused, hardnessLimit says
    Hardness hardnessLimit = Hardness::Hard;  ///< box: the hardest class it removes
    ShapeHandle shape;                        ///< empty: all
    Tool tool = Tool::Any;                    ///< removes only what this tool breaks
};

/// Breaks what is inside a sphere out of its shapes, as fragments and dust in the style of each material. Glass goes by
/// the whole pane.
struct BreakEdit {
    glm::dvec3 position{0.0};
    std::array<double, 3> radii{};  ///< metres, for soft, medium and hard materials
    Tool tool = Tool::Any;
    uint32_t seed = 0;  ///< of where the cracks run
    ShapeHandle shape;  ///< empty: all
};

/// Breaks, scorches and pushes: bodies in reach get an impulse away from the centre.
struct ExplodeEdit {
    glm::dvec3 position{0.0};
    double size = 1.0;     ///< 0.5 to 4, as in the reference game: radii 1.0, 0.7 and 0.4 of it, in metres
    double impulse = 0.0;  ///< N s on a body at the centre; 0: size decides
};

/// Blends the colours of voxels at the surface toward a paint, a step a call: sprays, soot, skid marks.
struct PaintEdit {
    glm::dvec3 position{0.0};
    double radius = 0.5;                      ///< metres
    std::array<uint8_t, 3> color{255, 0, 0};  ///< sRGB
    uint8_t strength = 64;                    ///< share of the way to the paint in one step, of 255
    uint8_t probability = 255;  ///< share of voxels editState at the rim, of 255; the centre is always editState
    uint32_t seed = 0;
    uint8_t falloff = 255;                ///< share of the strength that is left at the rim, of 255
    PaintMode mode = PaintMode::Default;  ///< blend or layer
    BrushKind kind = BrushKind::Sphere;   ///< or Capsule: a stroke, as of a skid
    glm::dvec3 end{0.0};                  ///< capsule: its other end
    ShapeHandle shape;                    ///< empty: all
};

/// A blow to a shape as a whole, while StressSettings are on: it breaks where it is weakest, not only where it is hit.
/// What stands carries the blow to its anchors, what flies carries it to its own mass.
struct ImpactLoadEdit {
    ShapeHandle shape;
    glm::dvec3 position{0.0};
    glm::dvec3 impulse{0.0};  ///< N s, on the shape
};

struct ImpulseEdit {
    BodyHandle body;
    glm::dvec3 position{0.0};
    glm::dvec3 impulse{0.0};  ///< N s
};

/// Replaces the world's settings, so that a change of a budget is part of the log.
struct SettingsEdit {
    WorldSettings settings;
};

/// Undo and redo; see UndoHistory. They happen before the other edits of their step.
enum class HistoryAction : uint8_t { Mark, Undo, Redo };
struct HistoryEdit {
    HistoryAction action = HistoryAction::Mark;
};

/// Heats what is within a sphere: each brick by its share of the surface there. What gets hot enough burns by itself.
struct HeatEdit {
    glm::dvec3 position{0.0};
    double radius = 0.5;  ///< metres
    double joules = 0.0;  ///< in all; a square metre of wood wants about 200 kJ
    bool ignite = false;  ///< lights what can updateFires at once
    ShapeHandle shape;    ///< empty: all
};
/// A fire at a place, if something there burns.
inline HeatEdit spawnFire(glm::dvec3 position, double radius = 0.25) {
    return {.position = position, .radius = radius, .ignite = true};
}

/// Puts fires out and wets what is there: neither heat nor fire get at it for a while.
struct ExtinguishEdit {
    glm::dvec3 position{0.0};
    double radius = 1.0;      ///< metres
    double wetSeconds = 0.0;  ///< 0: nothing gets wet, as with carbon dioxide
};
/// What a hose or a bucket does.
inline ExtinguishEdit pourWater(glm::dvec3 position, double radius) {
    return {.position = position, .radius = radius, .wetSeconds = 20.0};
}

/// Puts out the fires in a box along the world's axes.
struct RemoveFiresEdit {
    glm::dvec3 low{0.0}, high{0.0};
};

/// Gives a shape another collision layer and mask: two shapes touch if each one's layer is in the other's mask.
struct SetCollisionEdit {
    ShapeHandle shape;
    uint8_t layer = 1, mask = 255;  ///< bits
};

struct AddWaterEdit {
    Water water;
};
struct RemoveWaterEdit {
    WaterHandle water;
};
/// Who is inside is found in the same step.
struct AddTriggerEdit {
    Trigger trigger;
};
struct RemoveTriggerEdit {
    TriggerHandle trigger;
};
struct AddCharacterEdit {
    Character character;
};
struct RemoveCharacterEdit {
    CharacterHandle character;
};
/// What a character wants from now on.
struct MoveCharacterEdit {
    CharacterHandle character;
    glm::dvec3 wish{0.0};  ///< m/s, world; the vertical part counts in water only
    bool jump = false;     ///< in this step, if it stands or swims
    bool crouch = false;
};
/// Puts a character somewhere else.
struct PlaceCharacterEdit {
    CharacterHandle character;
    glm::dvec3 position{0.0}, velocity{0.0};  ///< of the feet
};

using AnyEdit =
    std::variant<CarveEdit, ExplodeEdit, PaintEdit, ImpulseEdit, SettingsEdit, HistoryEdit, HeatEdit, ExtinguishEdit,
                 RemoveFiresEdit, BreakEdit, SplitShapeEdit, MergeShapeEdit, TrimShapeEdit, ResizeShapeEdit,
                 ImpactLoadEdit, SetCollisionEdit, AddWaterEdit, RemoveWaterEdit, AddTriggerEdit, RemoveTriggerEdit,
                 AddCharacterEdit, RemoveCharacterEdit, MoveCharacterEdit, PlaceCharacterEdit, AddJointEdit,
                 RemoveJointEdit, SetJointMotorEdit, DetachJointEdit, GrabEdit, ReleaseEdit, DriveEdit,
                 SetEnvironmentEdit, SetLightEdit, AddLightEdit, RemoveLightEdit>;
/// One command for the World: any of the kinds above. It is a class of its own so that its copies, moves and
/// destructor, which are long over so many kinds, are compiled once (edit.cpp) and not wherever a list of edits is
/// held.
struct Edit : AnyEdit {
    using AnyEdit::AnyEdit;
    Edit();  ///< an empty carve, for containers and readers
    Edit(const Edit&);
    Edit(Edit&&) noexcept;
    Edit& operator=(const Edit&);
    Edit& operator=(Edit&&) noexcept;
    ~Edit();
};
/// Edits in the order in which the step applies them.
using Edits = std::vector<Edit>;

/// Where a host leaves edits for the next step. [main-thread]
class EditQueue {
public:
    void push(Edit edit) { m_edits.push_back(std::move(edit)); }
    void push(Edits edits) {
        if (m_edits.empty())
            m_edits = std::move(edits);
        else
            m_edits.insert(m_edits.end(), edits.begin(), edits.end());
    }
    Edits take() { return std::exchange(m_edits, {}); }
    bool empty() const { return m_edits.empty(); }

private:
    Edits m_edits;
};

}  // namespace rubble
