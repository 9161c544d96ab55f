#include "runtime/world/edits/resolve_brush.h"

#include <algorithm>
#include <cmath>

namespace rubble {

Brush resolveBrush(const CarveEdit& edit, const Pose& shapeToWorld, double voxelSize) {
    const double cellsPerMetre = 1.0 / voxelSize;
    const auto toCells = [&](glm::dvec3 world) { return shapeToWorld.inversePoint(world) * cellsPerMetre; };
    if (edit.kind == BrushKind::Box) {
        const glm::dquat boxToShape = glm::conjugate(shapeToWorld.rotation) * edit.rotation;
        return boxBrush(toCells(edit.position), edit.halfSize * cellsPerMetre, boxToShape, edit.maxHardness);
    }
    const std::array<double, 3> radii = {edit.radii[0] * cellsPerMetre, edit.radii[1] * cellsPerMetre,
                                         edit.radii[2] * cellsPerMetre};
    if (edit.kind == BrushKind::Sphere) return sphereBrush(toCells(edit.position), radii);
    return capsuleBrush(toCells(edit.position), toCells(edit.end), radii);
}

BoundingSphere boundingSphere(const CarveEdit& edit) {
    BoundingSphere sphere{edit.position, *std::max_element(edit.radii.begin(), edit.radii.end())};
    if (edit.kind == BrushKind::Box) sphere.radius = glm::length(edit.halfSize);
    if (edit.kind == BrushKind::Capsule) {
        sphere.center = (edit.position + edit.end) * 0.5;
        sphere.radius += glm::length(edit.end - edit.position) * 0.5;
    }
    const bool isNumber = !std::isnan(sphere.center.x + sphere.center.y + sphere.center.z + sphere.radius);
    return isNumber ? sphere : BoundingSphere{glm::dvec3(0.0), -1.0};
}

}  // namespace rubble
