#include "physics/collision/manifold.h"

#include <algorithm>
#include <cmath>

#include "physics/collision/friction_patch.h"

namespace rubble {
namespace {

constexpr float kSameDirection = 0.8f;  ///< cosine between normals that count as one direction
/// Distance from a line, in units of its length, below which a point adds nothing to the line's ends.
constexpr float kMinLineDistance = 0.02f;
// Points that were kept in the last step are preferred, so that the choice does not flicker:
constexpr float kKeptDepthBonus = 0.001f;    ///< metres by which they count as deeper
constexpr float kKeptDistanceFactor = 2.0f;  ///< by which they count as farther out
/// Metres apart up to which a point touches; where all are apart, metres farther than the nearest.
constexpr float kTouching = 0.002f;
/// Metres by which a point of a hit that is farther than the deepest one touches later, if at all.
constexpr float kLater = 0.03f;
/// Metres inside the static world above which a penetration is no error of stepping.
constexpr float kMinInitialPenetration = 0.02f;
/// Closing speed, m/s, below which a point bears a load at rest.
constexpr float kMaxLoadSpeed = 0.5f;

bool wasKept(const Manifold* before, uint64_t feature) {
    if (before)
        for (const ManifoldPoint& point : before->all())
            if (point.feature == feature) return true;
    return false;
}

/// Moves points of contacts[from + count, to) behind the first `count`, as long as one lies outside of their polygon
/// and there are fewer than `most`. Returns how many are chosen then. normal: of the polygon. before: what was kept
/// there counts as farther out; null: nothing does.
size_t widenPolygon(std::vector<ContactPoint>& contacts, size_t from, size_t count, size_t to, size_t most,
                    const glm::vec3& normal, const Manifold* before) {
    for (; count < most && from + count < to; ++count) {
        glm::vec3 middle(0.0f);
        for (size_t i = from; i < from + count; ++i) middle += contacts[i].position / float(count);
        std::array<glm::vec3, kMaxManifoldPoints> corners;
        for (size_t i = 0; i < count; ++i) corners[i] = contacts[from + i].position - middle;
        sortAround(std::span(corners).first(count), glm::vec3(0.0f), normal);
        float farthest = 0.0f, size = 0.0f;
        size_t best = to;
        for (size_t i = from + count; i < to; ++i) {
            const glm::vec3 p = contacts[i].position - middle;
            float outside = 0.0f;
            for (size_t k = 0; k < count; ++k) {
                const glm::vec3 edge = corners[(k + 1) % count] - corners[k];
                const float length = std::sqrt(glm::dot(edge, edge));
                size = std::max(size, length);
                if (!(length > 0.0f)) continue;
                outside = std::max(outside, glm::dot(glm::cross(edge, normal), p - corners[k]) / length);
                if (count == 2 && most > 4)  // a line, which ends; what rests would change its points
                    outside = std::max(outside, std::abs(glm::dot(edge, p)) / length - 0.5f * length);
            }
            if (outside > 0.0f && wasKept(before, contacts[i].feature)) outside *= kKeptDistanceFactor;
            if (outside > farthest) farthest = outside, best = i;
        }
        if (!(farthest > kMinLineDistance * size)) break;
        std::swap(contacts[from + count], contacts[best]);
    }
    return count;
}

/// Moves up to `most` of contacts[from, to) to the front: the deepest, which is there already, the one farthest from
/// it, the one farthest from their line, the one farthest from the line on the other side, and those outside of the
/// polygon of these. Returns how many.
size_t chooseWidest(std::vector<ContactPoint>& contacts, size_t from, size_t to, size_t most, const Manifold* before) {
    if (to - from <= 4) return to - from;
    const auto best = [&](size_t first, auto&& score) {
        size_t found = first;
        float highest = -1e30f;
        for (size_t i = first; i < to; ++i) {
            float value = score(contacts[i]);
            if (value > 0 && wasKept(before, contacts[i].feature)) value *= kKeptDistanceFactor;
            if (value > highest) highest = value, found = i;
        }
        std::swap(contacts[first], contacts[found]);
        return highest;
    };
    const glm::vec3 deepest = contacts[from].position, normal = contacts[from].normal;
    best(from + 1, [&](const ContactPoint& c) { return glm::dot(c.position - deepest, c.position - deepest); });
    const glm::vec3 side = glm::cross(contacts[from + 1].position - deepest, normal);
    const auto across = [&](const ContactPoint& c) { return glm::dot(side, c.position - deepest); };
    // Of many points in one line, another would be chosen in every step.
    const float inLine = kMinLineDistance * glm::dot(side, side);
    if (best(from + 2, [&](const ContactPoint& c) { return std::abs(across(c)); }) < inLine) return 2;
    const float sign = across(contacts[from + 2]) > 0 ? -1.0f : 1.0f;
    if (best(from + 3, [&](const ContactPoint& c) { return sign * across(c); }) < inLine) return 3;
    return most > 4 ? widenPolygon(contacts, from, 4, to, most, normal, nullptr) : 4;
}

/// Moves what has a separation up to a limit before the rest of contacts[from, to); returns where that begins.
size_t partitionBySeparation(std::vector<ContactPoint>& contacts, size_t from, size_t to, float limit) {
    for (;; ++from, --to) {
        while (from < to && contacts[from].separation <= limit) ++from;
        while (from < to && contacts[to - 1].separation > limit) --to;
        if (from == to) return from;
        std::swap(contacts[from], contacts[to - 1]);
    }
}

/// As chooseWidest(), but what touches goes before what would touch if the body tipped: else it tips, as nothing bears
/// it there. And what touches about as soon as the deepest goes before what touches later: a ball that hits a wall with
/// one layer of voxels would turn about one of its corners if the wider layer behind took the others' places.
size_t chooseWidestPoints(std::vector<ContactPoint>& contacts, size_t from, size_t to, size_t most,
                          const Manifold* before) {
    if (to - from <= 4) return to - from;
    const float deepest = contacts[from].separation;
    size_t count = 1, done = from + 1;
    for (const float limit : {std::max(deepest, 0.0f) + kTouching, deepest + kLater, 1e30f}) {
        done = partitionBySeparation(contacts, done, to, limit);
        if (count == 1)
            count = chooseWidest(contacts, from, done, most, before);
        else
            count = widenPolygon(contacts, from, count, done, most, contacts[from].normal, before);
    }
    return count;
}

/// Warm start: points that were there before get the impulses they had. The impulses of points that are gone are shared
/// equally among the new points of their direction.
void inheritImpulses(const Manifold& before, Manifold& now) {
    std::array<bool, kMaxManifoldPoints> taken{}, known{};
    for (int i = 0; i < now.count; ++i)
        for (int k = 0; k < before.count; ++k)
            if (!taken[size_t(k)] && !known[size_t(i)] &&
                before.points[size_t(k)].feature == now.points[size_t(i)].feature &&
                glm::dot(before.points[size_t(k)].normal, now.points[size_t(i)].normal) > kSameDirection) {
                now.points[size_t(i)].normalImpulse = before.points[size_t(k)].normalImpulse;
                now.points[size_t(i)].frictionImpulse = before.points[size_t(k)].frictionImpulse;
                now.points[size_t(i)].isPressed = pressesOn(before.points[size_t(k)]);
                taken[size_t(k)] = known[size_t(i)] = true;
            }
    if (before.count == 1 && now.count == 1 && glm::dot(before.points[0].normal, now.points[0].normal) > kSameDirection)
        now.torsionImpulse = before.torsionImpulse;
    for (int k = 0; k < before.count; ++k) {
        const ManifoldPoint& gone = before.points[size_t(k)];
        if (taken[size_t(k)] || gone.normalImpulse == 0.0f) continue;
        const auto takes = [&](int i) {
            return !known[size_t(i)] && glm::dot(now.points[size_t(i)].normal, gone.normal) > kSameDirection;
        };
        int heirs = 0;
        for (int i = 0; i < now.count; ++i) heirs += takes(i);
        for (int i = 0; i < now.count; ++i)
            if (takes(i)) {
                now.points[size_t(i)].normalImpulse += gone.normalImpulse / float(heirs);
                now.points[size_t(i)].frictionImpulse += gone.frictionImpulse / float(heirs);
            }
    }
}

/// Groups contacts by direction: moves those of the direction of the deepest one of contacts[from, ...) to its front,
/// the deepest first, and returns where they end.
size_t groupDirection(std::vector<ContactPoint>& contacts, size_t from, const Manifold* before) {
    size_t deepest = from;
    float lowest = 1e9f;
    if (contacts.size() <= 4) before = nullptr;  // all are kept
    for (size_t i = from; i < contacts.size(); ++i) {
        const float separation =
            contacts[i].separation - (wasKept(before, contacts[i].feature) ? kKeptDepthBonus : 0.0f);
        if (separation < lowest) lowest = separation, deepest = i;
    }
    std::swap(contacts[from], contacts[deepest]);
    const glm::vec3 normal = contacts[from].normal;
    size_t to = from + 1;
    for (size_t i = to; i < contacts.size(); ++i)
        if (glm::dot(contacts[i].normal, normal) > kSameDirection) std::swap(contacts[to++], contacts[i]);
    return to;
}

}  // namespace

bool pressesOn(const ManifoldPoint& point) {
    return point.normalImpulse > 0.0f && (point.isPressed || point.approach < kMaxLoadSpeed);
}

void updateAllowedPenetration(Manifold& manifold, float before) {
    float deepest = 0.0f;
    for (const ManifoldPoint& point : manifold.all()) deepest = std::max(deepest, -point.separation);
    manifold.allowedPenetration = deepest > kMinInitialPenetration ? std::min(deepest, before) : 0.0f;
}

float effectiveSeparation(const Manifold& manifold, const ManifoldPoint& point, const glm::vec3& up) {
    const bool isLifted = point.separation < -kMinInitialPenetration && glm::dot(point.normal, up) > 0.0f;
    return isLifted ? std::min(point.separation + manifold.allowedPenetration, 0.0f) : point.separation;
}

/// Each direction keeps a point at least: without it, what two near walls touch would pass a third one.
void reduceContacts(std::vector<ContactPoint>& contacts, const Manifold* before, const ManifoldLimits& limits,
                    Manifold& out) {
    struct Direction {
        size_t from, kept;
        float patchRadius;
    };
    std::array<Direction, kMaxManifoldPoints> directions;
    const bool isWhole = contacts.size() < kEnoughContacts;
    int count = 0;
    for (size_t from = 0; from < contacts.size() && count < limits.total;) {
        const size_t to = groupDirection(contacts, from, before);
        Direction& direction = directions[size_t(count++)];
        direction = {from, 0, isWhole ? meanPatchRadius({contacts.data() + from, to - from}, out) : 0.0f};
        direction.kept = chooseWidestPoints(contacts, from, to, size_t(limits.perDirection), before);
        from = to;
    }
    out.count = 0;
    for (int i = 0; i < count; ++i) {
        const Direction& direction = directions[size_t(i)];
        const size_t share = size_t(limits.total / count);
        for (size_t k = 0; k < std::min(direction.kept, share); ++k)
            out.points[size_t(out.count++)] = {contacts[direction.from + k]};
    }
    if (before) inheritImpulses(*before, out);
    for (size_t from = 0, i = 0; i < size_t(count); ++i) {
        const size_t kept = std::min(directions[i].kept, size_t(limits.total / count));
        insetFriction({out.points + from, kept}, directions[i].patchRadius);
        from += kept;
    }
}

}  // namespace rubble
