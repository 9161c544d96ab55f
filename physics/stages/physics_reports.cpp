#include "physics/stages/physics_reports.h"

#include <algorithm>
#include <cmath>

#include "physics/collision/impacts.h"
#include "runtime/voxel/nearest_voxel.h"

namespace rubble {
namespace {

constexpr float kTouching = 0.005f;  ///< metres apart at which what touched still counts as touching
constexpr int kNearCells = 2;        ///< how far from a contact the voxel that it is on may be

uint64_t pairKey(const Manifold& manifold) {
    return uint64_t(manifold.first) << 32 | manifold.second;
}

/// The voxel of an object that is nearest to a point, in world space when its contacts were found.
ContactSide sideAt(const CollisionObject& object, glm::dvec3 point, const PhysicsBodies& bodies) {
    ContactSide side;
    if (object.body == kNoBody) return side;
    side.body = bodies.handles()[object.body];
    side.shapeSlot = object.dynamic ? object.dynamic->shapes()[0].slot() : object.number & ~kStaticObject;
    const glm::dvec3 inObject = poseBeforeSolve(object).inversePoint(point);
    double nearest = INFINITY;  // metres squared
    for (size_t i = 0; i < object.collider.parts.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        const double voxel = part.voxelSize();
        const glm::dvec3 inCells = part.frame().inversePoint(inObject) / voxel;
        const glm::ivec3 middle = cellAt(inCells);
        const auto cell = nearestVoxel(part.grid(), inCells, {middle - kNearCells, middle + kNearCells + 1});
        if (!cell) continue;
        const glm::dvec3 offset = (inCells - glm::dvec3(*cell) - 0.5) * voxel;
        if (const double distance = glm::dot(offset, offset); distance < nearest) {
            nearest = distance, side.cell = *cell;
            if (object.dynamic) side.shapeSlot = object.dynamic->shapes()[i].slot();
        }
    }
    return side;
}

/// The largest distance between two points that bear something, metres.
double extentOf(const Manifold& manifold) {
    float extent2 = 0.0f;
    for (const ManifoldPoint& a : manifold.all())
        for (const ManifoldPoint& b : manifold.all())
            if (a.totalImpulse > 0.0f && b.totalImpulse > 0.0f) {
                const glm::vec3 offset = a.position - b.position;
                extent2 = std::max(extent2, glm::dot(offset, offset));
            }
    return std::sqrt(double(extent2));
}

}  // namespace

void PhysicsReports::addEdited(const FrameChanges& changes, const World& world) {
    for (const BodyHandle body : changes.bodiesCreated) m_edited.push_back(body.slot());
    for (const auto* list : {&changes.shapesCreated, &changes.carved})
        for (const ShapeHandle handle : *list)
            if (const Shape* shape = world.shapes().find(handle)) m_edited.push_back(shape->body.slot());
}

void PhysicsReports::begin() {
    ++m_step;
    m_contacts.clear();
    m_waterEntries.clear();
    m_new.swap(m_edited);
    m_edited.clear();
    std::sort(m_new.begin(), m_new.end());
}

PhysicsReports::Seen& PhysicsReports::seen(BodyHandle body) {
    if (m_seen.size() <= body.slot()) m_seen.resize(body.slot() + 1);
    Seen& found = m_seen[body.slot()];
    if (found.body != body) found = {body};
    return found;
}

uint64_t PhysicsReports::lastAwake(const CollisionObject& object) const {
    if (!object.dynamic || object.body >= m_seen.size()) return 0;
    const Seen& found = m_seen[object.body];
    return found.body == object.dynamic->handle() ? found.awake : 0;
}

void PhysicsReports::addInWater(const DynamicBody& body, const Water& water) {
    if (!m_filter.water) return;
    Seen& before = seen(body.handle());
    const bool gotIn = before.awake > before.inWater;
    before.inWater = m_step;
    if (!gotIn) return;
    const SolverBody& motion = body.motion;
    m_waterEntries.push_back({body.handle(),
                              body.waterSlot,
                              {motion.position.x, water.surface, motion.position.z},
                              glm::length(motion.velocity - water.flow),
                              body.mass().mass});
}

/// Notes that a pair touches, and says whether that is news.
bool PhysicsReports::begins(const Manifold& manifold) {
    bool bears = false, isNear = false;
    for (const ManifoldPoint& point : manifold.all())
        bears |= point.totalImpulse > 0.0f, isNear |= point.separation < kTouching;
    if (!bears && !isNear) return false;
    const auto isNew = [&](const CollisionObject* object) {
        return object->dynamic && std::binary_search(m_new.begin(), m_new.end(), object->body);
    };
    const uint64_t key = pairKey(manifold);
    const auto found = m_touched.find(key);
    const uint64_t last = found == m_touched.end() ? 0 : found->second;
    const bool isNews = std::max(lastAwake(*manifold.objects.first), lastAwake(*manifold.objects.second)) > last;
    if (isNews && !bears) return false;  // it comes near, and touches in a later step
    m_touched[key] = m_step;
    return isNews && !isNew(manifold.objects.first) && !isNew(manifold.objects.second);
}

void PhysicsReports::addContact(const Manifold& manifold, bool begun, const PhysicsBodies& bodies) {
    ReportedContact contact;
    glm::dvec3 position(0.0), normal(0.0);
    const ManifoldPoint* hardest = nullptr;
    for (const ManifoldPoint& point : manifold.all()) {
        const double impulse = double(point.totalImpulse);
        if (!(impulse > 0.0)) continue;
        const glm::dvec3 at = manifold.origin + glm::dvec3(point.position), up(point.normal);
        const glm::dvec3 velocity = velocityAt(*manifold.objects.first, at) - velocityAt(*manifold.objects.second, at);
        contact.impulse += impulse;
        contact.hitSpeed = std::max(contact.hitSpeed, double(point.approach));
        contact.slipSpeed += glm::length(velocity - up * glm::dot(velocity, up)) * impulse;
        position += meetingPoint(manifold, point).now * impulse, normal += up * impulse;
        if (!hardest || point.totalImpulse > hardest->totalImpulse) hardest = &point;
    }
    if (!hardest || contact.impulse < m_filter.minImpulse) return;
    contact.slipSpeed /= contact.impulse;
    contact.begun = begun && m_filter.begun;
    contact.hit = m_filter.hit && contact.hitSpeed >= m_filter.minHitSpeed;
    contact.slid = m_filter.slid && contact.slipSpeed >= m_filter.minSlipSpeed;
    if (!contact.begun && !contact.hit && !contact.slid) return;
    const CollisionObject &first = *manifold.objects.first, &second = *manifold.objects.second;
    const MeetingPoint place = meetingPoint(manifold, *hardest);
    contact.sides = {sideAt(first, place.onFirst, bodies), sideAt(second, place.onSecond, bodies)};
    contact.position = position / contact.impulse;
    const double length = glm::length(normal);
    contact.normal = length > 0.0 ? normal / length : glm::dvec3(0.0, 1.0, 0.0);
    contact.size = std::max({extentOf(manifold), first.collider.smallestVoxel(), second.collider.smallestVoxel()});
    m_contacts.push_back(contact);
}

void PhysicsReports::addContacts(std::span<Manifold* const> manifolds, const PhysicsBodies& bodies) {
    if (m_filter.contacts())
        for (const Manifold* manifold : manifolds) addContact(*manifold, m_filter.begun && begins(*manifold), bodies);
    if (m_touched.size() > 2 * m_keptPairs + 256) dropPairs(bodies);
    for (const uint32_t slot : bodies.awake()) seen(bodies.at(slot).handle()).awake = m_step;
}

/// Drops the pairs that would begin again if they touched: that changes nothing but the memory.
void PhysicsReports::dropPairs(const PhysicsBodies& bodies) {
    std::erase_if(m_touched, [&](const auto& pair) {
        const uint32_t slots[] = {uint32_t(pair.first >> 32), uint32_t(pair.first)};
        if (pair.second == m_step) return false;
        return std::any_of(std::begin(slots), std::end(slots), [&](uint32_t slot) {
            if (slot & kStaticObject) return false;
            const DynamicBody* body = bodies.dynamicAt(slot);
            return !body || lastAwake(body->object) > pair.second;
        });
    });
    m_keptPairs = m_touched.size();
}

}  // namespace rubble
