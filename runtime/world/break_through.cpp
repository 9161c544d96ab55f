#include "runtime/world/break_through.h"

#include <glm/common.hpp>

#include "runtime/destruction/fragment_style.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

constexpr int kContactCells = 2;  ///< how far from the contact that physics reports the pane may be

/// The style of the pane that was hit; null if it was something else.
const FragmentStyle* paneAt(const World& world, ShapeHandle handle, const Impact& impact) {
    const Shape* shape = world.shapes().find(handle);
    if (!shape) return nullptr;
    const Pose pose = world.shapeToWorld(handle);
    for (int step = 0; step <= 2 * kContactCells; ++step) {
        const double way = double((step + 1) / 2 * (step % 2 ? 1 : -1)) * double(shape->voxelSize);
        const glm::dvec3 cell = pose.inversePoint(impact.position + impact.normal * way) / double(shape->voxelSize);
        const uint8_t entry = shape->grid.at(glm::ivec3(glm::floor(cell)));
        if (!entry) continue;
        const FragmentStyle& style = fragmentStyle(world.materials()[(*shape->palette)[entry].material].fragments);
        return style.wholePane ? &style : nullptr;
    }
    return nullptr;
}

}  // namespace

void addBreakThrough(const World& world, std::span<const Impact> impacts, Edits& damage) {
    const size_t breaks = damage.size();
    for (size_t i = 0; i < breaks; ++i) {
        const auto* broken = std::get_if<BreakEdit>(&damage[i]);
        const Shape* shape = broken ? world.shapes().find(broken->shape) : nullptr;
        if (!shape || !world.bodies().at(shape->body).isStatic) continue;
        for (const Impact& impact : impacts) {
            if (impact.position != broken->position || (impact.body != shape->body && impact.other != shape->body)) continue;
            const FragmentStyle* pane = paneAt(world, broken->shape, impact);
            if (!pane) continue;
            const bool hitterIsFirst = impact.other == shape->body;
            const double spare = impact.impulse - world.settings().impactThreshold * pane->toughness;
            damage.emplace_back(
                ImpulseEdit{hitterIsFirst ? impact.body : impact.other, impact.position, impact.normal * (hitterIsFirst ? -spare : spare)});
            break;
        }
    }
}

}  // namespace rubble
