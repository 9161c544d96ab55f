#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "physics/collision/manifold.h"
#include "physics/stages/physics_bodies.h"
#include "runtime/world/impacts/reported_contact.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// Collects what hosts ask to hear of a step. A contact begins, and a body gets into water, if it was not so in the
/// last step in which one of its bodies was awake: what wakes where it lay begins nothing, nor does what an edit has
/// just made or cut. [main-thread]
class PhysicsReports {
public:
    /// Nothing is known of the steps before.
    explicit PhysicsReports(const ReportFilter& filter) : m_filter(filter) {}
    /// What is collected from the next step on.
    void setFilter(const ReportFilter& filter) { m_filter = filter; }
    /// Forgets what touched what: the world is another one.
    void forget() { *this = PhysicsReports(m_filter); }

    /// Notes which bodies an edit made or cut: what they touch in the next step is no news.
    void addEdited(const FrameChanges& changes, const World& world);
    /// Begins a step.
    void begin();
    /// Notes that an awake body is in water, that of its waterSlot.
    void addInWater(const DynamicBody& body, const Water& water);
    /// Reports the contacts of the step, in their order, and notes which bodies were awake in it: after the solve,
    /// before bodies fall asleep or wake.
    void addContacts(std::span<Manifold* const> manifolds, const PhysicsBodies& bodies);

    /// Of the last step, sorted as the manifolds are.
    std::span<const ReportedContact> contacts() const { return m_contacts; }
    /// Of the last step, in the order of body slots.
    std::span<const WaterEntry> waterEntries() const { return m_waterEntries; }

private:
    /// The last steps in which a body was awake and in water; 0: none.
    struct Seen {
        BodyHandle body;
        uint64_t awake = 0, inWater = 0;
    };
    Seen& seen(BodyHandle body);
    uint64_t lastAwake(const CollisionObject& object) const;
    bool begins(const Manifold& manifold);
    void addContact(const Manifold& manifold, bool begun, const PhysicsBodies& bodies);
    void dropPairs(const PhysicsBodies& bodies);

    ReportFilter m_filter;
    uint64_t m_step = 0;
    std::vector<Seen> m_seen;               ///< by body slot
    std::vector<uint32_t> m_edited, m_new;  ///< slots of bodies that edits made or cut: since the last step; before it
    std::unordered_map<uint64_t, uint64_t> m_touched;  ///< by the numbers of a pair: the last step in which it touched
    size_t m_keptPairs = 0;                            ///< by the last dropPairs()
    std::vector<ReportedContact> m_contacts;
    std::vector<WaterEntry> m_waterEntries;
};

}  // namespace rubble
