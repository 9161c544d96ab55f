#pragma once
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/core/ranges.h"
#include "runtime/destruction/carve.h"
#include "runtime/destruction/fragments.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// A fragment, and what its entries and paint mean: its shape may be painted again before the fragment is a body.
struct DetachedFragment {
    Fragment fragment;
    PaletteRef palette;
    PaintColorsRef paintColors;
};

/// What happened to a shape in this step, besides what the journal already holds.
struct ShapeEditState {
    ShapeHandle shape;
    BrickSet carved;
    CellBox lost;     ///< cells that held all voxels that are gone
    BrickSet filled;  ///< bricks that got voxels of another shape, or other voxels by undo
    BrickSet painted;
    std::vector<DetachedFragment> fragments;  ///< no longer in the grid; bodies of their own after the edits
    /// Its voxels are of other materials: mass, strength and contacts follow.
    bool otherMaterials = false;
    bool lostVoxels = false;   ///< where `lost` and `carved` do not tell: all of it is tested for connectivity
    bool brokeBefore = false;  ///< lost voxels in this step that `carved` has no longer
    /// Whether it has lost voxels in this step.
    bool isBroken() const { return brokeBefore || !carved.empty(); }
    /// Whether it has other voxels, materials or paint than before the step, or since it came into the journal as made.
    bool isChanged() const { return otherMaterials || !carved.empty() || !filled.empty() || !painted.empty(); }
};

/// How a free body moved before anything was taken from it.
struct BodyMotion {
    BodyHandle body;
    glm::dvec3 center;                     ///< of mass, world
    glm::dvec3 velocity, angularVelocity;  ///< m/s of the centre; rad/s, world axes
    /// Velocity of the body's point at a world position: v + w x r, within the range that bodies may have.
    glm::dvec3 velocityAt(glm::dvec3 point) const {
        return glm::clamp(velocity + glm::cross(angularVelocity, point - center), ranges::kVelocity.low,
                          ranges::kVelocity.high);
    }
};

/// Where removed voxels were, for their dust.
struct DustSource {
    glm::dvec3 position;  ///< world
    double radius;        ///< metres
    glm::vec3 velocity;   ///< m/s
};

/// What the stages of one step share: the world, the journal, and what the step has done so far. Lives for one step.
struct EditContext {
    /// For one step on a world, with the journal to complete.
    EditContext(WorldData& world, FrameChanges& changes);

    WorldData& world;
    FrameChanges& changes;
    std::map<uint32_t, ShapeEditState> editStates;                 ///< by slot of the shape
    std::map<uint32_t, BodyMotion> motions;                        ///< by slot of the body
    std::vector<std::variant<ExplodeEdit, ImpulseEdit>> impulses;  ///< wait until the pieces exist
    std::set<uint32_t> cutWires;                                   ///< slots of shapes that lost wire, or pieces
    std::vector<uint64_t> removedByGroup;                          ///< voxels, by slot of the light group
    std::vector<ShapeHandle> emptyShapes;                          ///< made in this step, without a voxel then
    std::vector<ShapeHandle> placedShapes;                         ///< made in this step, or moved in a still one
    const Edit* edit = nullptr;                                    ///< the one that is being carried out

    /// Stores what the edit in turn makes, under the handle that is reserved for it, if there is one.
    template <class Handle, class T>
    Handle make(SlotMap<Handle, T>& map, T value) {
        const Handle wanted{edit ? edit->made.bits : 0};
        if (!map.isReserved(wanted)) return map.insert(std::move(value));
        map.fill(wanted, std::move(value));
        return wanted;
    }
    /// Logs why the edit in turn makes nothing. The handle that is reserved for it is stale from now on.
    void refuse(const std::string& reason);
    /// The same of a handle that another edit made in this step, by its name.
    void refuse(AnyHandle made, const char* editName, const std::string& reason);
    /// Whether an edit of this step made a body, or it came off in this step.
    bool isNew(BodyHandle body) const { return world.bodies.at(body).createdStep == changes.step; }

    /// The shape's entry in editStates, a new one if it has none.
    ShapeEditState& editState(ShapeHandle shape);
    /// Keeps how a body moves, before the first voxel is taken from it in this step; see updateVelocities().
    void recordMotion(BodyHandle body);
    /// Takes over what was carved out of a shape's grid: mass, counts, bricks for the journal.
    void recordCarved(ShapeHandle shape, const CarveResult& carved);
    /// Counts voxels that are gone, by entry of the shape's palette, and makes their dust.
    void recordRemoved(ShapeHandle shape, const std::array<uint64_t, 256>& removed, const DustSource& source);
    /// Takes voxels out of the accounts that an edit has erased, by entry of the shape's palette: they make no dust.
    void recordErased(ShapeHandle shape, const std::array<uint64_t, 256>& erased);
    /// Lists a shape whose palette or paint colours changed in the journal, once.
    void listPalette(ShapeHandle shape);
    /// Wakes a body. Physics will wake its own too: by an impulse, or because its shape changed.
    void wakeBody(BodyHandle body);
    /// Logs that the object of an edit is not there, unless this step has destroyed it before the edit's turn: that is
    /// no mistake of who made the edit, which may be an impact.
    void warnStale(ShapeHandle shape, const char* warning) const;
    /// The same for a body.
    void warnStale(BodyHandle body, const char* warning) const;
    /// The same for objects of which an undo or redo of this step alone may have destroyed some.
    void warnStale(const std::string& warning) const;
    /// Sets Shape::broken and Body::broken; the journal lists the first time of the body.
    void markBroken(ShapeHandle shape);

private:
    /// Counts voxels of an entry that are gone for wires and light groups.
    void countLost(ShapeHandle shape, const PaletteEntry& entry, uint64_t count);
};

}  // namespace rubble
