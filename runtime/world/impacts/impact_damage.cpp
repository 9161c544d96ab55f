#include "runtime/world/impacts/impact_damage.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "runtime/core/random.h"
#include "runtime/destruction/fragment_style.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/nearest_voxel.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kContactRadius = 0.3;  ///< metres around a contact in which the shapes that it struck are searched
constexpr double kMaxHoleCells = 32.0;  ///< radius of a hole in cells: its cost is cubic
constexpr int kContactCells = 2;        ///< how far from the contact that physics reports the voxel that was hit may be

/// The material of the voxel nearest to a world point on a shape; 0 if none is within kContactCells.
uint8_t materialAt(const WorldData& world, ShapeHandle handle, glm::dvec3 point) {
    const Shape& shape = world.shapes.at(handle);
    const glm::dvec3 pointCells = shapeToWorld(world, handle).inversePoint(point) / double(shape.voxelSize);
    const glm::ivec3 middle = cellAt(pointCells);
    const auto cell = nearestVoxel(shape.grid, pointCells, {middle - kContactCells, middle + kContactCells + 1});
    return cell ? (*shape.palette)[shape.grid.at(*cell)].material : uint8_t(0);
}

/// What an impact breaks of one of its two bodies: the broken area is proportional to the impulse, so the radius grows
/// with its root. near: the shapes that it may have struck.
void addImpactDamage(const WorldData& world, const Impact& impact, std::span<const ShapeHandle> near, BodyHandle body,
                     Edits& out) {
    for (const ShapeHandle handle : near) {
        const Shape& shape = world.shapes.at(handle);
        if (shape.body != body) continue;
        const Material& material = world.materials[materialAt(world, handle, impact.position)];
        if (material.hardness > Hardness::Hard) continue;
        const size_t hardness = size_t(material.hardness);
        const double force = impact.impulse / (world.settings.impactThreshold * impactToughness(material));
        if (!(force >= 1.0)) continue;
        BreakEdit edit{.position = impact.position,
                       .seed = hashCell(int(world.step), int(body.slot()), int(handle.slot())),
                       .shape = handle};
        const double radius = std::min({world.settings.impactRadiusLimit, kMaxHoleCells * double(shape.voxelSize),
                                        world.settings.impactRadius * std::sqrt(force)});
        std::fill_n(edit.radii.begin(), hardness + 1, radius);
        out.push_back(edit);
    }
}

/// How an impact loads one of its two bodies as a whole, in addition to what it breaks where it hits.
void addImpactLoad(const WorldData& world, const Impact& impact, std::span<const ShapeHandle> near, BodyHandle body,
                   Edits& out) {
    const Body* struck = world.bodies.find(body);
    if (!world.stress || !struck || !(impact.impulse >= world.settings.stress.minImpulse)) return;
    if (!struck->isStatic && struck->shapes.size() != 1) return;
    for (const ShapeHandle handle : near) {
        const Shape& shape = world.shapes.at(handle);
        if (shape.body != body || !shape.loadBearing) continue;
        if (!struck->isStatic && shape.grid.voxelCount() < world.settings.stress.minStruckVoxels) continue;
        const uint8_t material = materialAt(world, handle, impact.position);
        if (!material || (struck->isStatic && world.materials[material].hardness > Hardness::Hard))
            continue;  // what falls on rock loads nothing
        out.push_back(ImpactLoadEdit{handle, impact.position,
                                     impact.normal * (body == impact.body ? impact.impulse : -impact.impulse)});
        return;
    }
}

}  // namespace

Edits impactDamage(const WorldData& world, std::span<const Impact> impacts) {
    Edits edits;
    if (impacts.empty()) return edits;
    std::vector<const Impact*> hardest;
    hardest.reserve(impacts.size());
    for (const Impact& impact : impacts) {
        double heavier = 0.0;
        for (const BodyHandle handle : {impact.body, impact.other})
            if (const Body* body = world.bodies.find(handle); body && !body->isStatic)
                heavier = std::max(heavier, bodyMass(world, handle).mass);
        if (impact.impulse >= world.settings.impactSpeed * heavier && impact.impulse > 0.0) hardest.push_back(&impact);
    }
    std::stable_sort(hardest.begin(), hardest.end(),
                     [](const Impact* a, const Impact* b) { return a->impulse > b->impulse; });
    size_t broken = 0;
    for (const Impact* impact : hardest) {
        const size_t before = edits.size();
        const std::vector<ShapeHandle> near = shapesNear(world, impact->position, kContactRadius);
        for (const BodyHandle body : {impact->body, impact->other}) addImpactDamage(world, *impact, near, body, edits);
        for (const BodyHandle body : {impact->body, impact->other}) addImpactLoad(world, *impact, near, body, edits);
        if (edits.size() > before && ++broken == world.settings.impactsPerStep) break;
    }
    return edits;
}

}  // namespace rubble
