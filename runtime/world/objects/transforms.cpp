#include "runtime/world/objects/transforms.h"

namespace rubble {

Pose shapeToWorld(const WorldObjects& objects, ShapeHandle handle) {
    const Shape& shape = objects.shapes.at(handle);
    return objects.bodies.at(shape.body).pose * shape.local;
}

Pose lightToWorld(const WorldObjects& objects, const Light& light) {
    return objects.shapes.find(light.shape) ? shapeToWorld(objects, light.shape) * light.local : light.local;
}

Pose jointToWorld(const WorldObjects& objects, const JointEnd& end) {
    return objects.shapes.find(end.shape) ? shapeToWorld(objects, end.shape) * end.frame : end.frame;
}

WorldBox gridBounds(const WorldObjects& objects, ShapeHandle handle) {
    const Shape& shape = objects.shapes.at(handle);
    const Pose pose = shapeToWorld(objects, handle);
    const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
    return boundsOfBox(pose.transformPoint(half), half, pose.rotation);
}

}  // namespace rubble
