#include "physics/stages/body_constraints.h"

#include <limits>

namespace rubble {
namespace {

/// What the solver reads of the joint of a row: that a motor acts along it, and that it may do any work, as a hand may.
const Joint& motorOfHand() {
    static const Joint joint = [] {
        Joint out;
        out.motor.mode = MotorMode::Speed;
        out.hand = 1;
        return out;
    }();
    return joint;
}

/// A side of the row: a body that moves, or the world.
void setSide(JointConstraint& row, size_t side, const DynamicBody* body, const glm::dvec3& position) {
    row.bodies[side] = body ? body->solverIndex : 0;
    row.frames[side] = {body ? body->pose().inversePoint(position) : position};
}

}  // namespace

void BodyConstraints::set(const FrameChanges& changes, const World& world, PhysicsBodies& bodies) {
    m_given = changes.constraints;
    std::erase_if(m_given, [&](const BodyConstraint& constraint) {
        const auto isGone = [&](BodyHandle handle) { return handle && !world.bodies().find(handle); };
        return isGone(constraint.body) || isGone(constraint.other);
    });
    for (const BodyConstraint& constraint : m_given)
        for (const BodyHandle handle : {constraint.body, constraint.other})
            if (DynamicBody* body = handle ? bodies.find(handle) : nullptr) {
                bodies.wake(*body);
                body->restartRest();
            }
}

std::span<JointConstraint> BodyConstraints::gather(PhysicsBodies& bodies) {
    m_rows.clear();
    for (const BodyConstraint& constraint : m_given) {
        const auto moving = [&](BodyHandle handle) -> const DynamicBody* {
            const DynamicBody* body = handle ? bodies.find(handle) : nullptr;
            return body && !body->asleep() && !body->quarantined() ? body : nullptr;
        };
        const DynamicBody *body = moving(constraint.body), *other = moving(constraint.other);
        if (!body && !other) continue;
        JointConstraint& row = m_rows.emplace_back();
        row.joint = &motorOfHand();
        row.constraint = &constraint;
        setSide(row, 0, other, constraint.position);
        setSide(row, 1, body, constraint.position);
    }
    return m_rows;
}

double BodyConstraints::work() const {
    return m_rows.empty() ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace rubble
