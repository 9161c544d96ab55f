#include "runtime/world/break_through.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "runtime/destruction/fragment_style.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

constexpr double kContact = 0.2;  ///< metres: how far from the contact that physics reports the surface may be
constexpr double kStepInCells = 0.5;

/// What a hole meets on its way, seen in columns a voxel apart across the disc that it is.
struct Passage {
    const Material* wall = nullptr;  ///< the toughest of it near the middle; null if something stays there, or nothing was in the way
    double meanToughness = 0.0;      ///< over the disc: a pipe in the open stops less than a wall of pipes
};

class HoleWalk {
public:
    HoleWalk(const World& world, const BreakEdit& hole, glm::dvec3 way)
        : m_world(world), m_hole(hole), m_way(way), m_shape(world.shapes().at(hole.shape)), m_pose(world.shapeToWorld(hole.shape)) {}

    Passage passage() {
        const double voxel = double(m_shape.voxelSize);
        const glm::dvec3 u = glm::normalize(glm::cross(m_way, std::abs(m_way.y) < 0.7 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const glm::dvec3 v = glm::cross(m_way, u);
        const int across = int(m_hole.radii[0] / voxel);
        for (int j = -across; j <= across; ++j)
            for (int i = -across; i <= across; ++i) addColumn(u * (double(i) * voxel) + v * (double(j) * voxel));
        if (m_stays) m_passage.wall = nullptr;
        m_passage.meanToughness /= std::max(m_columns, 1);
        return m_passage;
    }

private:
    void addColumn(glm::dvec3 offset) {
        const double radius = m_hole.radii[0], out2 = glm::dot(offset, offset);
        if (out2 > radius * radius) return;
        ++m_columns;
        const bool isMiddle = out2 <= kContact * kContact;
        const Material* toughest = nullptr;
        for (double depth = -kContact; depth < radius; depth += kStepInCells * double(m_shape.voxelSize)) {
            const Material* material = materialAt(m_hole.position + offset + m_way * depth);
            if (!material) {
                if (isMiddle && toughest) break;  // out on the other side
                continue;
            }
            const bool goes = material->hardness <= Hardness::Hard && out2 + depth * depth < reach2(material->hardness);
            if (isMiddle && (!goes || depth + kStepInCells * double(m_shape.voxelSize) >= radius)) m_stays = true;
            if (goes && (!toughest || impactToughness(*material) > impactToughness(*toughest))) toughest = material;
        }
        if (!toughest) return;
        m_passage.meanToughness += impactToughness(*toughest);
        if (isMiddle && (!m_passage.wall || impactToughness(*toughest) > impactToughness(*m_passage.wall))) m_passage.wall = toughest;
    }
    double reach2(Hardness hardness) const { return m_hole.radii[size_t(hardness)] * m_hole.radii[size_t(hardness)]; }
    const Material* materialAt(glm::dvec3 point) const {
        const uint8_t entry = m_shape.grid.at(glm::ivec3(glm::floor(m_pose.inversePoint(point) / double(m_shape.voxelSize))));
        return entry ? &m_world.materials()[(*m_shape.palette)[entry].material] : nullptr;
    }

    const World& m_world;
    const BreakEdit& m_hole;
    glm::dvec3 m_way;
    const Shape& m_shape;
    Pose m_pose;
    Passage m_passage;
    int m_columns = 0;
    bool m_stays = false;
};

/// N s that a hole takes: the broken area grows with the impulse, as in World::addImpactDamage(). A pane takes no more than
/// what it breaks at, wherever its cracks end.
double impulseOf(const BreakEdit& hole, const Passage& passage, const WorldSettings& settings) {
    if (fragmentStyle(passage.wall->fragments).wholePane) return settings.impactThreshold * impactToughness(*passage.wall);
    const double ratio = hole.radii[0] / settings.impactRadius;
    return settings.impactThreshold * passage.meanToughness * std::max(1.0, ratio * ratio);
}

}  // namespace

void addBreakThrough(const World& world, std::span<const Impact> impacts, Edits& damage) {
    const size_t breaks = damage.size();
    for (size_t i = 0; i < breaks; ++i) {
        const auto* edit = std::get_if<BreakEdit>(&damage[i]);
        const Shape* shape = edit ? world.shapes().find(edit->shape) : nullptr;
        if (!shape || !world.bodies().at(shape->body).isStatic) continue;
        const BreakEdit hole = *edit;  // the list grows
        for (const Impact& impact : impacts) {
            if (impact.position != hole.position || (impact.body != shape->body && impact.other != shape->body)) continue;
            const bool hitterIsFirst = impact.other == shape->body;
            const BodyHandle hitter = hitterIsFirst ? impact.body : impact.other;
            const Body* body = world.bodies().find(hitter);
            if (!body || body->isStatic) break;
            const glm::dvec3 way = hitterIsFirst ? -impact.normal : impact.normal;
            const Passage passage = HoleWalk(world, hole, way).passage();
            if (!passage.wall) break;
            // No more than it came with: what something else presses through the wall is not thrown ahead of that.
            const double came = world.bodyMass(hitter).mass * impact.speed;
            const double spare = std::min(impact.impulse - impulseOf(hole, passage, world.settings()), came);
            if (spare > 0.0) damage.emplace_back(ImpulseEdit{hitter, impact.position, way * spare});
            break;
        }
    }
}

}  // namespace rubble
