#include "physics/collision/voxel_contacts.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "physics/collision/feature_collider.h"
#include "physics/collision/hull_separation.h"
#include "physics/collision/round_contacts.h"

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
// own. So seams between voxels are no bumps ("internal edges"), and aligned edges give no sideways push.

namespace rubble {
namespace {

/// Voxels, besides the margin, around a corner or edge in which contacts are searched.
constexpr float kSearchDistance = 0.15f;
/// Iterations of the search for a separating axis, for new pairs and for those with an axis of the step before.
constexpr int kNewPairIterations = 4, kKnownPairIterations = 1;
/// Depth in cells from which a stuck feature counts although other features have contacts.
constexpr float kMinStuckDepth = 0.25f;
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

/// The direction in which two bodies with a stuck feature are pushed apart: the hulls' axis if they have no contacts,
/// else the mean normal of these (another direction would make what is wedged between them spin). Zero: no push.
glm::vec3 pushDirection(std::span<const ContactPoint> contacts, const glm::vec3& axis, float stuckDepth) {
    if (contacts.empty()) return axis;
    glm::vec3 sum(0.0f);
    for (const ContactPoint& contact : contacts) sum += contact.normal;
    const float length = glm::length(sum);
    return stuckDepth > kMinStuckDepth && length > kMinAgreement * float(contacts.size()) ? sum / length
                                                                                          : glm::vec3(0.0f);
}

/// A contact for two parts that overlap so deeply that their features accept no exit: along the axis, at the centre of
/// what their bounds share, as if at most half a voxel deep.
ContactPoint stuckContact(const ColliderPart& a, const TransformedHull& hullA, const ColliderPart& b,
                          const TransformedHull& hullB, const glm::vec3& axis, float gap, uint64_t key) {
    glm::vec3 lowA, highA, lowB, highB;
    hullA.points.bounds(hullA.axes, lowA, highA);
    hullB.points.bounds(hullB.axes, lowB, highB);
    const glm::vec3 low = glm::max(hullA.corner + lowA, hullB.corner + lowB),
                    high = glm::min(hullA.corner + highA, hullB.corner + highB);
    ContactPoint contact;
    contact.position = (low + high) * 0.5f;
    contact.normal = axis;
    contact.separation = std::max(gap, -0.5f * float(std::min(a.voxelSize(), b.voxelSize())));
    contact.feature = key | uint64_t(kFeatureKinds) << 12;
    return contact;
}

/// Two parts, and what their contacts are computed from.
struct PartPair {
    const ColliderPart &a, &b;
    const CellTransform &aCells, &bCells;  ///< about the first body's frame origin
    uint64_t key;                          ///< bits of ContactPoint::feature
    /// Metres by which a round surface may stick out of the hull of its voxels.
    float roundness() const {
        return kMaxRoundGap * float(std::max(a.round() ? a.voxelSize() : 0.0, b.round() ? b.voxelSize() : 0.0));
    }
};

/// Appends the contacts of two parts. axis: a unit vector from b to a to start from, replaced by a better one; hasAxis:
/// it is that of the step before. Returns whether the parts are near each other.
bool collideParts(const PartPair& parts, const RelativeMotion& motion, const NarrowphaseSettings& settings,
                  bool hasAxis, glm::vec3& axis, std::vector<ContactPoint>& out) {
    const auto& [a, b, aCells, bCells, key] = parts;
    const TransformedHull hullA = transformHull(a, aCells), hullB = transformHull(b, bCells);
    if (!hasAxis) axis = centerAxis(a, hullA, b, hullB);
    const float size = float(std::max(a.voxelSize(), b.voxelSize()));
    const float searched = float(settings.margin) + kSearchDistance * size + parts.roundness(),
                closing = motion.sweeps ? float(motion.maxDisplacement) : 0.0f;
    const float gap = refineSeparatingAxis(hullA, hullB, searched + closing,
                                           hasAxis ? kKnownPairIterations : kNewPairIterations, axis);
    const float near = searched + motion.closingDistance(axis, double(searched));
    if (gap > near) return false;
    if (a.round() || b.round()) {
        collideRound({a, aCells, {}, motion.firstVelocity, motion.firstSpin},
                     {b, bCells, motion.offset, motion.secondVelocity, motion.secondSpin}, settings, key, out);
        return true;
    }
    const size_t before = out.size();
    FeatureCollider forward(a, aCells, b, bCells);
    forward.setMotion(motion.velocity, motion.spin, settings, motion.maxDisplacement);
    forward.setLimit(axis, hullB.support(axis) + near, aCells);
    if (!forward.collide(true, key, out)) return true;
    FeatureCollider backward(b, bCells, a, aCells);
    backward.setMotion(-motion.velocity, -motion.spin, settings, motion.maxDisplacement);
    backward.setLimit(-axis, hullA.support(-axis) + near, bCells);
    backward.collide(false, key | 1, out);
    if (const float stuck = std::max(forward.stuckDepth(), backward.stuckDepth()); stuck > 0.0f && gap < 0.0f) {
        const glm::vec3 push = pushDirection({out.data() + before, out.size() - before}, axis, stuck);
        if (push != glm::vec3(0.0f)) out.push_back(stuckContact(a, hullA, b, hullB, push, gap, key));
    }
    return true;
}

}  // namespace

double maxRelativeDisplacement(const Motion& first, const Motion& second, double seconds) {
    return (glm::length(first.velocity - second.velocity) + glm::length(first.angularVelocity) * first.radius +
            glm::length(second.angularVelocity) * second.radius) *
           seconds;
}

bool findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion, const NarrowphaseSettings& settings, glm::vec3& axis,
                  std::vector<ContactPoint>& out) {
    const RelativeMotion motion(firstMotion, secondMotion, settings);
    bool isNear = false;
    const bool isOnePair = first.parts.size() == 1 && second.parts.size() == 1;
    for (size_t i = 0; i < first.parts.size(); ++i)
        for (size_t j = 0; j < second.parts.size(); ++j) {
            const ColliderPart &a = *first.parts[i], &b = *second.parts[j];
            if (a.grid().empty() || b.grid().empty() || !a.filter().meets(b.filter())) continue;
            const CellTransform bCells{secondMotion.cellTransforms[j].axes,
                                       secondMotion.cellTransforms[j].corner + motion.offset};
            const uint64_t key = uint64_t(i & 31) << 6 | uint64_t(j & 31) << 1;
            glm::vec3 partAxis = axis;
            const bool hasAxis = isOnePair && axis != glm::vec3(0.0f);
            isNear |= collideParts({a, b, firstMotion.cellTransforms[i], bCells, key}, motion, settings, hasAxis,
                                   partAxis, out);
            if (isOnePair) axis = partAxis;
        }
    return isNear;
}

}  // namespace rubble
