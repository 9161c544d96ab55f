#pragma once
#include <memory>
#include <string>
#include <utility>

#include "runtime/world/world.h"
#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble::test {

/// A shape with the five test materials.
inline LevelShape levelShape(std::string name, VoxelGrid grid) {
    LevelShape shape{.name = std::move(name), .grid = std::move(grid)};
    shape.palette = std::make_shared<const Palette>(fiveEntries());
    return shape;
}

/// One shape on one body, with the five test materials.
inline Level oneShapeLevel(VoxelGrid grid, bool isStatic, Pose pose = {}) {
    Level level;
    level.materials = fiveMaterials();
    LevelBody body{.name = "body", .pose = pose, .isStatic = isStatic};
    body.shapes.push_back(levelShape("shape", std::move(grid)));
    level.bodies.push_back(std::move(body));
    return level;
}

/// A carve of all hardness classes by one radius, in metres.
inline CarveEdit sphereCarve(glm::dvec3 position, double radius) {
    CarveEdit edit{.position = position};
    edit.radii.fill(radius);
    return edit;
}

/// The shape in the lowest slot; empty if there is none.
inline ShapeHandle firstShape(const World& world) {
    ShapeHandle first;
    world.shapes().forEach([&](ShapeHandle handle, const Shape&) {
        if (!first) first = handle;
    });
    return first;
}

}  // namespace rubble::test
