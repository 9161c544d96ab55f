#pragma once
#include <map>
#include <optional>
#include <set>
#include <variant>
#include <vector>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/detachment.h"
#include "runtime/destruction/fragments.h"
#include "runtime/destruction/paint.h"
#include "runtime/destruction/split.h"
#include "runtime/world/edits/resolve_brush.h"
#include "runtime/world/world.h"

namespace rubble {

/// One step of edits on a World: what World::applyEdits() does, stage by stage. Lives for one call.
class EditStep {
public:
    EditStep(World& world, FrameChanges& changes);
    void run(const Edits& edits);
    /// Of a World that is new: who is in its triggers is looked at in the next step, and is as it was if nothing has
    /// changed.
    static void initTriggers(World& world);

private:
    /// A fragment, and what its entries and paint mean: its shape may be painted anew before it is a body.
    struct DetachedFragment {
        Fragment fragment;
        PaletteRef palette;
        PaintColorsRef paintColors;
    };
    /// What happened to a shape in this step, besides what the journal already holds.
    struct ShapeEditState {
        ShapeHandle shape;
        BrickSet carved;
        CellBox lost;  ///< cells that held all voxels that went
        BrickSet painted;
        std::vector<DetachedFragment> fragments;  ///< out of the grid already; bodies of their own after the edits
        bool lostVoxels = false;                  ///< and is in a new frame of cells: look at all of it
    };
    /// How a free body moved before anything was taken from it.
    struct Motion {
        BodyHandle body;
        glm::dvec3 center;  ///< of mass, world
        glm::dvec3 velocity, angularVelocity;
        glm::dvec3 velocityAt(glm::dvec3 point) const { return velocity + glm::cross(angularVelocity, point - center); }
    };
    using DeferredImpulse = std::variant<ExplodeEdit, ImpulseEdit>;

    void apply(const SettingsEdit& edit);
    void apply(const HistoryEdit&) {}  // World::applyEdits() has done it

    // edit_carve.cpp
    void apply(const CarveEdit& edit);
    void carveShape(ShapeHandle handle, const CarveEdit& edit);
    /// Books what a shape has just lost.
    void recordCarved(ShapeHandle handle, const CarveResult& carved);
    /// Where removed voxels were.
    struct DustSource {
        glm::dvec3 position;
        double radius;
        glm::vec3 velocity;
    };
    void recordRemoved(ShapeHandle handle, const CarveResult& carved);
    void recordRemoved(ShapeHandle handle, const std::array<uint64_t, 256>& removed, const DustSource& place);

    // edit_break.cpp
    void apply(const BreakEdit& edit);
    void apply(const ExplodeEdit& edit);
    void breakShape(ShapeHandle handle, const BreakEdit& edit);
    void countLightVoxels(const VoxelGrid& grid, const Palette& palette);

    // edit_paint.cpp
    void apply(const PaintEdit& edit);
    void paintShape(ShapeHandle handle, const PaintEdit& edit, const CarveEdit& area);
    void paintCells(ShapeHandle handle, std::span<const BrickSubset> cells, const Paint& paint);
    void commitPaint(ShapeHandle handle, const PaintResult& painted);

    // edit_split.cpp
    void splitShapes();
    void releaseFragments();
    bool isStillConnected(const ShapeEditState& each) const;
    bool continueSearch(PendingSplit& pending, size_t& budget);
    void splitShape(ShapeHandle parent, const Detached& loose);
    void discardPiece(ShapeHandle parent, const Component& component);
    ShapeHandle createPiece(ShapeHandle parent, Piece piece, const MassMoments& moments, PieceMotion& started);
    void detachToNewBody(ShapeHandle shape);
    void destroyShape(ShapeHandle shape);
    void recordMotion(BodyHandle body);
    void updateVelocities();

    // edit_shape.cpp
    void apply(const SplitShapeEdit& edit);
    void apply(const MergeShapeEdit& edit);
    void apply(const TrimShapeEdit& edit);
    void apply(const ResizeShapeEdit& edit);
    Shape* shapeToEdit(ShapeHandle handle, const char* edit);
    ShapeHandle createSplitShape(ShapeHandle shape, Piece piece, const MassMoments& moments);
    ShapeHandle findMergeTarget(ShapeHandle shape) const;
    bool reframe(ShapeHandle shape, const CellBox& box);

    // edit_debris.cpp
    void enforceDebrisBudgets();
    void wake(BodyHandle body);
    void despawn(BodyHandle body);
    void dropTransient();

    // edit_load.cpp
    void openCracks();
    void openCrack(ShapeHandle shape, const StrengthTable& entries, const StressCrack& crack);
    void runStressAnalysis();
    void runShapeAnalysis(WorldStress::Entry& entry, int64_t& work);
    /// Fire has left this much of a brick's strength, of 256.
    void weaken(ShapeHandle shape, glm::ivec3 brick, int left);

    // edit_strike.cpp
    void apply(const ImpactLoadEdit& edit);
    void fracturePiece(ShapeHandle shape, const ImpactForce& impact);

    // edit_lights.cpp
    void apply(const SetEnvironmentEdit& edit);
    void apply(const AddLightEdit& edit);
    void apply(const SetLightEdit& edit);
    void apply(const RemoveLightEdit& edit);
    std::optional<Light> checkedLight(const Light& wanted, const char* edit) const;
    void moveLights(const ShapeSplit& split);
    void turnOffLightsOf(ShapeHandle shape);
    void updateLightGroups();
    bool lostPower(LightGroupHandle handle, const LightGroup& group) const;
    void turnOff(LightGroupHandle handle, LightGroup& group);
    void updateFlicker(LightGroupHandle handle, LightGroup& group);
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
    HotBrick* depositHeat(const Deposit& deposit);
    void igniteBrick(ShapeHandle shape, HotBrick& hot);
    void extinguishBrick(ShapeHandle shape, HotBrick& hot, uint32_t wet);
    const HeatTable& heatTable(ShapeHandle shape);
    glm::dvec3 brickInWorld(ShapeHandle shape, glm::ivec3 brick) const;
    void updateFires();
    void updateHeatField(HeatField& field);
    void emitHeat(ShapeHandle shape, const HotBrick& hot, int64_t emitted);
    void removeBurnedCells(ShapeHandle shape, const std::vector<BrickSubset>& cells);
    void redistributeHeat();
    void splitHeat(const ShapeSplit& split);

    // edit_regions.cpp
    void apply(const SetCollisionEdit& edit);
    void apply(const AddWaterEdit& edit);
    void apply(const RemoveWaterEdit& edit);
    void apply(const AddTriggerEdit& edit);
    void apply(const RemoveTriggerEdit& edit);
    void extinguishUnderWater();

    // edit_triggers.cpp
    void updateTriggers();
    std::vector<BodyHandle> movedBodies();

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
    void releaseJointsOf(ShapeHandle shape);
    void releaseEnd(JointHandle handle, size_t end);
    void releaseUnheldJoints();

    // edit_rope.cpp
    void cutRopes(const CarveEdit& volume);
    bool cutRope(JointHandle handle, double place, JointBreak reason);
    void updateWinches();

    // edit_push.cpp
    void apply(const ImpulseEdit& edit);
    void applyImpulse(const ExplodeEdit& edit);
    void applyImpulse(const ImpulseEdit& edit);
    void applyImpulseTo(const ImpulseApplied& impulse);

    ShapeEditState& editState(ShapeHandle shape);
    void markBroken(BodyHandle body);
    void listChangedBricks();

    World& m_world;
    FrameChanges& m_changes;
    std::map<uint32_t, ShapeEditState> m_editStates;  ///< by slot
    std::map<uint32_t, Motion> m_motions;             ///< by slot
    std::vector<DeferredImpulse> m_deferredImpulses;  ///< wait until the pieces exist
    std::set<uint32_t> m_impactLoaded;                ///< slots of pieces that a impact was tried on
    std::set<uint32_t> m_cutWires;                    ///< slots of shapes that lost wire, or pieces
    std::vector<uint64_t> m_removedByGroup;           ///< voxels, by slot of the group
    std::vector<Deposit> m_deposits;                  ///< heat on its way, for the end of the fires' turn
    std::vector<HeatDeposit> m_near;
    HeatTable m_heatTable;
    PaletteRef m_heatTableOf;
    float m_heatTableSize = 0.0f;  ///< of a voxel
};

}  // namespace rubble
