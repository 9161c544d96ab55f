#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/world_box.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/collision_shape.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/objects/lights.h"
#include "runtime/world/objects/named_data.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// The anchors of a static shape that nothing holds.
inline const std::vector<CellBox> kNoAnchors = {CellBox{}};

/// A voxel shape as data: what files hold and scenes make.
struct LevelShape {
    std::string name;
    Pose local;              ///< in its body; the grid's corner is its origin
    float voxelSize = 0.1f;  ///< metres
    VoxelGrid grid;
    PaletteRef palette;
    /// Cells that hold a static shape to the world; no boxes: its lowest layer of voxels. One box without cells
    /// (kNoAnchors): none hold it.
    std::vector<CellBox> anchors;
    std::vector<std::string> tags;
    bool hidden = false;         ///< kept in files, not part of a World
    PaintColorsRef paintColors;  ///< null: no voxel has a paint layer
    float strength = 1.0f;       ///< multiple of its materials' strengths
    bool loadBearing = true;     ///< false: left out of the stress analysis
    uint8_t collisionLayer = 1;  ///< bits; two shapes touch if each one's layer is in the other's mask
    uint8_t collisionMask = 255;
    CollisionShape collisionShape = CollisionShape::Voxels;  ///< what it is touched as
    float density = 1.0f;                                    ///< multiple of its materials' densities
    float emission = 1.0f;                                   ///< multiple of what its palette's entries emit
};

/// A body as data, with its shapes.
struct LevelBody {
    std::string name;
    Pose pose;
    bool isStatic = true;
    glm::vec3 velocity{0.0f};         ///< m/s
    glm::vec3 angularVelocity{0.0f};  ///< rad/s
    std::vector<LevelShape> shapes;
    std::vector<std::string> tags;
    double gravityScale = 1.0;  ///< see Body, as for what follows
    double linearDamping = 0.0, angularDamping = 0.0;
};

/// A light as data. Names stand for Light::shape and Light::group, which are not set.
struct LevelLight {
    Light light;
    std::string shapeName;  ///< "" = fixed in the world
    std::string groupName;  ///< "" = none
};

/// A joint as data. Names stand for JointEnd::shape, which is not set.
struct LevelJoint {
    Joint joint;
    std::array<std::string, 2> shapeNames;  ///< "" = fixed in the world
};

/// The objects of a level whose data have no tags of their own.
enum class TaggedKind : uint8_t { Light, LightGroup, Water, Character, Joint };

/// The tags of one of them: the one with this number in the level's list of its kind.
struct LevelTags {
    TaggedKind kind = TaggedKind::Light;
    uint32_t number = 0;
    std::vector<std::string> tags;  ///< at least one
};

/// A level as data, independent of any World. PaletteEntry::lightGroup is the index into lightGroups plus one.
struct Level {
    std::string name;
    MaterialTable materials = defaultMaterials();
    std::vector<LevelBody> bodies;
    std::vector<LevelLight> lights;
    std::vector<LightGroup> lightGroups;
    uint32_t autoLightGroups = 0;  ///< the most groups that fitLights() makes from glowing voxels that have none
    Environment environment;
    WorldBox bounds;  ///< where the world ends; low == high: the box around all shapes, and a margin (load_level.h)
    std::vector<std::pair<std::string, Pose>> locations;  ///< named places: spawn points, cameras
    std::vector<Water> waters;
    std::vector<Trigger> triggers;
    std::vector<Character> characters;
    std::vector<LevelJoint> joints;
    std::vector<LevelScript> scripts;
    std::vector<LevelTags> tags;
};

}  // namespace rubble
