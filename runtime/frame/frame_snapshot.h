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

/// A shape's new palette or colours of paint: both are given.
struct SnapshotPalette {
    ShapeHandle shape;
    PaletteRef palette;
    PaintColorsRef paintColors;
};

/// Where a shape (its grid's corner) was at the previous step and is at this one.
struct SnapshotPose {
    ShapeHandle shape;
    Pose previous;
    Pose current;
};

/// A light in the world, as the renderer draws it.
struct SnapshotLight {
    LightKind kind;
    glm::dvec3 position;
    glm::vec3 direction;
    glm::vec3 color;
    float radius, reach, coneInner, coneOuter;
    glm::vec3 right{1, 0, 0};           ///< unit vector along `width`
    float width = 0.0f, height = 0.0f;  ///< metres
    bool twoSided = false;
    LightImage image = {};   ///< of a screen
    LightHandle light = {};  ///< empty: of a fire
};

/// A burning brick, as flames and smoke are drawn.
struct SnapshotFire {
    glm::dvec3 position;  ///< world: the middle of what burns
    float radius;         ///< metres
    float intensity;      ///< 0 to 1: rises when lit, falls with the fuel
    float smoke;          ///< 0 to 1
    uint32_t seed;        ///< the same for a fire from its first step to its last
};

enum class ParticleKind : uint8_t { Dust, Smoke, Flame, Spark, Crumb, Glint, Ember };

/// Something small in the air at a step, as it is drawn.
struct SnapshotParticle {
    ParticleKind kind;
    glm::dvec3 position;  ///< world
    glm::vec3 velocity;   ///< m/s: where it was between steps
    glm::vec3 color;      ///< linear albedo; of sparks: what they glow like
    float radius;         ///< metres
    float opacity;        ///< 0 to 1
    float age;            ///< share of its life
    uint32_t seed;        ///< the same from its first step to its last
};

/// A rope's points at the previous step and at this one.
struct SnapshotRope {
    JointHandle rope;
    std::vector<glm::dvec3> previous, current;  ///< world, as many in both
    float radius;                               ///< metres
    glm::vec3 color;                            ///< sRGB, 0 to 1
};

/// A ring that runs over a water's surface from where something moved in it.
struct SnapshotRipple {
    glm::dvec2 place;  ///< world x and z
    double surface;    ///< height of the water
    float radius;      ///< metres, at its birth
    float strength;    ///< metres, crest above calm at its birth
    float age;         ///< seconds
};

/// What one frame hands to the renderer: values only, and only what changed since the snapshot before. All of it shows
/// the step `version`, the shadow volume too, so light and bodies agree.
struct FrameSnapshot {
    uint64_t version = 0;
    uint64_t newestStep = 0;             ///< newestStep - version = age of what is drawn, in steps
    bool replacesAll = false;            ///< a level was loaded: forget everything before
    std::vector<std::string> materials;  ///< names by index, if replacesAll; none: those of the default table
    std::vector<ShapeHandle> destroyed;  ///< applied first
    std::vector<SnapshotShape> created;
    std::vector<BrickChange> bricks;
    std::vector<SnapshotPalette> palettes;
    std::vector<SnapshotPose> poses;  ///< shapes that moved in this step, or came to rest in it (previous == current)
    bool lightsChanged = false;
    std::vector<SnapshotLight> lights;  ///< all enabled lights and those of the biggest fires, if lightsChanged
    bool firesChanged = false;
    std::vector<SnapshotFire> fires;  ///< all of them, if firesChanged
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

/// Appends a later snapshot to an earlier one, so that applying the result equals applying both. Nothing is dropped.
void merge(FrameSnapshot& into, FrameSnapshot&& later);

}  // namespace rubble
