#include "physics/collision/manifold.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr float kSameDirection = 0.8f;  ///< cosine between normals that count as one direction
constexpr int kMaxPointsPerDirection = 4;
/// Distance from a line, in units of its length, below which a point adds nothing to the line's ends.
constexpr float kMinLineDistance = 0.02f;
// Points that were kept in the last step are preferred, so that the choice does not flicker:
constexpr float kKeptDepthBonus = 0.001f;    ///< metres by which they count as deeper
constexpr float kKeptDistanceFactor = 2.0f;  ///< by which they count as farther out
/// Metres inside the static world above which a penetration is no error of stepping.
constexpr float kMinInitialPenetration = 0.02f;

bool wasKept(const Manifold* before, uint64_t feature) {
    if (before)
        for (const ManifoldPoint& point : before->all())
            if (point.feature == feature) return true;
    return false;
}

/// Moves up to four of contacts[from, to) to the front: the deepest, which is there already, the one farthest from it,
/// the one farthest from their line, and the one farthest from the line on the other side. Returns how many.
size_t chooseWidestPoints(std::vector<ContactPoint>& contacts, size_t from, size_t to, const Manifold* before) {
    if (to - from <= kMaxPointsPerDirection) return to - from;
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
    return best(from + 3, [&](const ContactPoint& c) { return sign * across(c); }) < inLine ? 3 : 4;
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
                taken[size_t(k)] = known[size_t(i)] = true;
            }
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

}  // namespace

void updateAllowedPenetration(Manifold& manifold, float before) {
    float deepest = 0.0f;
    for (const ManifoldPoint& point : manifold.all()) deepest = std::max(deepest, -point.separation);
    manifold.allowedPenetration = deepest > kMinInitialPenetration ? std::min(deepest, before) : 0.0f;
}

float effectiveSeparation(const Manifold& manifold, const ManifoldPoint& point, const glm::vec3& up) {
    const bool isLifted = point.separation < -kMinInitialPenetration && glm::dot(point.normal, up) > 0.0f;
    return isLifted ? std::min(point.separation + manifold.allowedPenetration, 0.0f) : point.separation;
}

void reduceContacts(std::vector<ContactPoint>& contacts, const Manifold* before, Manifold& out) {
    out.count = 0;
    size_t from = 0;
    while (from < contacts.size() && out.count < kMaxManifoldPoints) {
        size_t deepest = from;
        float lowest = 1e9f;
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
        const size_t kept = chooseWidestPoints(contacts, from, to, before);
        for (size_t i = from; i < from + kept && out.count < kMaxManifoldPoints; ++i)
            out.points[size_t(out.count++)] = {contacts[i]};
        from = to;
    }
    if (before) inheritImpulses(*before, out);
}

}  // namespace rubble
