#include "runtime/frame/ripples.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "runtime/core/constants.h"

namespace rubble {
namespace {

constexpr double kMinSpeed = 0.25;        ///< m/s through the water below which nothing makes a ring
constexpr float kMinInterval = 0.15f;     ///< seconds between two rings of one source
constexpr double kMaxHeight = 0.10;       ///< metres
constexpr double kHeightPerSpeed = 0.02;  ///< metres per m/s, of a source one metre wide

/// The world-space bounds of a shape.
WorldBox boundsOf(const Shape& shape, const Pose& pose) {
    WorldBox box{glm::dvec3(1e30), glm::dvec3(-1e30)};
    const glm::dvec3 size = glm::dvec3(shape.grid.size()) * double(shape.voxelSize);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point = pose.transformPoint(size * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2));
        box = box.merged({point, point});
    }
    return box;
}

}  // namespace

void Ripples::step(std::span<const BodyPose> moved, const World& world) {
    for (Ripple& ripple : m_alive) ripple.drawn.age += 1.0f / float(kStepsPerSecond);
    std::erase_if(m_alive, [](const Ripple& ripple) { return ripple.drawn.age > kLife; });
    if (world.waters().size() == 0) return;
    world.waters().forEach([&](WaterHandle, const Water& water) {
        for (const BodyPose& pose : moved) {
            const Body* body = world.bodies().find(pose.body);
            if (!body || glm::length(pose.velocity - water.flow) < kMinSpeed) continue;
            for (const ShapeHandle shape : body->shapes)
                disturb(water, boundsOf(world.shapes().at(shape), shapeToWorld(world, shape)), pose.velocity,
                        pose.body.bits);
        }
        world.characters().forEach([&](CharacterHandle handle, const Character& c) {
            const glm::dvec3 low = c.position - glm::dvec3(c.radius, 0, c.radius);
            disturb(water, {low, low + glm::dvec3(2 * c.radius, c.currentHeight(), 2 * c.radius)}, c.velocity,
                    handle.bits);
        });
    });
}

void Ripples::disturb(const Water& water, const WorldBox& box, glm::dvec3 velocity, uint64_t source) {
    const double speed = glm::length(velocity - water.flow);
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    if (!(speed >= kMinSpeed) || box.low.y > water.surface || box.high.y < water.surface ||
        !contains(water.outline, middle.x, middle.z))
        return;
    for (const Ripple& ripple : m_alive)
        if (ripple.source == source && ripple.drawn.age < kMinInterval) return;
    const double radius = 0.35 * std::min(box.high.x - box.low.x, box.high.z - box.low.z);
    const double height = std::min(kMaxHeight, kHeightPerSpeed * speed * std::sqrt(2.0 * radius));
    if (m_alive.size() == kMaxRipples) m_alive.erase(m_alive.begin());
    m_alive.push_back({{{middle.x, middle.z}, water.surface, float(radius), float(height), 0.0f}, source});
}

std::vector<SnapshotRipple> Ripples::snapshot() const {
    std::vector<SnapshotRipple> out;
    for (const Ripple& ripple : m_alive) out.push_back(ripple.drawn);
    return out;
}

}  // namespace rubble
