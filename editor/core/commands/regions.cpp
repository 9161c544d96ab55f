// Water and triggers.
#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

void addWater(Editor& editor, const Arguments& arguments) {
    const glm::dvec3 from = arguments.point("from"), to = arguments.point("to");
    if (from.x == to.x || from.z == to.z)
        arguments.refuse("to", "a corner at another x and z than from, found the same");
    const double outline[] = {from.x, from.z, to.x, from.z, to.x, to.z, from.x, to.z};
    rubble_water_settings water{};
    water.outline = outline;
    water.outline_count = 4;
    water.surface_height = std::max(from.y, to.y);
    water.depth = std::max(std::abs(to.y - from.y), 0.01);
    put(water.flow, arguments.point("flow"));
    const rubble_water made = editor.world().create_water(water);
    editor.giveName(arguments, made);
    editor.selection() = {{made}, {}};
}

void addTrigger(Editor& editor, const Arguments& arguments) {
    rubble_trigger_settings trigger{};
    trigger.kind = arguments.text("form") == "sphere" ? RUBBLE_TRIGGER_SPHERE : RUBBLE_TRIGGER_BOX;
    put(trigger.position, arguments.point("at"));
    put(trigger.half_size, arguments.point("size") * 0.5);
    trigger.radius = arguments.point("size").x * 0.5;
    const rubble_trigger made = editor.world().create_trigger(trigger);
    editor.giveName(arguments, made);
    editor.selection() = {{made}, {}};
}

}  // namespace

std::vector<Command> regionCommands() {
    return {
        {"water",
         "regions",
         Kind::Edit,
         "Adds water in a box along the world's axes.",
         {{"from", Type::Point, "one corner, in metres", kRequired},
          {"to", Type::Point, "the opposite corner", kRequired},
          {"flow", Type::Point, "m/s", "0,0,0", -100, 100},
          {"name", Type::Text, "by which others find it", ""}},
         addWater,
         "water 6,-1,-2 10,0.5,2 name=pool"},
        {"trigger",
         "regions",
         Kind::Edit,
         "Adds a region that reports who enters and leaves it.",
         {{"name", Type::Text, "by which scripts find it", kRequired},
          {"at", Type::Point, "its middle, in metres", kRequired},
          {"size", Type::Point, "metres along x, y and z; of a sphere: its diameter", "2,2,2", 0.01, 1e4},
          {"form", Type::Choice, "its form", "box", 0, 0, "box sphere"}},
         addTrigger,
         "trigger gate 0,1,0"},
    };
}

}  // namespace editor
