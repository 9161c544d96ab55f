#pragma once
#include <memory>
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "physics/bodies/limit_monitor.h"
#include "physics/collision/broadphase.h"
#include "physics/stages/awake_bodies.h"
#include "physics/stages/physics_settings.h"
#include "runtime/world/world.h"

namespace rubble {

constexpr double kTouchDistance = 0.02;  ///< metres between bounds up to which bodies count as touching

/// The bodies of a World as physics has them: dynamic ones by body slot, the shapes of static ones by shape slot; who
/// is awake; and the broadphase. [main-thread]
class PhysicsBodies {
public:
    /// Creates a body that is not there yet as the World has it between two steps, in balance with what sleeps around
    /// it.
    void load(const World& world, BodyHandle handle);
    /// Creates the object of a static body's shape, or replaces it. Wakes what touched the cells that are gone, and
    /// what is where new ones are.
    void replaceStatic(const World& world, ShapeHandle handle);
    /// Removes the object of a static body's shape and wakes what touched it. Does nothing if there is none.
    void removeStatic(uint32_t shapeSlot);
    /// Takes over a cut of a static shape, and wakes what touched the changed bricks. Does nothing if it was not
    /// static.
    void updateStatic(const World& world, ShapeHandle handle, const FrameChanges& changes);
    /// Removes a dynamic body and wakes what touched it. Does nothing if the handle is stale.
    void destroyDynamic(BodyHandle handle);
    /// Takes over a change of a dynamic body, or creates it, and wakes what touched it before. keepsShapes: nothing but
    /// its motion and its voxels has changed.
    void updateDynamic(const World& world, BodyHandle handle, const FrameChanges& changes, bool keepsShapes);
    /// Takes over a shape's new collision filter, and wakes what may touch it now or no longer.
    void updateFilter(const World& world, ShapeHandle handle);

    /// The dynamic body in a slot; null: there is none.
    DynamicBody* dynamicAt(uint32_t slot) const { return slot < m_dynamics.size() ? m_dynamics[slot].get() : nullptr; }
    /// The dynamic body of a handle; null: the handle is empty or stale.
    DynamicBody* find(BodyHandle handle) const;
    /// By shape slot, the body that its shape belongs to, or last belonged to; empty if there never was one.
    const std::vector<BodyHandle>& owners() const { return m_owners; }
    /// The handles of all bodies, by slot.
    const std::vector<BodyHandle>& handles() const { return m_handles; }
    /// Objects whose bounds overlap a box, by number; valid until the next call.
    const std::vector<CollisionObject*>& objectsIn(glm::dvec3 low, glm::dvec3 high);

    /// Slots of awake bodies, ascending. Waking inserts into this list.
    const std::vector<uint32_t>& awake() const { return m_awake.slots(); }
    /// An awake body by its slot.
    DynamicBody& at(uint32_t slot) const { return *m_dynamics[slot]; }
    /// Wakes a body; does nothing if it is awake or quarantined.
    void wake(DynamicBody& body);
    /// Wakes a body; false: the budgets of awake debris and of wakes in a step have no place for it. It waits for one
    /// then, if it may.
    bool wakeOrWait(DynamicBody& body, bool mayWait = true);
    /// Begins a step with its budget of wakes. Wakes bodies that wait; half of the budget is left for hits.
    void wakeWaiting(const PhysicsSettings& settings);
    /// Wakes, or lets wait, all bodies whose bounds touch a box, in slot order.
    void wakeTouching(glm::dvec3 low, glm::dvec3 high);
    /// Puts a body to sleep. It stays in awake() until removeEnded().
    void putToSleep(DynamicBody& body);
    /// Removes from awake() the bodies that fell asleep or were quarantined.
    void removeEnded();
    /// Freezes awake bodies whose numbers are invalid or that are too far away, where they last were valid; clamps the
    /// others.
    void quarantineInvalid();
    /// Ends a step: appends the state of each body that moved, woke, fell asleep or began to wait to wake, in slot
    /// order.
    void reportPoses(std::vector<BodyPose>& out);

    /// The budgets of awake debris and of wakes in a step.
    AwakeBodies& budget() { return m_awake; }
    /// What was beyond the limits.
    LimitMonitor& limits() { return m_limits; }
    /// For finding pairs.
    Broadphase& broadphase() { return m_broadphase; }

private:
    bool tryWake(DynamicBody& body);
    void createStatic(const World& world, ShapeHandle handle);
    void createDynamic(const World& world, BodyHandle handle, bool asleep);
    bool insert(const World& world, DynamicBody& body, bool asleep);
    std::unique_ptr<CollisionObject> takeStatic(uint32_t shapeSlot);
    void wakeAtBricks(const CollisionObject& object, const std::vector<glm::ivec3>& bricks);
    void wakeAtChangedCells(const CollisionObject* before, const CollisionObject& now);

    Broadphase m_broadphase;
    LimitMonitor m_limits;
    std::vector<std::unique_ptr<DynamicBody>> m_dynamics;     ///< by body slot
    std::vector<std::unique_ptr<CollisionObject>> m_statics;  ///< by shape slot
    std::vector<BodyHandle> m_owners;                         ///< by shape slot
    std::vector<BodyHandle> m_handles;                        ///< by body slot
    AwakeBodies m_awake;
    std::vector<uint32_t> m_ended;       ///< slots that fell asleep or were quarantined in this step
    std::vector<uint32_t> m_nowWaiting;  ///< slots that began to wait to wake since the last step
    std::vector<CollisionObject*> m_found;
};

}  // namespace rubble
