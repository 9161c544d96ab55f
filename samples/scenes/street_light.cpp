#include "samples/scenes/street_light.h"

#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

ivec3 addStreetLight(Level& level, const std::string& name, ivec3 cell, bool alongX) {
    constexpr int kBase = 4;  // depth in the ground
    constexpr int kTop = kBase + 50;
    constexpr int kArmLength = 17;
    const uint32_t group = addLightGroup(level, name);
    Canvas c(alongX ? ivec3(kArmLength + 3, kTop + 5, 5) : ivec3(5, kTop + 5, kArmLength + 3));
    const Swatch iron = c.addSurface(kDarkSteel), foot = c.addSurface(kConcrete),
                 glow = c.addSurface(kStreetLightGlow, 100, group), rust = c.addSurface(kRust);
    // Drawn along +z from the post; the variant along -x is the same, turned.
    const auto place = [&](ivec3 low, ivec3 high, Swatch swatch) {
        if (alongX) {
            const int sx = kArmLength + 3;
            c.box({sx - high.z, low.y, low.x}, {sx - low.z, high.y, high.x}, swatch);
        } else {
            c.box(low, high, swatch);
        }
    };
    place({0, 0, 0}, {5, kBase, 5}, foot);
    place({1, kBase, 1}, {4, kBase + 6, 4}, iron);
    place({2, kBase, 2}, {3, kTop, 3}, iron);
    place({1, kBase + 6, 2}, {2, kBase + 24, 3}, iron);
    place({2, kTop, 2}, {3, kTop + 3, 4}, iron);
    place({2, kTop + 2, 3}, {3, kTop + 4, kArmLength - 6}, iron);
    place({1, kTop + 2, kArmLength - 6}, {4, kTop + 4, kArmLength + 2}, iron);
    place({2, kTop + 4, kArmLength - 5}, {3, kTop + 5, kArmLength + 1}, iron);
    place({0, kTop, kArmLength - 5}, {5, kTop + 2, kArmLength + 1}, glow);
    c.stain({0, kBase, 0}, {c.size().x, kBase + 5, c.size().z}, rust, 25);
    const glm::dvec3 head = alongX ? glm::dvec3(5.0, kTop - 0.8, 2.5) : glm::dvec3(2.5, kTop - 0.8, kArmLength - 2.0);
    const ivec3 size = c.size();
    const ivec3 corner = cell - (alongX ? ivec3(size.x - 3, kBase, 2) : ivec3(2, kBase, 2));
    LevelShape shape = c.finish(name);
    shape.loadBearing = false;  // the post is one voxel thick, too thin for the stress analysis
    addStatic(level, std::move(shape), corner);
    addLight(level, name, group, LightKind::Cone, head, kWarmLight * 240.0f, 15.0f, 0.18f);
    return corner + ivec3(head);
}

}  // namespace rubble::scenes
