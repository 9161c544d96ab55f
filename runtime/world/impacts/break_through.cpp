#include "runtime/world/impacts/break_through.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "runtime/destruction/fragment_style.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {
namespace {

constexpr double kContactTolerance = 0.2;  ///< metres: how far from the contact that physics reports the surface may be
constexpr double kSampleSpacingCells = 0.5;

/// What stands in a hole's path.
struct HoleResistance {
    const Material* wall = nullptr;  ///< the toughest near the axis; null: something stays there, or nothing was there
    double meanToughness = 0.0;      ///< over the disc: a single pipe stops less than a wall of pipes
};

/// Samples the cylinder that a hole cuts, in columns a voxel apart over its disc.
class HoleSampler {
public:
    HoleSampler(const WorldData& world, const BreakEdit& hole, glm::dvec3 direction)
        : m_world(world),
          m_hole(hole),
          m_direction(direction),
          m_shape(world.shapes.at(hole.shape)),
          m_pose(shapeToWorld(world, hole.shape)) {}

    HoleResistance resistance() {
        const double voxel = double(m_shape.voxelSize);
        const glm::dvec3 u = glm::normalize(
            glm::cross(m_direction, std::abs(m_direction.y) < 0.7 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const glm::dvec3 v = glm::cross(m_direction, u);
        const int columns = int(m_hole.radii[0] / voxel);
        for (int j = -columns; j <= columns; ++j)
            for (int i = -columns; i <= columns; ++i) sampleColumn(u * (double(i) * voxel) + v * (double(j) * voxel));
        if (m_isBlocked) m_resistance.wall = nullptr;
        m_resistance.meanToughness /= std::max(m_columns, 1);
        return m_resistance;
    }

private:
    void sampleColumn(glm::dvec3 offset) {
        const double radius = m_hole.radii[0], out2 = glm::dot(offset, offset);
        if (out2 > radius * radius) return;
        ++m_columns;
        const bool isMiddle = out2 <= kContactTolerance * kContactTolerance;
        const Material* toughest = nullptr;
        for (double depth = -kContactTolerance; depth < radius;
             depth += kSampleSpacingCells * double(m_shape.voxelSize)) {
            const Material* material = materialAt(m_hole.position + offset + m_direction * depth);
            if (!material) {
                if (isMiddle && toughest) break;  // out on the other side
                continue;
            }
            const bool breaks =
                material->hardness <= Hardness::Hard && out2 + depth * depth < radiusSquared(material->hardness);
            if (isMiddle && (!breaks || depth + kSampleSpacingCells * double(m_shape.voxelSize) >= radius))
                m_isBlocked = true;
            if (breaks && (!toughest || impactToughness(*material) > impactToughness(*toughest))) toughest = material;
        }
        if (!toughest) return;
        m_resistance.meanToughness += impactToughness(*toughest);
        if (isMiddle && (!m_resistance.wall || impactToughness(*toughest) > impactToughness(*m_resistance.wall)))
            m_resistance.wall = toughest;
    }
    double radiusSquared(Hardness hardness) const {
        return m_hole.radii[size_t(hardness)] * m_hole.radii[size_t(hardness)];
    }
    const Material* materialAt(glm::dvec3 point) const {
        const uint8_t entry = m_shape.grid.at(cellAt(m_pose.inversePoint(point) / double(m_shape.voxelSize)));
        return entry ? &m_world.materials[(*m_shape.palette)[entry].material] : nullptr;
    }

    const WorldData& m_world;
    const BreakEdit& m_hole;
    glm::dvec3 m_direction;
    const Shape& m_shape;
    Pose m_pose;
    HoleResistance m_resistance;
    int m_columns = 0;
    bool m_isBlocked = false;
};

/// N s that breaking a hole takes. The broken area grows with the impulse, as in impactDamage(). A pane takes no more
/// than its breaking impulse, wherever its cracks end.
double impulseOf(const BreakEdit& hole, const HoleResistance& resistance, const WorldSettings& settings) {
    if (fragmentStyle(resistance.wall->fragments).wholePane)
        return settings.impactThreshold * impactToughness(*resistance.wall);
    const double ratio = hole.radii[0] / settings.impactRadius;
    return settings.impactThreshold * resistance.meanToughness * std::max(1.0, ratio * ratio);
}

/// Whether some of a body may break off by the damage.
bool maySplit(const WorldData& world, BodyHandle body, std::span<const Edit> damage) {
    return std::any_of(damage.begin(), damage.end(), [&](const Edit& edit) {
        const auto* hit = std::get_if<BreakEdit>(&edit);
        const auto* load = std::get_if<ImpactLoadEdit>(&edit);
        const Shape* shape = world.shapes.find(hit ? hit->shape : load ? load->shape : ShapeHandle{});
        return shape && shape->body == body;
    });
}

/// Changes velocities as an impulse on the whole body does. What breaks off then moves on with it, instead of all of
/// the impulse acting on the crumb that keeps the body's handle.
void pushWhole(const WorldData& world, const ImpulseEdit& impulse, std::vector<SetBodyEdit>& out) {
    const Body& body = world.bodies.at(impulse.body);
    auto known = std::find_if(out.begin(), out.end(), [&](const SetBodyEdit& e) { return e.body == impulse.body; });
    if (known == out.end()) {
        SetBodyEdit set{.body = impulse.body, .setsVelocity = true};
        set.velocity = body.velocity, set.angularVelocity = body.angularVelocity;
        known = out.insert(known, set);
    }
    const MassProperties mass = bodyMass(world, impulse.body);
    const glm::dquat axes = body.pose.rotation * mass.principalAxes;
    const glm::dvec3 arm = impulse.position - body.pose.transformPoint(mass.center),
                     turn = glm::conjugate(axes) * glm::cross(arm, impulse.impulse);
    known->velocity += impulse.impulse / mass.mass;
    known->angularVelocity += axes * (turn / mass.principalInertia);
}

}  // namespace

void addBreakThroughImpulses(const WorldData& world, std::span<const Impact> impacts, Edits& damage) {
    const size_t breaks = damage.size();
    std::vector<SetBodyEdit> pushed;
    for (size_t i = 0; i < breaks; ++i) {
        const auto* edit = std::get_if<BreakEdit>(&damage[i]);
        const Shape* shape = edit ? world.shapes.find(edit->shape) : nullptr;
        if (!shape || !world.bodies.at(shape->body).isStatic) continue;
        const BreakEdit hole = *edit;  // the list grows
        for (const Impact& impact : impacts) {
            if (impact.position != hole.position || (impact.body != shape->body && impact.other != shape->body))
                continue;
            const bool strikerIsFirst = impact.other == shape->body;
            const BodyHandle striker = strikerIsFirst ? impact.body : impact.other;
            const Body* body = world.bodies.find(striker);
            if (!body || body->isStatic) break;
            const glm::dvec3 direction = strikerIsFirst ? -impact.normal : impact.normal;
            const HoleResistance resistance = HoleSampler(world, hole, direction).resistance();
            if (!resistance.wall) break;
            // At most the momentum it arrived with: what another body presses through the wall is not thrown ahead of
            // it.
            const double arrivingMomentum = bodyMass(world, striker).mass * impact.speed;
            const double remaining =
                std::min(impact.impulse - impulseOf(hole, resistance, world.settings), arrivingMomentum);
            const ImpulseEdit rest{striker, impact.position, direction * remaining};
            if (remaining > 0.0 && maySplit(world, striker, {damage.data(), breaks}))
                pushWhole(world, rest, pushed);
            else if (remaining > 0.0)
                damage.emplace_back(rest);
            break;
        }
    }
    damage.insert(damage.begin(), pushed.begin(), pushed.end());  // before anything breaks off
}

}  // namespace rubble
