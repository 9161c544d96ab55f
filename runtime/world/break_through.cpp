#include "runtime/world/break_through.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/destruction/fragment_style.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

constexpr double kContact = 0.2;  ///< metres: how far from the contact that physics reports the surface may be
constexpr double kStepInCells = 0.5;

/// What a hole goes through along a way from the side that was hit; null if it is not deep enough, or meets what stays.
const Material* wallThrough(const World& world, const BreakEdit& hole, glm::dvec3 way) {
    const Shape& shape = world.shapes().at(hole.shape);
    const Pose pose = world.shapeToWorld(hole.shape);
    const Material* wall = nullptr;
    const double step = kStepInCells * double(shape.voxelSize);
    for (double depth = -kContact; depth < hole.radii[0]; depth += step) {
        const glm::dvec3 cell = pose.inversePoint(hole.position + way * depth) / double(shape.voxelSize);
        const uint8_t entry = shape.grid.at(glm::ivec3(glm::floor(cell)));
        if (!entry && wall) return wall;
        if (!entry) continue;
        const Material& material = world.materials()[(*shape.palette)[entry].material];
        if (material.hardness > Hardness::Hard || hole.radii[size_t(material.hardness)] <= 0.0) return nullptr;
        if (!wall || impactToughness(material) > impactToughness(*wall)) wall = &material;
    }
    return nullptr;
}

/// N s that a hole takes: the broken area grows with the impulse, as in World::addImpactDamage(). A pane takes no more than
/// what it breaks at, wherever its cracks end.
double impulseOf(const BreakEdit& hole, const Material& wall, const WorldSettings& settings) {
    const double breaks = settings.impactThreshold * impactToughness(wall);
    if (fragmentStyle(wall.fragments).wholePane) return breaks;
    const double ratio = hole.radii[0] / settings.impactRadius;
    return breaks * std::max(1.0, ratio * ratio);
}

/// A pane goes as a whole; through a wall there is only the hole.
bool fitsThrough(const World& world, BodyHandle handle, const BreakEdit& hole, const Material& wall) {
    const Body* body = world.bodies().find(handle);
    if (!body || body->isStatic) return false;
    if (fragmentStyle(wall.fragments).wholePane) return true;
    return std::all_of(body->shapes.begin(), body->shapes.end(), [&](ShapeHandle each) {
        const Shape& shape = world.shapes().at(each);
        const glm::ivec3 size = shape.grid.size();
        return double(std::max({size.x, size.y, size.z})) * double(shape.voxelSize) <= 2.0 * hole.radii[0];
    });
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
            const glm::dvec3 way = hitterIsFirst ? -impact.normal : impact.normal;
            const Material* wall = wallThrough(world, hole, way);
            if (!wall || !fitsThrough(world, hitter, hole, *wall)) break;
            const double spare = impact.impulse - impulseOf(hole, *wall, world.settings());
            if (spare > 0.0) damage.emplace_back(ImpulseEdit{hitter, impact.position, way * spare});
            break;
        }
    }
}

}  // namespace rubble
