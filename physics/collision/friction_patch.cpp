#include "physics/collision/friction_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "physics/bodies/collision_object.h"
#include "physics/collision/box_contacts.h"

// Friction of an area by a few points.
//
// An area under even pressure resists spin about its middle by mu N r, with its mean distance r from the middle: 2/3 of
// the radius of a disc. The few points of a manifold lie at its corners and would resist 1.5 times as much. Nothing
// measures the area, but the edges of voxels around it are among the contacts. By Green's theorem they suffice: with
// the outward normal n of an edge of length l at p,
//     area = 1/2 sum l (p . n),   integral of p = 1/3 sum l p (p . n),   integral of |p| = 1/3 sum l |p| (p . n),
// holes and separate feet included. Of two boxes the contacts are the corners of the area.

namespace rubble {
namespace {

constexpr float kSameDepth = 0.002f;     ///< metres beyond the deepest contact in which others touch
constexpr float kMaxSideCosine2 = 0.3f;  ///< between the side of an edge and the contact's normal
constexpr float kMinArea = 1e-8f;        ///< m2
constexpr float kLineShare = 0.5f;       ///< mean distance in a line, of that of its ends

/// The edges of voxels around the area, of the contacts.
class BoundaryEdges {
public:
    BoundaryEdges(std::span<const ContactPoint> contacts, const Manifold& manifold)
        : m_contacts(contacts), m_manifold(manifold) {}
    /// Calls f(p, flux) with the middle p of each edge, from the first contact, and flux = l n.
    template <class F>
    void forEach(F&& f) {
        for (const ContactPoint& contact : m_contacts) {
            const uint32_t kind = contact.feature >> 12 & 31;
            if (kind >= uint32_t(kFeatureKinds) || featureKinds()[kind].edgeAxis < 0) continue;
            if (contact.separation > m_contacts[0].separation + kSameDepth || !selectPart(contact)) continue;
            const FeatureKind& feature = featureKinds()[kind];
            const int u = (feature.edgeAxis + 1) % 3, v = (feature.edgeAxis + 2) % 3;
            const float alongU = std::abs(glm::dot(m_axes[u], contact.normal)),
                        alongV = std::abs(glm::dot(m_axes[v], contact.normal));
            const int side = alongU < alongV ? u : v;
            if (std::min(alongU, alongV) < kMaxSideCosine2 * m_size)
                f(contact.position - m_contacts[0].position, m_axes[side] * feature.outward[side]);
        }
    }

private:
    /// Takes the axes of the part that a contact's feature belongs to.
    bool selectPart(const ContactPoint& contact) {
        const uint64_t part = contact.feature & 1 ? contact.feature & 63 : contact.feature & (31 << 6);
        if (part == m_part) return m_size > 0.0f;
        m_part = part, m_size = 0.0f;
        const CollisionObject* object = part & 1 ? m_manifold.objects.second : m_manifold.objects.first;
        if (!object) return false;
        m_axes = glm::mat3(object->cellTransforms()[part >> (part & 1 ? 1 : 6) & 31].axes);
        m_size = glm::length(m_axes[0]);
        return true;
    }

    std::span<const ContactPoint> m_contacts;
    const Manifold& m_manifold;
    uint64_t m_part = ~uint64_t(0);
    glm::mat3 m_axes{0.0f};  ///< of a cell, metres
    float m_size = 0.0f;
};

/// The sides of the area that two boxes share, whose corners are the contacts. Of several parts, the area around all.
class BoxEdges {
public:
    explicit BoxEdges(std::span<const ContactPoint> contacts) {
        glm::vec3 middle(0.0f);
        for (const ContactPoint& contact : contacts)
            if (contact.separation <= contacts[0].separation + kSameDepth && m_count < m_corners.size())
                middle += m_corners[m_count++] = contact.position - contacts[0].position;
        if (m_count) middle /= float(m_count);
        m_normal = contacts[0].normal;
        sortAround(std::span(m_corners).first(m_count), middle, m_normal);
    }
    /// As BoundaryEdges does, in several parts of each side.
    template <class F>
    void forEach(F&& f) const {
        for (size_t i = 0; i < m_count; ++i) {
            const glm::vec3 &from = m_corners[i], part = (m_corners[(i + 1) % m_count] - from) / float(kParts),
                            flux = glm::cross(part, m_normal);
            for (int k = 0; k < kParts; ++k) f(from + part * (float(k) + 0.5f), flux);
        }
    }

private:
    static constexpr int kParts = 3;
    std::array<glm::vec3, 32> m_corners;
    size_t m_count = 0;
    glm::vec3 m_normal;
};

template <class Edges>
float meanRadius(Edges&& edges) {
    float area = 0.0f;
    glm::vec3 moment(0.0f);
    edges.forEach([&](const glm::vec3& at, const glm::vec3& flux) {
        const float through = glm::dot(at, flux);
        area += through / 2.0f, moment += at * (through / 3.0f);
    });
    if (!(area > kMinArea)) return 0.0f;
    const glm::vec3 middle = moment / area;
    float distances = 0.0f;
    edges.forEach([&](const glm::vec3& at, const glm::vec3& flux) {
        const glm::vec3 from = at - middle;
        distances += glm::dot(from, flux) * std::sqrt(glm::dot(from, from)) / 3.0f;
    });
    return std::max(distances / area, 0.0f);
}

}  // namespace

void sortAround(std::span<glm::vec3> points, const glm::vec3& middle, const glm::vec3& normal) {
    if (points.empty()) return;
    const glm::vec3 x = points[0] - middle, y = glm::cross(normal, x);
    std::sort(points.begin(), points.end(), [&](const glm::vec3& a, const glm::vec3& b) {
        const glm::vec2 p(glm::dot(a - middle, x), glm::dot(a - middle, y)),
            q(glm::dot(b - middle, x), glm::dot(b - middle, y));
        const bool isLowP = p.y < 0.0f, isLowQ = q.y < 0.0f;
        return isLowP != isLowQ ? isLowQ : p.x * q.y - p.y * q.x > 0.0f;
    });
}

float meanPatchRadius(std::span<const ContactPoint> contacts, const Manifold& manifold) {
    if (contacts.size() < 3) return 0.0f;
    const bool isOfBoxes = (contacts[0].feature >> 12 & 31) == kBoxKind;
    return isOfBoxes ? meanRadius(BoxEdges(contacts)) : meanRadius(BoundaryEdges(contacts, manifold));
}

void insetFriction(std::span<ManifoldPoint> points, float meanRadius) {
    float pressure = 0.0f;
    for (const ManifoldPoint& point : points) pressure += point.normalImpulse;
    const auto weightOf = [&](const ManifoldPoint& point) {
        return pressure > 0.0f ? point.normalImpulse / pressure : 1.0f / float(points.size());
    };
    glm::vec3 middle(0.0f);
    for (const ManifoldPoint& point : points) middle += point.position * weightOf(point);
    float distance = 0.0f;
    for (const ManifoldPoint& point : points) distance += weightOf(point) * glm::length(point.position - middle);
    const bool isLine = points.size() == 2 && (points[0].feature & (kFirstIsRound | kSecondIsRound));
    const float share = isLine                                 ? kLineShare
                        : meanRadius > 0.0f && distance > 0.0f ? std::min(meanRadius / distance, 1.0f)
                                                               : 1.0f;
    for (ManifoldPoint& point : points) point.frictionInset = (middle - point.position) * (1.0f - share);
}

}  // namespace rubble
