#include "physics/collision/voxel_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "physics/collision/box_contacts.h"
#include "physics/collision/feature_collider.h"
#include "physics/collision/hull_separation.h"
#include "physics/collision/round_contacts.h"
#include "runtime/core/rotated_box.h"
#include "runtime/core/world_box.h"

// Narrowphase of two voxel shapes: features against occupancy.
//
// Two solids made of cubes touch first with convex corners and edges: a face meets a face only where a corner or an
// edge of one lies on the other. So the convex corners and edges of each shape, found once per brick, are looked up in
// the occupancy grid of the other. This is the point-against-voxels test of McNeely, Puterbaugh and Troy ("Six
// Degree-of-Freedom Haptic Rendering Using Voxel Sampling", SIGGRAPH 1999) with exact surfaces in place of point
// shells:
//   1. Hulls: if the convex hulls are separated by more than the bodies can close in the step, nothing touches.
//   2. Each corner, and the middle of each edge: inside a solid cell, the nearest exposed face of it is the contact; in
//      an empty cell, a face within the margin; if the bodies move fast, the first face along the feature's
//      displacement (continuous collision, so that nothing tunnels).
//   3. An edge that is only partly inside crosses an edge of the other; the normal is the cross product of the two.
// A normal is always that of a face which is exposed in its own grid, and against which the feature sticks out in its
// own. So seams between voxels are no bumps ("internal edges"), and aligned edges give no sideways push. Nor are
// seams between shapes that lie flush against each other: what a neighbour lies against is not exposed (cover.h).

namespace rubble {
namespace {

/// Voxels, besides the margin, around a corner or edge in which contacts are searched.
constexpr float kSearchDistance = 0.15f;
/// Iterations of the search for a separating axis, for new pairs and for those with an axis of the step before.
constexpr int kNewPairIterations = 4, kKnownPairIterations = 1;
/// Depth in cells from which a stuck feature counts although other features have contacts.
constexpr float kMinStuckDepth = 0.25f;
/// Cells around a part that are looked at for bricks of a large one, which has no tight hull.
constexpr double kClearCells = 4.0;
/// Length of the mean normal of contacts below which they oppose each other.
constexpr float kMinAgreement = 0.5f;

/// The motion of the first body relative to the second.
struct RelativeMotion {
    RelativeMotion(const Motion& first, const Motion& second, const NarrowphaseSettings& settings)
        : seconds(settings.seconds) {
        offset = second.pose.position - first.pose.position;
        // v1 + w1 x r - (v2 + w2 x (r - offset))
        firstVelocity = first.velocity, firstSpin = first.angularVelocity;
        secondVelocity = second.velocity, secondSpin = second.angularVelocity;
        velocity = first.velocity - second.velocity + glm::cross(second.angularVelocity, offset);
        spin = first.angularVelocity - second.angularVelocity;
        maxDisplacement = maxRelativeDisplacement(first, second, seconds);
        sweeps = maxDisplacement > settings.sweepThreshold;
        if (second.radius == 0.0 || first.radius < second.radius)
            radius = first.radius, centerVelocity = velocity;
        else
            radius = second.radius, centerVelocity = velocity + glm::cross(spin, offset);
    }
    /// The most by which what may meet comes closer in the step along a unit vector from the second body to the first,
    /// metres. around: metres around a feature in which contacts are searched.
    float closingDistance(const glm::vec3& axis, double around) const {
        if (!sweeps) return 0.0f;
        const double linear = -glm::dot(glm::dvec3(axis), centerVelocity),
                     angular = glm::length(glm::cross(glm::dvec3(axis), spin)) * (radius + maxDisplacement + around);
        return float(std::clamp((linear + angular) * seconds, 0.0, maxDisplacement));
    }

    double seconds;
    glm::dvec3 firstVelocity{0.0}, firstSpin{0.0}, secondVelocity{0.0}, secondSpin{0.0};  ///< world axes
    glm::dvec3 offset{0.0};    ///< from the first's frame origin to the second's, world axes
    glm::dvec3 velocity{0.0};  ///< of the first at its origin relative to the second, world axes
    glm::dvec3 spin{0.0};
    double maxDisplacement = 0.0;  ///< of any point of one relative to the other, metres
    bool sweeps = false;
    double radius = 0.0;             ///< of the smaller body
    glm::dvec3 centerVelocity{0.0};  ///< the velocity at the smaller body's origin
};

TransformedHull transformHull(const ColliderPart& part, const CellTransform& cells) {
    return {part.hull(), glm::mat3(cells.axes), glm::vec3(cells.corner)};
}

/// The unit vector from the centre of one part to that of the other.
glm::vec3 centerAxis(const ColliderPart& to, const TransformedHull& toHull, const ColliderPart& from,
                     const TransformedHull& fromHull) {
    const auto center = [](const ColliderPart& part, const TransformedHull& hull) {
        return hull.corner + hull.axes * (glm::vec3(part.bounds().low + part.bounds().high) * 0.5f);
    };
    const glm::vec3 offset = center(to, toHull) - center(from, fromHull);
    const float length2 = glm::dot(offset, offset);
    return length2 > 1e-12f ? offset / std::sqrt(length2) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Two parts with a feature that is inside of the other and accepts no exit.
struct Stuck {
    TransformedHull hullA, hullB;
    glm::vec3 axis;  ///< a unit vector from the second to the first
    float gap;       ///< of the hulls along it, metres
    float voxel;     ///< the smaller one, metres
    float depth;     ///< of the feature, cells
    uint64_t key;    ///< of the parts
};

/// A contact for two parts that overlap so deeply that their features accept no exit: along a direction, at the centre
/// of what their bounds share, as if at most half a voxel deep.
ContactPoint stuckContact(const Stuck& stuck, const glm::vec3& direction) {
    glm::vec3 lowA, highA, lowB, highB;
    stuck.hullA.points.bounds(stuck.hullA.axes, lowA, highA);
    stuck.hullB.points.bounds(stuck.hullB.axes, lowB, highB);
    const glm::vec3 low = glm::max(stuck.hullA.corner + lowA, stuck.hullB.corner + lowB),
                    high = glm::min(stuck.hullA.corner + highA, stuck.hullB.corner + highB);
    ContactPoint contact;
    contact.position = (low + high) * 0.5f;
    contact.normal = direction;
    contact.separation = std::max(stuck.gap, -0.5f * stuck.voxel);
    contact.feature = stuck.key | uint64_t(kFeatureKinds) << 12;
    return contact;
}

/// The direction in which two bodies with a stuck feature are pushed apart: the hulls' axis if they have no contacts,
/// else the mean normal of these (another direction would make what is wedged between them spin, and the hull of a part
/// of a room is full where the room is hollow). Zero: no push.
glm::vec3 pushDirection(std::span<const ContactPoint> contacts, const glm::vec3& axis, float stuckDepth) {
    if (contacts.empty()) return axis;
    glm::vec3 sum(0.0f);
    for (const ContactPoint& contact : contacts) sum += contact.normal;
    const float length = glm::length(sum);
    return stuckDepth > kMinStuckDepth && length > kMinAgreement * float(contacts.size()) ? sum / length
                                                                                          : glm::vec3(0.0f);
}

/// Metres by which the round surface of one of two parts may stick out of the hull of its voxels.
float roundness(const ColliderPart& a, const ColliderPart& b) {
    const auto gap = [](const ColliderPart& part) { return part.round() ? part.voxelSize() : 0.0; };
    return kMaxRoundGap * float(std::max(gap(a), gap(b)));
}

/// Metres that are free around a part, if no brick of a large one lies within a few of its cells; else 0. Without it,
/// what is inside of a hollow part would be searched in every step.
float clearanceIn(const ColliderPart& large, const CellTransform& largeCells, const ColliderPart& part,
                  const CellTransform& cells) {
    if (large.whole()) return 0.0f;
    const double size = large.voxelSize();
    const glm::dmat3 toLarge = metresToCells(largeCells, size), axes = toLarge * cells.axes;
    const CellBox& own = part.bounds();
    const glm::dvec3 half = glm::dvec3(own.high - own.low) * 0.5,
                     middle = toLarge * (cells.corner - largeCells.corner) + axes * (glm::dvec3(own.low) + half),
                     around = rotatedHalfExtent(axes, half) + kClearCells;
    const glm::vec3 low(middle - around), high(middle + around);
    const bool isFree = !Occupancy(large).mayContainBrick(floorOf(float4(low)), floorOf(float4(high)));
    return isFree ? float(kClearCells * size) : 0.0f;
}

/// How near two parts are: a unit vector from the second to the first, their hulls along it, and the distance up to
/// which anything is searched, metres.
struct Approach {
    glm::vec3 axis;
    HullGap hulls;
    float near;
};

/// What may lie around the parts of two colliders: the other parts of each, and other static objects.
struct Surroundings {
    std::array<const VoxelCollider*, 2> colliders;
    std::array<std::span<const CellTransform>, 2> cells;
    std::array<glm::dvec3, 2> offsets;  ///< of the colliders' frames from the first's
    StaticNeighbours neighbours;

    /// Whether there is nothing.
    bool empty() const {
        return colliders[0]->parts.size() == 1 && colliders[1]->parts.size() == 1 && neighbours.pairs.size() <= 1;
    }
    /// Finds what lies around part `i` of a collider and is touched by `other`.
    void find(size_t side, size_t i, const ColliderPart& other, Cover& cover) const {
        const ColliderPart& part = *colliders[side]->parts[i];
        const CellTransform partCells = at(side, i);
        const double gap = kSeam * part.voxelSize();
        const auto add = [&](const ColliderPart& solid, const CellTransform& solidCells) {
            if (solid.grid().empty() || solid.round() || !solid.filter().meets(other.filter())) return;
            if (widened(boxOf(part, partCells), gap).overlaps(boxOf(solid, solidCells)))
                cover.add(solid, solidCells, partCells);
        };
        for (size_t k = 0; k < colliders[side]->parts.size(); ++k)
            if (k != i) add(*colliders[side]->parts[k], at(side, k));
        if (side == 0 || neighbours.pairs.size() <= 1) return;
        const CollisionObject& own = *neighbours.pairs[neighbours.own].second;
        for (const ObjectPair& pair : neighbours.pairs) {
            const CollisionObject& object = *pair.second;
            if (&object == &own || !widened({own.low, own.high}, gap).overlaps({object.low, object.high})) continue;
            for (size_t k = 0; k < object.collider.parts.size(); ++k)
                add(*object.collider.parts[k],
                    moved(object.cellTransforms()[k], object.pose.position - own.pose.position + offsets[1]));
        }
    }
    /// Of a part, about the first's frame origin.
    CellTransform at(size_t side, size_t i) const { return moved(cells[side][i], offsets[side]); }

private:
    static CellTransform moved(const CellTransform& cells, const glm::dvec3& by) {
        return {cells.axes, cells.corner + by};
    }
    static WorldBox boxOf(const ColliderPart& part, const CellTransform& cells) {
        const CellBox& box = part.bounds();
        const glm::dvec3 middle = cells.corner + cells.axes * (glm::dvec3(box.low + box.high) * 0.5),
                         half = rotatedHalfExtent(cells.axes, glm::dvec3(box.high - box.low) * 0.5);
        return {middle - half, middle + half};
    }
    static WorldBox widened(const WorldBox& box, double by) { return {box.low - by, box.high + by}; }
};

/// Appends the contacts of two parts of voxels that are near each other. stuck: the deepest so far.
void collideVoxels(const CoveredPart& a, const TransformedHull& hullA, const CoveredPart& b,
                   const TransformedHull& hullB, const RelativeMotion& motion, const NarrowphaseSettings& settings,
                   const Approach& approach, uint64_t key, ContactSearch& search, std::vector<ContactPoint>& out,
                   std::optional<Stuck>& stuck) {
    const auto& [axis, hulls, near] = approach;
    FeatureCollider forward(a, b);
    forward.setMotion(motion.velocity, motion.spin, settings, motion.maxDisplacement);
    forward.setLimit(axis, hulls.b.distance() + near, a.cells);
    if (!forward.collide(true, key, search, out)) return;
    FeatureCollider backward(b, a);
    backward.setMotion(-motion.velocity, -motion.spin, settings, motion.maxDisplacement);
    backward.setLimit(-axis, hulls.a.distance() + near, b.cells);
    backward.collide(false, key | 1, search, out);
    const float depth = std::max(forward.stuckDepth(), backward.stuckDepth()), gap = hulls.distance();
    if (depth > (stuck ? stuck->depth : 0.0f) && gap < 0.0f)
        stuck.emplace(
            Stuck{hullA, hullB, axis, gap, float(std::min(a.part.voxelSize(), b.part.voxelSize())), depth, key});
}

/// Appends the contacts of part i of the first collider with part k of the second. search: its axis, from the second to
/// the first, is that of the step before, and is replaced by a better one; its clearance shrinks to that of these
/// parts. stuck: the deepest so far. Returns whether the parts are near each other.
bool collideParts(const Surroundings& around, size_t i, size_t k, const RelativeMotion& motion,
                  const NarrowphaseSettings& settings, ContactSearch& search, std::vector<ContactPoint>& out,
                  std::optional<Stuck>& stuck) {
    glm::vec3& axis = search.axis;
    const bool hasAxis = axis != glm::vec3(0.0f);
    const ColliderPart &a = *around.colliders[0]->parts[i], &b = *around.colliders[1]->parts[k];
    const CellTransform aCells = around.at(0, i), bCells = around.at(1, k);
    const uint64_t key = uint64_t(i & 31) << 6 | uint64_t(k & 31) << 1;
    const float size = float(std::max(a.voxelSize(), b.voxelSize()));
    const float searched = float(settings.margin) + kSearchDistance * size + roundness(a, b),
                closing = motion.sweeps ? float(motion.maxDisplacement) : 0.0f;
    if (const float clearance = clearanceIn(b, bCells, a, aCells) - searched; clearance > closing) {
        search.clearance = std::min(search.clearance, clearance);
        return false;
    }
    const TransformedHull hullA = transformHull(a, aCells), hullB = transformHull(b, bCells);
    if (!hasAxis) axis = centerAxis(a, hullA, b, hullB);
    const HullGap hulls = refineSeparatingAxis(hullA, hullB, searched + closing,
                                               hasAxis ? kKnownPairIterations : kNewPairIterations, axis);
    const float gap = hulls.distance();
    const float near = searched + motion.closingDistance(axis, double(searched));
    if (gap > near) {
        search.clearance = std::min(search.clearance, gap - searched);
        return false;
    }
    Cover aCover, bCover;
    if (!around.empty()) around.find(0, i, b, aCover), around.find(1, k, a, bCover);
    const CoveredPart first{a, aCells, aCover.empty() ? nullptr : &aCover},
        second{b, bCells, bCover.empty() ? nullptr : &bCover};
    if (a.round() || b.round())
        collideRound({first, {}, motion.firstVelocity, motion.firstSpin},
                     {second, motion.offset, motion.secondVelocity, motion.secondSpin}, settings, key, out);
    else
        collideVoxels(first, hullA, second, hullB, motion, settings, {axis, hulls, near}, key, search, out, stuck);
    return true;
}

/// Whether both are one box each, and can move. What is static often consists of many shapes, whose seams must be no
/// bumps: voxels know them.
bool areLoneBoxes(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion) {
    return firstMotion.radius > 0.0 && secondMotion.radius > 0.0 && first.parts.size() == 1 &&
           second.parts.size() == 1 && first.parts[0]->box() && second.parts[0]->box();
}

/// See findContacts().
bool collideLoneBoxes(const ColliderPart& first, const Motion& firstMotion, const ColliderPart& second,
                      const Motion& secondMotion, const NarrowphaseSettings& settings, ContactSearch& search,
                      std::vector<ContactPoint>& out) {
    if (!first.filter().meets(second.filter())) return false;
    const glm::dvec3 offset = secondMotion.pose.position - firstMotion.pose.position;
    const CellTransform& own = secondMotion.cellTransforms[0];
    const CellTransform secondCells{own.axes, own.corner + offset};
    return collideBoxes({{first, firstMotion.cellTransforms[0]}, {}, firstMotion.velocity, firstMotion.angularVelocity},
                        {{second, secondCells}, offset, secondMotion.velocity, secondMotion.angularVelocity}, settings,
                        0, search, out);
}

/// See findContacts().
bool collideAllParts(const Surroundings& around, const RelativeMotion& motion, const NarrowphaseSettings& settings,
                     ContactSearch& search, std::vector<ContactPoint>& out) {
    const VoxelCollider &first = *around.colliders[0], &second = *around.colliders[1];
    bool isNear = false;
    std::optional<Stuck> stuck;
    const bool isOnePair = first.parts.size() == 1 && second.parts.size() == 1;
    for (size_t i = 0; i < first.parts.size(); ++i)
        for (size_t k = 0; k < second.parts.size(); ++k) {
            const ColliderPart &a = *first.parts[i], &b = *second.parts[k];
            if (a.grid().empty() || b.grid().empty() || !a.filter().meets(b.filter())) continue;
            if (!isOnePair) search.axis = glm::vec3(0.0f);
            isNear |= collideParts(around, i, k, motion, settings, search, out, stuck);
        }
    if (!isOnePair) search.axis = glm::vec3(0.0f);
    if (!stuck) return isNear;
    if (const glm::vec3 push = pushDirection(out, stuck->axis, stuck->depth); push != glm::vec3(0.0f))
        out.push_back(stuckContact(*stuck, push));
    return isNear;
}

}  // namespace

double maxRelativeDisplacement(const Motion& first, const Motion& second, double seconds) {
    return (glm::length(first.velocity - second.velocity) + glm::length(first.angularVelocity) * first.radius +
            glm::length(second.angularVelocity) * second.radius) *
           seconds;
}

bool findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion, const NarrowphaseSettings& settings, ContactSearch& search,
                  std::vector<ContactPoint>& out, const StaticNeighbours& neighbours) {
    search.turn += search.leftOut > 0;
    search.leftOut = 0;
    search.clearance = std::numeric_limits<float>::max();
    bool isNear;
    if (areLoneBoxes(first, firstMotion, second, secondMotion)) {
        isNear = collideLoneBoxes(*first.parts[0], firstMotion, *second.parts[0], secondMotion, settings, search, out);
    } else {
        const RelativeMotion motion(firstMotion, secondMotion, settings);
        isNear = collideAllParts({{&first, &second},
                                  {firstMotion.cellTransforms, secondMotion.cellTransforms},
                                  {glm::dvec3(0.0), motion.offset},
                                  neighbours},
                                 motion, settings, search, out);
    }
    if (isNear) search.clearance = 0.0f;
    return isNear;
}

}  // namespace rubble
