#include "runtime/shadow/shadow_step.h"

namespace rubble {

ShadowStep makeShadowStep(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world) {
    ShadowStep out;
    out.version = changes.step;
    out.replacesAll = changes.levelReplaced;
    const auto create = [&](ShapeHandle handle, const Shape& shape) {
        const Pose toWorld = shapeToWorld(world, handle);
        out.created.push_back({handle, shape.grid, shape.palette, double(shape.voxelSize), toWorld});
    };
    if (changes.levelReplaced) {
        world.shapes().forEach(create);
    } else {
        out.destroyed = changes.shapesDestroyed;
        for (const ShapeHandle handle : changes.shapesCreated)
            if (const Shape* shape = world.shapes().find(handle)) create(handle, *shape);
        out.bricks = changes.bricks;
        for (const ShapeHandle handle : changes.palettes)
            if (const Shape* shape = world.shapes().find(handle)) out.palettes.push_back({handle, shape->palette});
    }
    out.poses.reserve(moved.size());
    for (const BodyPose& pose : moved)
        if (const Body* body = world.bodies().find(pose.body))
            for (const ShapeHandle shape : body->shapes)
                out.poses.push_back({shape, shapeToWorld(world, shape), pose.asleep});
    return out;
}

}  // namespace rubble
