#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "physics/character/character.h"
#include "physics/collision/broadphase.h"
#include "physics/collision/impacts.h"
#include "physics/collision/narrowphase.h"
#include "physics/joints/joint_table.h"
#include "physics/physics_world.h"
#include "physics/solver/contact_solver.h"
#include "physics/solver/energy_bound.h"
#include "physics/water/water.h"

namespace rubble {

/// What PhysicsWorld holds. Its functions are in files: journal.cpp (what World changed), sleep.cpp (who rests and
/// who wakes), joints.cpp (who is tied to whom), physics_world.cpp (a step).
struct PhysicsWorld::Impl {
    explicit Impl(const PhysicsSettings& given) : settings(given) {}

    void loadAll(const World& world);
    void setGravity(const World& world);
    void forget(const FrameChanges& changes);
    void refreshStatic(const FrameChanges& changes, const World& world);
    void refreshDynamic(const FrameChanges& changes, const World& world);
    void refreshFilters(const FrameChanges& changes, const World& world);
    void refreshCharacters(const FrameChanges& changes, const World& world);
    void refreshWaters(const FrameChanges& changes, const World& world);
    void applyImpulses(const FrameChanges& changes);

    void createStatic(const World& world, ShapeHandle handle);
    void destroyStatic(uint32_t slot);
    void createDynamic(const World& world, BodyHandle handle, bool asleep);
    bool enter(const World& world, DynamicBody& body, bool asleep);
    void destroyDynamic(uint32_t slot);

    DynamicBody* dynamicAt(uint32_t slot) const { return slot < dynamics.size() ? dynamics[slot].get() : nullptr; }
    /// Whether the budget of debris lets one more of these move.
    bool mayWake(const DynamicBody& body) const { return !body.isDebris || awakeDebris < awakeDebrisLimit; }
    void wake(DynamicBody& body);
    /// Wakes it, or lets it wait until the budget has a place.
    void wakeOrWait(DynamicBody& body);
    void wakeWaiting();
    void sleep(DynamicBody& body);
    void joinAwake(const DynamicBody& body);
    void leaveAwake(const DynamicBody& body);
    void wakeTouching(glm::dvec3 low, glm::dvec3 high);
    void applyWater();
    void moveCharacters();
    void findContacts();
    void sweepSecondary(const NarrowphaseSettings& narrow);
    bool wakeHit();
    void recordContacts();
    void solve();
    void quarantineBroken();
    /// Whether it is too far away, which is counted.
    bool isOutOfRange(const DynamicBody& body);
    void clamp(DynamicBody& body);
    void warnOfLimits(const LimitCounts& before);
    void putToSleep();
    void wakeTouched();
    void reportPoses();

    void applyJoints(const FrameChanges& changes, const World& world);
    void destroyJoint(uint32_t slot);
    void createJoint(const World& world, JointHandle handle);
    void wakeJointed();
    void gatherJoints();
    void breakJoints();
    void putJointedToSleep();
    void moveRopes();

    PhysicsSettings settings;
    Broadphase broadphase;
    WaterVolumes waters;
    Narrowphase narrowphase;
    ContactSolver solver;
    EnergyBound energy;
    glm::dvec3 gravity{0.0};
    std::vector<std::unique_ptr<DynamicBody>> dynamics;     ///< by body slot
    std::vector<std::unique_ptr<CollisionObject>> statics;  ///< by shape slot
    std::vector<BodyHandle> shapeBody;                      ///< by shape slot
    std::vector<BodyHandle> handles;                        ///< by body slot
    std::vector<uint32_t> awake;                            ///< body slots, ascending
    std::vector<uint32_t> waiting;  ///< body slots of debris that would wake if it had a place, ascending
    size_t awakeDebris = 0, awakeDebrisLimit = 0;
    std::vector<uint32_t> ended;           ///< fell asleep or were quarantined in this step
    std::vector<CollisionObject*> found;   ///< of the last query
    std::vector<CollisionObject*> moving;  ///< whose pairs are looked for
    std::vector<ObjectPair> pairs;
    std::vector<SolverBody> bodies;  ///< of the solver; 0: the world
    std::vector<int> bodyNumber;     ///< in `bodies`, by body slot
    std::vector<std::pair<int, int>> bodyOf;
    JointTable joints;
    std::vector<JointConstraint*> activeJoints;  ///< of what is awake, by slot
    std::vector<JointHandle> jointBreaks;
    std::vector<RopeMotion> ropeMotions;
    std::vector<BodyPose> poses;
    std::vector<Impact> impacts;
    LimitCounts clamped{};
    std::vector<std::pair<CharacterHandle, Character>> characters;  ///< by slot
    std::vector<CharacterPush> pushes;
    std::vector<CharacterMove> characterMoves;
};

/// Sets of slots as ascending lists: true if the slot was not there, or was.
inline bool insertSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at != list.end() && *at == slot) return false;
    list.insert(at, slot);
    return true;
}

inline bool eraseSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at == list.end() || *at != slot) return false;
    list.erase(at);
    return true;
}

}  // namespace rubble
