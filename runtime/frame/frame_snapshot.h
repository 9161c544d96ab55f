#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/objects/lights.h"
#include "runtime/world/objects/water.h"
#include "runtime/world/settings/bounds_settings.h"

namespace rubble {

/// A shape that the renderer has not seen yet, with its bricks by reference.
struct SnapshotShape {
    ShapeHandle shape;
    glm::ivec3 size;  ///< voxels
    float voxelSize;  ///< metres
    PaletteRef palette;
    std::vector<BrickChange> bricks;  ///< all that are not empty
    PaintColorsRef paintColors;       ///< null: nothing is painted
};

/// A shape whose palette or paint colours have changed; both are given.
struct SnapshotPalette {
    ShapeHandle shape;
    PaletteRef palette;
    PaintColorsRef paintColors;
};

/// The pose of a shape (of its grid's corner) at the previous step and at this one.
struct SnapshotPose {
    ShapeHandle shape;
    Pose previous;
    Pose current;
};

/// A light as the renderer draws it: the fields of Light, in the world.
struct SnapshotLight {
    LightKind kind;
    glm::dvec3 position;                ///< world
    glm::vec3 direction;                ///< unit vector, world
    glm::vec3 color;                    ///< linear radiant intensity
    float radius, reach;                ///< metres
    float coneInner, coneOuter;         ///< half angles, radians
    glm::vec3 right{1, 0, 0};           ///< unit vector along `width`
    float width = 0.0f, height = 0.0f;  ///< metres
    bool twoSided = false;
    LightImage image = {};   ///< of a screen
    LightHandle light = {};  ///< null: of a fire or of particles; of generation 0: see GlowLights
    bool fleeting = false;   ///< of a fire or of particles: no voxels glow for it
    /// Whether its face is a rectangle.
    bool isRectangle() const { return kind == LightKind::Area || kind == LightKind::Screen; }
};

/// A light at a pose in the world.
inline SnapshotLight describeLight(const Light& light, const Pose& pose, LightHandle handle) {
    return {.kind = light.kind,
            .position = pose.position,
            .direction = glm::vec3(pose.rotation * glm::dvec3(0.0, 0.0, -1.0)),
            .color = light.color,
            .radius = light.radius,
            .reach = light.reach,
            .coneInner = light.coneInner,
            .coneOuter = light.coneOuter,
            .right = glm::vec3(pose.rotation * glm::dvec3(1.0, 0.0, 0.0)),
            .width = light.width,
            .height = light.height,
            .twoSided = light.twoSided,
            .image = light.image,
            .light = handle};
}

/// The numbers are those of shaders/lib/particle_kinds.glsl.
enum class ParticleKind : uint8_t { Dust, Smoke, Flame, Spark, Crumb, Glint, Ember };

/// A particle at a step, as it is drawn.
struct SnapshotParticle {
    ParticleKind kind;
    glm::dvec3 position;   ///< world
    glm::vec3 velocity;    ///< m/s: gives its position between steps
    glm::vec3 color;       ///< linear albedo; of sparks: colour of their glow
    float radius;          ///< metres
    float opacity;         ///< 0 to 1
    float age;             ///< share of its life, 0 to 1
    uint32_t seed;         ///< the same from its first step to its last
    float turn = 0.0f;     ///< radians by which its image has turned
    float stretch = 0.0f;  ///< seconds of its motion by which its image is longer along it
};

/// A rope's points at the previous step and at this one.
struct SnapshotRope {
    JointHandle rope;
    std::vector<glm::dvec3> previous, current;  ///< world; both have the same length
    float radius;                               ///< metres
    glm::vec3 color;                            ///< sRGB, 0 to 1
};

/// A ring on a water surface that spreads from where something has moved through it.
struct SnapshotRipple {
    glm::dvec2 center;  ///< world x and z
    double surface;     ///< height of the water
    float radius;       ///< metres, at its birth
    float strength;     ///< metres: height of the crest at its birth
    float age;          ///< seconds
};

/// What changed for the renderer since the snapshot before. Values only. All of it shows the step `version`, also the
/// shadow volume, so that light and bodies agree.
struct FrameSnapshot {
    uint64_t version = 0;
    uint64_t newestStep = 0;             ///< the last step simulated: newestStep - version is the age of what is drawn
    bool replacesAll = false;            ///< a level was loaded: all earlier objects are gone
    std::vector<std::string> materials;  ///< names by index, if replacesAll or they changed; else none
    std::vector<ShapeHandle> destroyed;  ///< applied first
    std::vector<SnapshotShape> created;
    std::vector<BrickChange> bricks;
    std::vector<SnapshotPalette> palettes;
    std::vector<SnapshotPose> poses;  ///< of shapes that moved in this step, or came to rest (previous == current)
    bool lightsChanged = false;
    std::vector<SnapshotLight> lights;  ///< all enabled lights and those of the biggest fires, if lightsChanged
    bool particlesChanged = false;
    std::vector<SnapshotParticle> particles;  ///< all of them, if particlesChanged
    bool ropesChanged = false;
    std::vector<SnapshotRope> ropes;  ///< all of them, if ropesChanged
    bool watersChanged = false;
    std::vector<Water> waters;  ///< all of them, if watersChanged
    bool ripplesChanged = false;
    std::vector<SnapshotRipple> ripples;  ///< all of them, if ripplesChanged
    bool environmentChanged = false;
    Environment environment;
    bool shadowReplacesAll = false;
    std::vector<ShadowPatch> shadow;
};

}  // namespace rubble
