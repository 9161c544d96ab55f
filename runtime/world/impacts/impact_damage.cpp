#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "runtime/core/random.h"
#include "runtime/destruction/fragment_style.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

constexpr int kContactCells = 2;  ///< how far from the contact that physics reports the voxel that was hit may be

/// The material of the voxel nearest to a point in cells; 0 if there is none near.
uint8_t materialAt(const Shape& shape, glm::dvec3 pointCells) {
    const glm::ivec3 middle(glm::floor(pointCells));
    double nearest2 = std::numeric_limits<double>::infinity();
    uint8_t found = 0;
    for (int z = -kContactCells; z <= kContactCells; ++z)
        for (int y = -kContactCells; y <= kContactCells; ++y)
            for (int x = -kContactCells; x <= kContactCells; ++x) {
                const glm::ivec3 cell = middle + glm::ivec3(x, y, z);
                const uint8_t entry = shape.grid.at(cell);
                const glm::dvec3 offset = glm::dvec3(cell) + 0.5 - pointCells;
                if (!entry || !(glm::dot(offset, offset) < nearest2)) continue;
                nearest2 = glm::dot(offset, offset);
                found = (*shape.palette)[entry].material;
            }
    return found;
}

}  // namespace

/// What an impact breaks of one of its two bodies: the broken area grows with the impulse, so the radius with its root.
void World::addImpactDamage(const Impact& impact, BodyHandle body, Edits& out) const {
    for (const ShapeHandle handle : shapesNear(impact.position, 0.3)) {
        const Shape& shape = m_shapes.at(handle);
        if (shape.body != body) continue;
        const Material& material = m_materials[materialAt(
            shape, shapeToWorld(handle).inversePoint(impact.position) / double(shape.voxelSize))];
        if (material.hardness > Hardness::Hard) continue;
        const size_t hardness = size_t(material.hardness);
        const double force = impact.impulse / (m_settings.impactThreshold * impactToughness(material));
        if (!(force >= 1.0)) continue;
        BreakEdit edit{.position = impact.position,
                       .seed = hashCell(int(m_step), int(body.slot()), int(handle.slot())),
                       .shape = handle};
        const double radius = std::min(m_settings.impactRadiusLimit, m_settings.impactRadius * std::sqrt(force));
        std::fill_n(edit.radii.begin(), hardness + 1, radius);
        out.push_back(edit);
    }
}

/// What an impact loads beyond the place that it hits. It comes after what it breaks there.
void World::addImpactLoad(const Impact& impact, BodyHandle body, Edits& out) const {
    const Body* struck = m_bodies.find(body);
    if (!m_stress || !struck || !(impact.impulse >= m_settings.stress.minImpulse)) return;
    if (!struck->isStatic && struck->shapes.size() != 1) return;
    for (const ShapeHandle handle : shapesNear(impact.position, 0.3)) {
        const Shape& shape = m_shapes.at(handle);
        if (shape.body != body || !shape.loadBearing) continue;
        if (!struck->isStatic && shape.grid.voxelCount() < m_settings.stress.minStruckVoxels) continue;
        const uint8_t material =
            materialAt(shape, shapeToWorld(handle).inversePoint(impact.position) / double(shape.voxelSize));
        if (!material || (struck->isStatic && m_materials[material].hardness > Hardness::Hard))
            continue;  // what falls on rock loads nothing
        out.push_back(ImpactLoadEdit{handle, impact.position,
                                     impact.normal * (body == impact.body ? impact.impulse : -impact.impulse)});
        return;
    }
}

Edits World::damageFrom(std::span<const Impact> impacts) const {
    Edits edits;
    if (impacts.empty()) return edits;
    std::vector<const Impact*> hardest;
    for (const Impact& impact : impacts) {
        double heavier = 0.0;
        for (const BodyHandle handle : {impact.body, impact.other})
            if (const Body* body = m_bodies.find(handle); body && !body->isStatic)
                heavier = std::max(heavier, bodyMass(handle).mass);
        if (impact.impulse >= m_settings.impactSpeed * heavier && impact.impulse > 0.0) hardest.push_back(&impact);
    }
    std::stable_sort(hardest.begin(), hardest.end(),
                     [](const Impact* a, const Impact* b) { return a->impulse > b->impulse; });
    size_t broken = 0;
    for (const Impact* impact : hardest) {
        const size_t before = edits.size();
        addImpactDamage(*impact, impact->body, edits);
        addImpactDamage(*impact, impact->other, edits);
        addImpactLoad(*impact, impact->body, edits);
        addImpactLoad(*impact, impact->other, edits);
        if (edits.size() > before && ++broken == m_settings.impactsPerStep) break;
    }
    return edits;
}

}  // namespace rubble
