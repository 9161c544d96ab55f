#include "runtime/world/state/load_level.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/core/log.h"
#include "runtime/world/level/fit_lights.h"
#include "runtime/world/level/references.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/state/power_supply.h"

namespace rubble {
namespace {

using ShapeReferences = References<ShapeHandle>;

ShapeHandle loadShape(WorldData& world, BodyHandle body, const LevelShape& from) {
    Shape shape = makeShape(from, world.bodies.at(body), world.materials);
    shape.body = body;
    world.imported += shape.grid.voxelCount();
    const ShapeHandle handle = world.shapes.insert(std::move(shape));
    world.bodies.at(body).shapes.push_back(handle);
    return handle;
}

/// Leaves out shapes that are hidden or have no voxels, and bodies of such shapes only: a World's shapes have voxels.
ShapeReferences loadBodies(WorldData& world, const Level& level) {
    ShapeReferences references;
    const auto isLeftOut = [](const LevelShape& shape) { return shape.hidden || shape.grid.empty(); };
    for (const LevelBody& source : level.bodies) {
        if (!source.shapes.empty() && std::all_of(source.shapes.begin(), source.shapes.end(), isLeftOut)) {
            for (const LevelShape& shape : source.shapes) references.add(shape.name, {});
            continue;
        }
        Body body{.name = source.name, .pose = source.pose, .isStatic = source.isStatic, .tags = source.tags};
        body.velocity = source.velocity;
        body.angularVelocity = source.angularVelocity;
        body.gravityScale = source.gravityScale;
        body.linearDamping = source.linearDamping, body.angularDamping = source.angularDamping;
        body.asleep =
            !source.isStatic && source.velocity == glm::vec3(0.0f) && source.angularVelocity == glm::vec3(0.0f);
        const BodyHandle handle = world.bodies.insert(std::move(body));
        for (const LevelShape& shape : source.shapes)
            references.add(shape.name, isLeftOut(shape) ? ShapeHandle{} : loadShape(world, handle, shape));
    }
    return references;
}

/// Fills in LightGroup::initialVoxels where the level does not set it.
void countGroupVoxels(WorldData& world) {
    if (world.groups.size() == 0) return;
    std::vector<uint64_t> counts(world.groups.slotCount());
    world.shapes.forEach([&](ShapeHandle, const Shape& shape) {
        const Palette& palette = *shape.palette;
        if (std::none_of(palette.begin(), palette.end(),
                         [](const PaletteEntry& entry) { return entry.lightGroup != 0; }))
            return;
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const uint32_t group = palette[brick->at(i)].lightGroup;
                if (group && group <= counts.size()) ++counts[group - 1];
            });
        });
    });
    world.groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        if (group.initialVoxels == 0) group.initialVoxels = counts[handle.slot()];
    });
}

/// A supply from which no wire leads yet stays: its group shines until wire is looked for in that shape.
void connectPowerSupplies(WorldData& world, const ShapeReferences& shapes) {
    world.groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        group.supply = shapes.find(group.supplyShape);
        if (!group.supply && group.supplyShape.empty()) return;
        if (group.supply) group.supplyShape = world.shapes.at(group.supply).name;
        if (group.out || group.failingSince || isPowered(world, handle, group)) return;
        logWarning("light group '" + group.name + "': expected wire from its supply to its voxels, found none: it " +
                   (group.supply ? "goes out when that shape loses wire or a piece" : "needs no supply"));
    });
}

/// The objects of a level by TaggedKind and number; empty: it was left out.
using TaggedObjects = std::array<std::vector<AnyObject>, 5>;
void loadTags(WorldData& world, const Level& level, const TaggedObjects& objects) {
    std::set<uint64_t> tagged;
    for (const LevelTags& each : level.tags) {
        const AnyObject object = objects.at(size_t(each.kind)).at(each.number);
        if (bitsOf(object) && tagged.insert(bitsOf(object)).second)
            world.notes.insert({.object = object, .setsTags = true, .tags = each.tags});
    }
}

std::vector<AnyObject> loadLights(WorldData& world, const Level& level, const ShapeReferences& shapes) {
    std::vector<AnyObject> loaded;
    References<LightGroupHandle> groups;
    world.groups.forEach([&](LightGroupHandle handle, const LightGroup& group) { groups.add(group.name, handle); });
    for (const LevelLight& source : level.lights) {
        Light light = source.light;
        light.shape = shapes.find(source.shapeName);
        light.group = groups.find(source.groupName);
        loaded.push_back(world.lights.insert(std::move(light)));
    }
    return loaded;
}

std::vector<AnyObject> loadJoints(WorldData& world, const Level& level, const ShapeReferences& shapes) {
    std::vector<AnyObject> loaded;
    for (const LevelJoint& source : level.joints) {
        Joint joint = source.joint;
        std::string error;
        for (size_t i = 0; i < 2; ++i) {
            joint.ends[i].shape = shapes.find(source.shapeNames[i]);
            if (!source.shapeNames[i].empty() && !joint.ends[i].shape)
                error = "there is no shape '" + source.shapeNames[i] + "'";
        }
        if (error.empty()) error = attachJoint(world, joint);
        joint.steerTarget = source.joint.steerTarget;
        loaded.push_back(error.empty() ? world.joints.insert(std::move(joint)) : JointHandle());
        if (!error.empty()) logWarning("joint '" + source.joint.name + "': " + error + "; it is left out");
    }
    return loaded;
}

/// The box around all shapes, or all static ones, within the range of places; none without any.
WorldBox boxOfShapes(const WorldData& world, bool onlyStatic) {
    std::optional<WorldBox> all;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (onlyStatic && !world.bodies.at(shape.body).isStatic) return;
        const WorldBox box = gridBounds(world, handle);
        all = all ? all->merged(box) : box;
    });
    return all ? withinRange(*all) : WorldBox{};
}

/// Widens a box, which is empty if low == high, around a shape.
void include(WorldBox& all, const WorldData& world, ShapeHandle shape) {
    const WorldBox box = withinRange(gridBounds(world, shape));
    if (box.low != box.high) all = all.low == all.high ? box : all.merged(box);
}

/// A side of a grid: the one of the lowest or of the highest cells along an axis.
struct Face {
    int axis;
    bool isHigh;
};

/// The side of a turned grid that faces the ground most; of equal ones that of the lowest cells along y, x or z.
Face lowestFace(const glm::dquat& rotation) {
    constexpr double kEqual = 1e-6;
    const glm::dvec3 down = glm::conjugate(rotation) * glm::dvec3(0.0, -1.0, 0.0);
    Face lowest{1, false};
    double steepest = -down.y;
    for (const Face face : {Face{0, false}, Face{2, false}, Face{0, true}, Face{1, true}, Face{2, true}}) {
        const double along = face.isHigh ? down[face.axis] : -down[face.axis];
        if (along <= steepest + kEqual) continue;
        lowest = face;
        steepest = along;
    }
    return lowest;
}

CellBox bottomLayer(const VoxelGrid& grid, const glm::dquat& rotation) {
    const Face face = lowestFace(rotation);
    const int size = grid.size()[face.axis];
    const auto layerOf = [&](int cell) { return face.isHigh ? size - 1 - cell : cell; };
    int lowest = grid.empty() ? 0 : size;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const int first = position[face.axis] * kBrickSize;
        if (layerOf(face.isHigh ? first + kBrickSize - 1 : first) >= lowest) return;
        forEachVoxel(brick->occupancy,
                     [&](int i) { lowest = std::min(lowest, layerOf(first + voxelInBrick(i)[face.axis])); });
    });
    CellBox layer{glm::ivec3(0), grid.size()};
    layer.low[face.axis] = layerOf(lowest);
    layer.high[face.axis] = layer.low[face.axis] + 1;
    return layer;
}

}  // namespace

void anchorByDefault(Shape& shape, const Body& body) {
    if (!body.isStatic || !shape.anchors.empty()) return;
    shape.anchors = {bottomLayer(shape.grid, body.pose.rotation * shape.local.rotation)};
}

Shape makeShape(const LevelShape& from, const Body& body, const MaterialTable& materials) {
    Shape shape{.name = from.name, .local = from.local, .voxelSize = from.voxelSize, .grid = from.grid};
    shape.palette = from.palette ? from.palette : std::make_shared<const Palette>();
    if (from.paintColors && from.paintColors->count) shape.paintColors = from.paintColors;
    shape.tags = from.tags;
    shape.strength = from.strength;
    shape.loadBearing = from.loadBearing;
    shape.collisionLayer = from.collisionLayer;
    shape.collisionMask = from.collisionMask;
    shape.collisionShape = from.collisionShape;
    shape.density = from.density;
    shape.emission = from.emission;
    shape.anchors = translatedBoxes(from.anchors, glm::ivec3(0), shape.grid.size());
    if (from.anchors.empty()) anchorByDefault(shape, body);
    shape.moments = gridMoments(shape.grid, *shape.palette, materials);
    return shape;
}

void includeMade(WorldData& world, ShapeHandle shape) {
    if (world.bounds.low == world.bounds.high) include(world.made, world, shape);
}

void includeStatics(WorldData& world, std::span<const ShapeHandle> shapes) {
    for (const ShapeHandle handle : shapes)
        if (const Shape* shape = world.shapes.find(handle); shape && world.bodies.at(shape->body).isStatic) {
            include(world.footprint, world, handle);
            includeMade(world, handle);
        }
}

PaletteRef materialPalette(const MaterialTable& materials) {
    auto palette = std::make_shared<Palette>();
    for (size_t i = 1; i < palette->size(); ++i)
        (*palette)[i].material = uint8_t(std::min(i, std::max<size_t>(materials.materials.size(), 1) - 1));
    const uint8_t glass = materials.find("glass"), generic = materials.find("generic");
    if (glass == 1 && generic) std::swap((*palette)[glass].material, (*palette)[generic].material);
    return palette;
}

void loadLevel(WorldData& world, const Level& level) {
    if (level.autoLightGroups) {
        Level fitted = level;
        fitLights(fitted);
        fitted.autoLightGroups = 0;
        return loadLevel(world, fitted);
    }
    world.clear();
    world.name = level.name;
    world.materials = level.materials;
    world.wire = world.materials.find("wire");
    world.locations = level.locations;
    world.scripts = level.scripts;
    world.hostData.clear();
    world.setEnvironment(level.environment);
    TaggedObjects tagged;
    const auto listOf = [&](TaggedKind kind) -> std::vector<AnyObject>& { return tagged[size_t(kind)]; };
    for (const LightGroup& group : level.lightGroups)
        listOf(TaggedKind::LightGroup).push_back(world.groups.insert(group));
    const ShapeReferences shapes = loadBodies(world, level);
    countGroupVoxels(world);
    connectPowerSupplies(world, shapes);
    listOf(TaggedKind::Light) = loadLights(world, level, shapes);
    for (const Water& water : level.waters) listOf(TaggedKind::Water).push_back(world.waters.insert(water));
    for (Trigger trigger : level.triggers) {
        trigger.inside.clear();
        world.triggers.insert(std::move(trigger));
    }
    for (Character character : level.characters) {
        character.ground = {};
        listOf(TaggedKind::Character).push_back(world.characters.insert(std::move(character)));
    }
    listOf(TaggedKind::Joint) = loadJoints(world, level, shapes);
    loadTags(world, level, tagged);
    world.footprint = boxOfShapes(world, true);
    world.bounds = level.bounds;
    if (level.bounds.low == level.bounds.high) world.made = boxOfShapes(world, false);
    world.rebuildIndexes();
}

}  // namespace rubble
