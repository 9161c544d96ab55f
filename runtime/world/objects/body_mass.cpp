#include "runtime/world/objects/body_mass.h"

#include <glm/mat3x3.hpp>
#include <utility>
#include <vector>

#include "runtime/core/planted_fault.h"

namespace rubble {
namespace {

glm::dmat3 inertiaMatrix(const std::array<double, 6>& t) {
    return {t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2]};
}

}  // namespace

MassProperties massOf(const Shape& shape, const MassMoments& moments) {
    MassProperties mass = massProperties(moments, shape.voxelSize);
    if (isPlanted("wrong-mass")) mass.mass *= 1.01;
    if (shape.density == 1.0f) return mass;
    mass.mass *= double(shape.density);
    for (double& each : mass.inertia) each *= double(shape.density);
    mass.principalInertia *= double(shape.density);
    return mass;
}

MassProperties bodyMass(const WorldObjects& objects, BodyHandle handle) {
    const Body& body = objects.bodies.at(handle);
    if (body.shapes.size() == 1)  // as all pieces are
        if (const Shape& only = objects.shapes.at(body.shapes[0]); only.local == Pose{})
            return massOf(only, only.moments);
    MassProperties sum;
    std::vector<std::pair<const Shape*, MassProperties>> parts;
    parts.reserve(body.shapes.size());
    for (const ShapeHandle shapeHandle : body.shapes) {
        const Shape& shape = objects.shapes.at(shapeHandle);
        parts.emplace_back(&shape, massOf(shape, shape.moments));
        sum.mass += parts.back().second.mass;
        sum.center += parts.back().second.mass * shape.local.transformPoint(parts.back().second.center);
    }
    if (sum.mass <= 0.0) return sum;
    sum.center /= sum.mass;
    glm::dmat3 inertia(0.0);
    for (const auto& [shape, part] : parts) {
        const glm::dmat3 rotation = glm::mat3_cast(shape->local.rotation);
        const glm::dvec3 r = shape->local.transformPoint(part.center) - sum.center;
        inertia += rotation * inertiaMatrix(part.inertia) * glm::transpose(rotation);
        inertia += part.mass * (glm::dmat3(glm::dot(r, r)) - glm::outerProduct(r, r));
    }
    sum.inertia = {inertia[0][0], inertia[1][1], inertia[2][2], inertia[1][0], inertia[2][1], inertia[2][0]};
    principalAxes(sum.inertia, sum.principalInertia, sum.principalAxes);
    return sum;
}

}  // namespace rubble
