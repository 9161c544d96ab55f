// What a shape is beside its voxels, and what it is a part of.
#include <map>
#include <set>
#include <vector>

#include "editor/core/models.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

const Parameter kShapes{"shape", Type::Objects, "the shapes", "selected"};

template <class F>
void forEachShape(Editor& editor, const Arguments& arguments, F&& f) {
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) f(shape);
}

/// Each part would become the whole of what the file says.
void splitParts(Editor& editor, const Arguments& arguments) {
    rubble::World& world = editor.world();
    const std::vector<rubble_shape> all = world.get_objects(RUBBLE_KIND_SHAPE);
    const std::set<rubble_shape> before(all.begin(), all.end());
    std::map<rubble_shape, uint64_t> voxels;
    forEachShape(editor, arguments, [&](rubble_shape shape) {
        voxels[shape] = world.get_shape_state(shape).voxel_count;
        world.split_shape(shape);
    });
    editor.document().applyNow();
    std::vector<rubble_shape> parts;
    for (const rubble_shape shape : world.get_objects(RUBBLE_KIND_SHAPE)) {
        const auto split = voxels.find(shape);
        const bool hasLost = split != voxels.end() && world.get_shape_state(shape).voxel_count != split->second;
        if (hasLost || !before.contains(shape)) parts.push_back(shape);
    }
    const size_t unlinked = unlinkModels(world, parts);
    if (unlinked) editor.say(rubble::counted(unlinked, "part") + " unlinked: the file has the whole shape");
}

/// The file would take away what was added.
void merge(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE}),
                       into = editor.object(arguments, "into", {RUBBLE_KIND_SHAPE});
    editor.world().merge_shape(shape, into);
    editor.document().applyNow();
    const bool isMerged = kindOf(editor.world(), shape) < 0;
    if (isMerged && unlinkModels(editor.world(), {into}))
        editor.say(shownName(editor.world(), into) + " unlinked: the file has it without what was added");
}

void setProperties(Editor& editor, const Arguments& arguments) {
    forEachShape(editor, arguments, [&](rubble_shape shape) {
        rubble_shape_change change{};
        change.shape = shape;
        const auto read = [&](const char* name, uint32_t field, double& value) {
            if (arguments.has(name)) change.fields |= field, value = arguments.number(name);
        };
        read("strength", RUBBLE_SHAPE_STRENGTH, change.strength);
        read("density", RUBBLE_SHAPE_DENSITY, change.density);
        read("emission", RUBBLE_SHAPE_EMISSION, change.emission);
        if (arguments.has("bears_load"))
            change.fields |= RUBBLE_SHAPE_LOAD, change.bears_load = arguments.flag("bears_load");
        if (!change.fields) throw Refused("shape: expected something to set, found nothing");
        editor.world().set_shape(change);
    });
}

void anchor(Editor& editor, const Arguments& arguments) {
    forEachShape(editor, arguments, [&](rubble_shape shape) {
        rubble_shape_change change{};
        change.shape = shape, change.fields = RUBBLE_SHAPE_DEFAULT_ANCHORS;
        editor.world().set_shape(change);
    });
}

}  // namespace

std::vector<Command> shapePropertyCommands() {
    const auto share = [](std::string_view name, std::string_view help, double low, double high) {
        return Parameter{name, Type::Number, help, kOptional, low, high};
    };
    return {
        {"split",
         "shapes",
         Kind::Edit,
         "Makes shapes of the parts that do not touch; they are linked to no file any more.",
         {kShapes},
         splitParts,
         "split parts"},
        {"merge",
         "shapes",
         Kind::Edit,
         "Adds a shape to another one of its body that it touches, which is linked to no file any more.",
         {{"shape", Type::Objects, "the shape that is added", kRequired},
          {"into", Type::Objects, "the shape that grows", kRequired}},
         merge,
         "merge lid box"},
        {"shape",
         "shapes",
         Kind::Edit,
         "Sets what a shape is beside its voxels.",
         {kShapes,
          share("strength", "multiple of its materials' strengths under load", 1e-6, 1e6),
          share("density", "multiple of its materials' densities", 0.001, 1000),
          share("emission", "multiple of what its entries emit", 0, 1000),
          {"bears_load", Type::Flag, "whether weight and impacts may break it", kOptional}},
         setProperties,
         "shape wall strength=2 bears_load=no"},
        {"anchor",
         "shapes",
         Kind::Edit,
         "Holds a static shape to the world by its lowest layer of voxels, as it stands.",
         {kShapes},
         anchor,
         "anchor post"},
    };
}

}  // namespace editor
