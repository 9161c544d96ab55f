#pragma once
#include <map>
#include <optional>
#include <set>
#include <variant>
#include <vector>

#include "runtime/destruction/detachment.h"
#include "runtime/destruction/carve.h"
#include "runtime/destruction/fragments.h"
#include "runtime/destruction/paint.h"
#include "runtime/destruction/split.h"
#include "runtime/world/resolve_brush.h"
#include "runtime/world/world.h"

namespace rubble {

/// One step of edits on a World: what World::applyEdits() does, stage by stage. Lives for one call.
class EditStep {
public:
    EditStep(World& world, FrameChanges& changes);
    void run(const Edits& edits);
    /// Of a World that is new: who is in its triggers is looked at in the next step, and is as it was if nothing has changed.
    static void placeTriggers(World& world);

private:
    /// A fragment, and what its entries and paint mean: its shape may be painted anew before it is a body.
    struct BrokenOff {
        Fragment fragment;
        PaletteRef palette;
        PaintColorsRef paintColors;
    };
    /// What happened to a shape in this step, besides what the journal already holds.
    struct Touched {
        ShapeHandle shape;
        BrickSet carved;
        CellBox lost;  ///< cells that held all voxels that went
        BrickSet painted;
        std::vector<BrokenOff> fragments;  ///< out of the grid already; bodies of their own after the edits
        bool lostVoxels = false;           ///< and is in a new frame of cells: look at all of it
    };
    /// How a free body moved before anything was taken from it.
    struct Motion {
        BodyHandle body;
        glm::dvec3 center;  ///< of mass, world
        glm::dvec3 velocity, angularVelocity;
        glm::dvec3 velocityAt(glm::dvec3 point) const { return velocity + glm::cross(angularVelocity, point - center); }
    };
    using Push = std::variant<ExplodeEdit, ImpulseEdit>;

    void apply(const SettingsEdit& edit);
    void apply(const HistoryEdit&) {}  // World::applyEdits() has done it

    // edit_carve.cpp
    void apply(const CarveEdit& edit);
    void carveShape(ShapeHandle handle, const CarveEdit& edit);
    /// Books what a shape has just lost.
    void takeCarved(ShapeHandle handle, const CarveResult& carved);
    /// Where removed voxels were.
    struct Place {
        glm::dvec3 position;
        double radius;
        glm::vec3 velocity;
    };
    void countRemoved(ShapeHandle handle, const CarveResult& carved);
    void countRemoved(ShapeHandle handle, const std::array<uint64_t, 256>& removed, const Place& place);

    // edit_break.cpp
    void apply(const BreakEdit& edit);
    void apply(const ExplodeEdit& edit);
    void breakShape(ShapeHandle handle, const BreakEdit& edit);
    void countLit(const VoxelGrid& grid, const Palette& palette);

    // edit_paint.cpp
    void apply(const PaintEdit& edit);
    void paintShape(ShapeHandle handle, const PaintEdit& edit, const CarveEdit& area);
    void paintCells(ShapeHandle handle, std::span<const BrickSubset> cells, const Paint& paint);
    void keep(ShapeHandle handle, const PaintResult& painted);

    // edit_split.cpp
    void splitShapes();
    void releaseFragments();
    bool isWhole(const Touched& each) const;
    bool searchOn(PendingSplit& pending, size_t& budget);
    void splitShape(ShapeHandle parent, const Detached& loose);
    void dropPiece(ShapeHandle parent, const Component& component);
    ShapeHandle createChild(ShapeHandle parent, Piece piece, const MassMoments& moments, PieceMotion& started);
    void rehome(ShapeHandle shape);
    void destroyShape(ShapeHandle shape);
    void rememberMotion(BodyHandle body);
    void settleMotions();

    // edit_shape.cpp
    void apply(const SplitShapeEdit& edit);
    void apply(const MergeShapeEdit& edit);
    void apply(const TrimShapeEdit& edit);
    void apply(const ResizeShapeEdit& edit);
    Shape* shapeToEdit(ShapeHandle handle, const char* edit);
    ShapeHandle createSibling(ShapeHandle shape, Piece piece, const MassMoments& moments);
    ShapeHandle findMatch(ShapeHandle shape) const;
    bool reframe(ShapeHandle shape, const CellBox& box);

    // edit_debris.cpp
    void limitDebris();
    void wake(BodyHandle body);
    void turnToDust(BodyHandle body);
    void forgetStillborn();

    // edit_load.cpp
    void openCracks();
    void openCrack(ShapeHandle shape, const StrengthTable& entries, const StressCrack& crack);
    void weighShapes();
    void weighShape(WorldLoad::Entry& entry, int64_t& work);
    /// Fire has left this much of a brick's strength, of 256.
    void weaken(ShapeHandle shape, glm::ivec3 brick, int left);

    // edit_strike.cpp
    void apply(const StrikeEdit& edit);
    void strikePiece(ShapeHandle shape, const ImpactForce& impact);

    // edit_lights.cpp
    void apply(const SetEnvironmentEdit& edit);
    void apply(const AddLightEdit& edit);
    void apply(const SetLightEdit& edit);
    void apply(const RemoveLightEdit& edit);
    std::optional<Light> checkedLight(const Light& wanted, const char* edit) const;
    void moveLights(const ShapeSplit& split);
    void putOutLightsOf(ShapeHandle shape);
    void updateLightGroups();
    bool isCutOff(LightGroupHandle handle, const LightGroup& group) const;
    void putOut(LightGroupHandle handle, LightGroup& group);
    void flicker(LightGroupHandle handle, LightGroup& group);
    void darkenGroup(LightGroupHandle group);

    // edit_fire.cpp
    struct Deposit {
        ShapeHandle shape;
        glm::ivec3 brick;
        int64_t heat;  ///< mJ
    };
    void apply(const HeatEdit& edit);
    void apply(const ExtinguishEdit& edit);
    void apply(const RemoveFiresEdit& edit);
    HotBrick* heat(const Deposit& deposit);
    void lightBrick(ShapeHandle shape, HotBrick& hot);
    void putOut(ShapeHandle shape, HotBrick& hot, uint32_t wet);
    const HeatTable& heatTable(ShapeHandle shape);
    glm::dvec3 brickInWorld(ShapeHandle shape, glm::ivec3 brick) const;
    void burn();
    void burnShape(HeatField& field);
    void emit(ShapeHandle shape, const HotBrick& hot, int64_t emitted);
    void consume(ShapeHandle shape, const std::vector<BrickSubset>& cells);
    void moveHeat();
    void splitHeat(const ShapeSplit& split);

    // edit_regions.cpp
    void apply(const SetCollisionEdit& edit);
    void apply(const AddWaterEdit& edit);
    void apply(const RemoveWaterEdit& edit);
    void apply(const AddTriggerEdit& edit);
    void apply(const RemoveTriggerEdit& edit);
    void quench();

    // edit_triggers.cpp
    void updateTriggers();
    std::vector<BodyHandle> bodiesToWatch();

    // edit_character.cpp
    void apply(const AddCharacterEdit& edit);
    void apply(const RemoveCharacterEdit& edit);
    void apply(const MoveCharacterEdit& edit);
    void apply(const PlaceCharacterEdit& edit);
    // edit_joint.cpp
    void apply(const AddJointEdit& edit);
    void apply(const RemoveJointEdit& edit);
    void apply(const SetJointMotorEdit& edit);
    void apply(const DetachJointEdit& edit);
    void apply(const DriveEdit& edit);
    void apply(const GrabEdit& edit);
    void apply(const ReleaseEdit& edit);
    void breakJoint(JointHandle handle, JointBreak reason, glm::dvec3 position);
    void moveJointEnd(JointHandle handle, size_t end, ShapeHandle to, glm::ivec3 cellOffset);
    void moveJoints(const ShapeSplit& split);
    void reframeJoints(ShapeHandle shape, glm::ivec3 low);
    void loseJoints(ShapeHandle shape);
    void loseEnd(JointHandle handle, size_t end);
    void checkJoints();

    // edit_rope.cpp
    void cutRopes(const CarveEdit& volume);
    bool cutRope(JointHandle handle, double place, JointBreak reason);
    void windRopes();

    // edit_push.cpp
    void apply(const ImpulseEdit& edit);
    void push(const ExplodeEdit& edit);
    void push(const ImpulseEdit& edit);
    void pushBody(const ImpulseApplied& impulse);

    Touched& touched(ShapeHandle shape);
    void markBroken(BodyHandle body);
    void listChangedBricks();

    World& m_world;
    FrameChanges& m_changes;
    std::map<uint32_t, Touched> m_touched;  ///< by slot
    std::map<uint32_t, Motion> m_motions;   ///< by slot
    std::vector<Push> m_pushes;             ///< wait until the pieces exist
    std::set<uint32_t> m_struck;            ///< slots of pieces that a impact was tried on
    std::set<uint32_t> m_cutWires;          ///< slots of shapes that lost wire, or pieces
    std::vector<uint64_t> m_groupRemoved;   ///< voxels, by slot of the group
    std::vector<Deposit> m_deposits;        ///< heat on its way, for the end of the fires' turn
    std::vector<HeatDeposit> m_near;
    HeatTable m_heatTable;
    PaletteRef m_heatTableOf;
    float m_heatTableSize = 0.0f;  ///< of a voxel
};

}  // namespace rubble
