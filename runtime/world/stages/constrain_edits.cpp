#include "runtime/world/stages/constrain_edits.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "runtime/core/log.h"

namespace rubble {

void apply(EditContext& context, const ConstrainEdit& edit) {
    const Body* body = context.world.bodies.find(edit.constraint.body);
    const Body* other = context.world.bodies.find(edit.constraint.other);
    if (!body) return context.warnStale(edit.constraint.body, "constrain_bodies: the handle of its body is stale");
    if (!other && edit.constraint.other)
        return context.warnStale(edit.constraint.other, "constrain_bodies: the handle of the other body is stale");
    if (body->isStatic && (!other || other->isStatic))
        return logWarning("constrain_bodies: expected a free body, found none; nothing was held");
    BodyConstraint constraint = edit.constraint;
    const glm::dvec3 size = glm::abs(constraint.direction);
    constraint.direction /= std::max({size.x, size.y, size.z});  // so that the square of its length is a number
    constraint.direction = glm::normalize(constraint.direction);
    if (!body->isStatic) context.wakeBody(constraint.body);
    if (other && !other->isStatic) context.wakeBody(constraint.other);
    context.changes.constraints.push_back(constraint);
}

}  // namespace rubble
