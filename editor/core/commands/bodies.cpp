// Bodies, and shapes on them: made, placed, duplicated, deleted.
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "editor/core/body_copies.h"
#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "editor/core/material_colors.h"
#include "editor/core/models.h"
#include "editor/core/rotation.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

const Parameter kBodies{"what", Type::Objects, "the bodies", "selected"};
const Parameter kTurn{"turn", Type::Point, "degrees about x, then y, then z", "0,0,0", -360, 360};

/// The cells of a cylinder along an axis that fills a grid.
std::vector<rubble_voxel_run> cylinderOf(glm::ivec3 size, int along, uint32_t index) {
    std::vector<rubble_voxel_run> runs;
    const auto isIn = [&](glm::ivec3 cell) {
        glm::dvec3 out = glm::dvec3(2 * cell + 1 - size) / glm::dvec3(size);
        out[along] = 0.0;
        return glm::dot(out, out) <= 1.0;
    };
    for (glm::ivec3 cell(0); cell.z < size.z; ++cell.z)
        for (cell.y = 0; cell.y < size.y; ++cell.y)
            for (cell.x = 0; cell.x < size.x; ++cell.x) {
                const uint32_t voxel = isIn(cell) ? index : 0;
                if (runs.empty() || runs.back().index != voxel) runs.push_back({0, voxel});
                ++runs.back().cells;
            }
    return runs;
}

/// A shape's settings as the parameters of shapeParameters() say.
rubble_shape_settings shapeSettings(const Arguments& arguments) {
    static constexpr uint32_t kSources[] = {RUBBLE_SHAPE_BOX, RUBBLE_SHAPE_SPHERE, RUBBLE_SHAPE_RUNS};
    rubble_shape_settings shape{};
    const glm::ivec3 size = arguments.cell("size");
    for (int a = 0; a < 3; ++a) shape.size[a] = size[a];
    shape.source = kSources[std::min(arguments.choice("form"), 2)];
    shape.voxel_size = arguments.number("voxel");
    shape.index = uint32_t(arguments.whole("index"));
    return shape;
}

/// Makes a shape in the form that the parameters say.
rubble_shape makeShape(Editor& editor, const Arguments& arguments, rubble_shape_settings& shape) {
    std::vector<rubble_voxel_run> runs;
    if (shape.source == RUBBLE_SHAPE_RUNS) {
        const glm::ivec3 size = arguments.cell("size");
        const uint64_t cells = uint64_t(size.x) * uint64_t(size.y) * uint64_t(size.z);
        if (cells > kMaxCells) arguments.refuse("size", fmt::format("at most {} cells, found {}", kMaxCells, cells));
        runs = cylinderOf(size, arguments.choice("form") - 2, shape.index);
        shape.runs = runs.data(), shape.count = runs.size();
    }
    const rubble_shape made = editor.world().create_shape(shape);
    colorByMaterial(editor, made);
    return made;
}

/// Makes a body whose shape has its middle, or the middle of its lowest layer, at a place.
void create(Editor& editor, const Arguments& arguments) {
    rubble_shape_settings shape = shapeSettings(arguments);
    const glm::dvec3 extent = glm::dvec3(shape.size[0], shape.size[1], shape.size[2]) * shape.voxel_size;
    rubble_body_settings body{};
    body.flags = arguments.flag("static") ? RUBBLE_BODY_STATIC : RUBBLE_BODY_ASLEEP;
    put(body.position, arguments.point("at"));
    put(body.rotation, rotationOf(arguments.point("turn")));
    shape.body = editor.world().create_body(body);
    put(shape.position, {-extent.x / 2, arguments.flag("on_ground") ? 0.0 : -extent.y / 2, -extent.z / 2});
    makeShape(editor, arguments, shape);
    editor.giveName(arguments, shape.body);
    editor.selection() = {{shape.body}, {}};
}

void addShape(Editor& editor, const Arguments& arguments) {
    rubble_shape_settings shape = shapeSettings(arguments);
    shape.body = editor.object(arguments, "body", {RUBBLE_KIND_BODY});
    put(shape.position, arguments.point("at"));
    put(shape.rotation, rotationOf(arguments.point("turn")));
    const rubble_shape made = makeShape(editor, arguments, shape);
    editor.giveName(arguments, made);
    editor.selection() = {{made}, {}};
}

MeshOptions meshOptions(const Arguments& arguments) {
    MeshOptions options;
    options.voxels = arguments.whole("voxels");
    options.voxel = arguments.number("voxel");
    options.shell = arguments.whole("shell");
    options.isZUp = arguments.text("up") == "z";
    options.isSmooth = arguments.flag("smooth");
    return options;
}

void import(Editor& editor, const Arguments& arguments) {
    const ModelSource source{arguments.text("file"), meshOptions(arguments)};
    const Place place{arguments.point("at"), rotationOf(arguments.point("turn"))};
    std::vector<std::string> report;
    const std::vector<rubble_prefab_row> rows =
        placeModel(editor.world(), source, editor.settings().vdbTool, place, report);
    for (const std::string& line : report) editor.say(line);
    if (arguments.flag("link")) linkModels(editor, source, place, rows);
    editor.selection() = {};
    size_t bodies = 0, shapes = 0;
    for (const rubble_prefab_row& row : rows) {
        shapes += row.kind == RUBBLE_PREFAB_SHAPE;
        if (row.kind != RUBBLE_PREFAB_BODY) continue;
        ++bodies;
        editor.selection().objects.push_back(row.handle);
    }
    editor.say(fmt::format("{} with {}", rubble::counted(bodies, "body", "bodies"), rubble::counted(shapes, "shape")));
}

void destroyOne(rubble::World& world, uint64_t object) {
    switch (kindOf(world, object)) {
        case RUBBLE_KIND_BODY:
            return world.destroy_body(object);
        case RUBBLE_KIND_SHAPE:
            return world.destroy_shape(object);
        case RUBBLE_KIND_LIGHT:
            return world.remove_light(object);
        case RUBBLE_KIND_WATER:
            return world.remove_water(object);
        case RUBBLE_KIND_TRIGGER:
            return world.remove_trigger(object);
        case RUBBLE_KIND_JOINT:
            return world.remove_joint(object);
        default:
            return;
    }
}

/// What is on others goes first: with a shape go its lights and joints, with a body its shapes.
void destroy(Editor& editor, const Arguments& arguments) {
    const std::vector<uint64_t> all = editor.objects(arguments, "what",
                                                     {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_LIGHT,
                                                      RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER, RUBBLE_KIND_JOINT});
    rubble::World& world = editor.world();
    const std::set<uint64_t> chosen(all.begin(), all.end());
    for (const int kind : {RUBBLE_KIND_JOINT, RUBBLE_KIND_LIGHT, RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER,
                           RUBBLE_KIND_SHAPE, RUBBLE_KIND_BODY})
        for (const uint64_t each : all) {
            if (kindOf(world, each) != kind) continue;
            const bool goesWithBody = kind == RUBBLE_KIND_SHAPE && chosen.contains(world.get_shape_state(each).body);
            if (!goesWithBody) destroyOne(world, each);
        }
}

void duplicate(Editor& editor, const Arguments& arguments) {
    std::vector<uint64_t> made;
    const std::vector<uint64_t> bodies = editor.objects(arguments, "what", {RUBBLE_KIND_BODY});
    const glm::dvec3 by = arguments.point("by");
    for (const rubble_body each : bodies) {
        const glm::dvec3 from = vectorOf(editor.world().get_body_state(each).position);
        arguments.requireNear("by", from + by * double(arguments.whole("times")));
    }
    std::set<std::string> notes;
    for (int i = 1; i <= arguments.whole("times"); ++i)
        for (const rubble_body each : copyBodies(editor, bodies, by * double(i), notes)) made.push_back(each);
    for (const std::string& note : notes) editor.say(note);
    editor.selection() = {std::move(made), {}};
}

std::vector<Parameter> shapeParameters() {
    return {{"size", Type::Cell, "cells along each axis", "8,8,8", 1, 4096},
            {"at", Type::Point, "where it comes, in metres", "0,0,0"},
            {"index", Type::Whole, "entry of the palette, as a material: 5 wood, 7 brick, 9 metal, 15 glass",
             kDefaultEntry, 1, 255},
            {"name", Type::Text, "by which others find it", ""},
            {"form", Type::Choice, "what is filled", "box", 0, 0, "box sphere cylinder_x cylinder_y cylinder_z"},
            {"voxel", Type::Number, "side of a voxel in metres", "0.1", 0.001, 10},
            kTurn};
}

}  // namespace

std::vector<Command> bodyCommands() {
    std::vector<Parameter> created = shapeParameters(), added = shapeParameters();
    created.push_back({"static", Type::Flag, "whether it stands still", "no"});
    created.push_back({"on_ground", Type::Flag, "whether the place is that of its foot, not of its middle", "yes"});
    added.insert(added.begin(), {"body", Type::Objects, "the body that it is fixed to", "selected"});
    const Parameter by{"by", Type::Point, "metres along x, y and z", kRequired};
    return {
        {"create", "bodies", Kind::Edit, "Makes a body with one shape.", created, create,
         "create 6,6,6 3,0,3 index=7 name=block static=yes"},
        {"add_shape", "bodies", Kind::Edit, "Adds a shape to a body, at a place of the body's frame.", added, addShape,
         "add_shape crate 4,4,4 0,0.8,0 index=9 name=knob"},
        {"import",
         "bodies",
         Kind::Edit,
         "Places what a .vox, .vdb or .rubble file holds, or makes voxels of a mesh: .obj, .ply or .glb.",
         {{"file", Type::Text, "its path", kRequired, 0, 0, ".vox .vdb .rubble .obj .ply .glb"},
          {"at", Type::Point, "where its origin comes", "0,0,0"},
          kTurn,
          {"voxels", Type::Whole, "of a mesh: voxels along its longest side; 0: as long as the file says", "64", 0,
           4096},
          {"voxel", Type::Number, "of a mesh: metres along an edge of a voxel", "0.1", 0.001, 10},
          {"shell", Type::Whole, "of a mesh: voxels that its walls are thick; 0: solid", "0", 0, 64},
          {"up", Type::Choice, "of a mesh: the axis that is up in the file", "y", 0, 0, "y z"},
          {"smooth", Type::Flag, "of a mesh: mixes the pixels of textures; else the nearest one counts", "no"},
          {"link", Type::Flag, "whether shapes stay linked to the file, for reload_models", "yes"}},
         import,
         "import model.rubble 0,2,0"},
        {"delete",
         "bodies",
         Kind::Edit,
         "Deletes objects: bodies, shapes, lights, joints, water, triggers.",
         {{"what", Type::Objects, "the objects", "selected"}},
         destroy,
         "delete ball"},
        {"duplicate",
         "bodies",
         Kind::Edit,
         "Makes copies of bodies, which are selected then: with lights, tags, and joints among them or to the world.",
         {by, {"times", Type::Whole, "how many, each farther on", "1", 1, 100}, kBodies},
         duplicate,
         "duplicate 2,0,0 2 crate"},
    };
}

}  // namespace editor
