#pragma once
#include <algorithm>
#include <utility>

#include "physics/bullet_math.h"
#include "physics/bullet_world.h"
#include "physics/contacts.h"
#include "physics/dynamic_body.h"
#include "physics/physics_world.h"
#include "physics/static_shape.h"

namespace rubble {

inline constexpr double kStep = 1.0 / 60.0;

/// What PhysicsWorld holds. Its functions are in three files: journal.cpp (what World changed), sleep.cpp (who rests and
/// who wakes), physics_world.cpp (a step).
struct PhysicsWorld::Impl {
    explicit Impl(const PhysicsSettings& given) : settings(given), bullet(given.solverIterations) {
        bullet.beforeSolve = [this] {
            noteContacts();
            contacts.beforeSolve(*bullet.getDispatcher());
        };
        bullet.afterSolve = [this] {
            contacts.afterSolve(*bullet.getDispatcher(), settings.impactSpeed);
            brakeFast();
        };
    }
    ~Impl() { clear(); }

    void clear();
    void loadAll(const World& world);
    void setGravity(const World& world);
    void forget(const FrameChanges& changes);
    void refreshStatic(const FrameChanges& changes, const World& world);
    void refreshDynamic(const FrameChanges& changes, const World& world);
    void applyImpulses(const FrameChanges& changes);

    void createStatic(const World& world, ShapeHandle handle);
    void createDynamic(const World& world, BodyHandle handle, bool asleep);
    void destroyDynamic(uint32_t slot);

    DynamicBody* dynamicAt(uint32_t slot) const { return slot < dynamics.size() ? dynamics[slot].get() : nullptr; }
    DynamicBody* dynamicOf(const btCollisionObject& object) const { return dynamicAt(uint32_t(object.getUserIndex())); }
    /// Whether the budget of debris lets one more of these move.
    bool mayWake(const DynamicBody& body) const { return !body.isDebris || awakeDebris < awakeDebrisLimit; }
    void wake(DynamicBody& body);
    /// Wakes it, or lets it wait until the budget has a place.
    void wakeOrWait(DynamicBody& body);
    void wakeWaiting();
    void sleep(DynamicBody& body);
    void joinAwake(const DynamicBody& body);
    void leaveAwake(const DynamicBody& body);
    void wakeTouching(btVector3 low, btVector3 high);
    void noteContacts();
    void readdWoken();
    void quarantineBroken();
    void brakeFast();
    void releaseFast();
    void settle();
    void disturb();
    void report();

    PhysicsSettings settings;
    BulletWorld bullet;
    ContactLog contacts;
    glm::dvec3 origin{0.0};  ///< world position of Bullet's zero
    glm::vec3 gravity{0.0f};
    std::vector<std::unique_ptr<DynamicBody>> dynamics;  ///< by body slot
    std::vector<std::unique_ptr<StaticShape>> statics;   ///< by shape slot
    std::vector<BodyHandle> shapeBody;                   ///< by shape slot
    std::vector<BodyHandle> handles;                     ///< by body slot
    std::vector<uint32_t> awake;                         ///< body slots, ascending
    std::vector<uint32_t> waiting;                       ///< body slots of debris that would wake if it had a place, ascending
    size_t awakeDebris = 0, awakeDebrisLimit = 0;
    std::vector<uint32_t> ended;                         ///< fell asleep or were quarantined in this step
    std::vector<btCollisionObject*> found;               ///< of the last query
    std::vector<std::pair<uint32_t, btVector3>> braked;  ///< body slot and the velocity it gets back after the substep
    std::vector<BodyPose> poses;
    std::vector<Impact> impacts;
    bool contactsKnown = false;
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
