// Lights, the groups in which they go out, and what supplies those.
#include <glm/trigonometric.hpp>

#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

const Parameter kLights{"what", Type::Objects, "the lights", "selected"};

/// What is given of a light, into its settings.
void readLight(Editor& editor, const Arguments& arguments, rubble_light_settings& light) {
    const auto read = [&](const char* name, double& value) {
        if (arguments.has(name)) value = arguments.number(name);
    };
    if (arguments.has("at")) put(light.position, arguments.point("at"));
    if (arguments.has("turn")) put(light.rotation, rotationOf(arguments.point("turn")));
    if (arguments.has("color")) put(light.color, arguments.point("color"));
    read("radius", light.radius);
    read("reach", light.reach);
    read("width", light.width);
    read("height", light.height);
    if (arguments.has("cone")) {
        light.cone_outer = glm::radians(arguments.number("cone"));
        light.cone_inner = light.cone_outer * 0.8;
    }
    if (arguments.has("group")) light.group = editor.object(arguments, "group", {RUBBLE_KIND_LIGHT_GROUP});
    if (arguments.has("on"))
        light.flags =
            (light.flags & ~uint32_t(RUBBLE_LIGHT_ENABLED)) | (arguments.flag("on") ? RUBBLE_LIGHT_ENABLED : 0);
}

void addLight(Editor& editor, const Arguments& arguments) {
    rubble_light_settings light{};
    light.kind = uint32_t(arguments.choice("kind"));
    light.flags = RUBBLE_LIGHT_ENABLED;
    light.rotation[3] = 1.0;
    light.radius = 0.05, light.reach = 12.0;
    light.width = light.height = 0.5;
    light.cone_outer = glm::radians(35.0), light.cone_inner = glm::radians(28.0);
    put(light.color, {8.0, 5.8, 3.4});
    if (arguments.has("shape")) light.shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    readLight(editor, arguments, light);
    const rubble_light made = editor.world().create_light(light);
    editor.giveName(arguments, made);
    editor.selection() = {{made}, {}};
}

void setLight(Editor& editor, const Arguments& arguments) {
    for (const rubble_light each : editor.objects(arguments, "what", {RUBBLE_KIND_LIGHT})) {
        rubble_light_settings light = editor.world().get_light_settings(each);
        light.light = each;
        readLight(editor, arguments, light);
        editor.world().set_light(light);
    }
}

void addGroup(Editor& editor, const Arguments& arguments) {
    rubble_light_group_settings settings{};
    settings.flicker_steps = uint32_t(arguments.whole("flicker"));
    settings.threshold = arguments.number("threshold");
    const rubble_light_group made = editor.world().create_light_group(settings);
    editor.giveName(arguments, made);
}

void setGroup(Editor& editor, const Arguments& arguments) {
    for (const rubble_light_group each : editor.objects(arguments, "group", {RUBBLE_KIND_LIGHT_GROUP})) {
        rubble_light_group_change change{};
        change.group = each;
        if (arguments.has("on")) change.fields |= RUBBLE_GROUP_SWITCH, change.on = arguments.flag("on");
        if (arguments.has("threshold"))
            change.fields |= RUBBLE_GROUP_THRESHOLD, change.threshold = arguments.number("threshold");
        if (arguments.has("supply")) {
            change.fields |= RUBBLE_GROUP_SUPPLY;
            change.supply_shape = editor.object(arguments, "supply", {RUBBLE_KIND_SHAPE});
            const glm::ivec3 cell = arguments.cell("cell");
            for (int a = 0; a < 3; ++a) change.supply_cell[a] = cell[a];
        }
        if (!change.fields) throw Refused("set_light_group: expected something to set, found nothing");
        editor.world().set_light_group(change);
    }
}

std::vector<Parameter> lightParameters() {
    const auto number = [](std::string_view name, std::string_view help, double low, double high) {
        return Parameter{name, Type::Number, help, kOptional, low, high};
    };
    return {{"at", Type::Point, "in metres; on a shape: from the corner of its grid", kOptional},
            {"turn", Type::Point, "degrees about x, then y, then z; at first it faces -z", kOptional, -360, 360},
            {"color", Type::Point, "linear radiant intensity of red, green, blue", kOptional, 0, 1e6},
            number("radius", "metres, of what glows: how soft its shadows are", 0, 1000),
            number("reach", "metres beyond which it lights nothing", 0, 1e5),
            number("cone", "degrees from the middle to the rim, of a cone", 0, 180),
            number("width", "metres, of a tube, a rectangle, a screen", 0, 1000),
            number("height", "metres, of a rectangle or a screen", 0, 1000),
            {"group", Type::Objects, "the light group that it goes out with", kOptional},
            {"on", Type::Flag, "whether it shines", kOptional}};
}

}  // namespace

std::vector<Command> lightCommands() {
    std::vector<Parameter> added = lightParameters(), set = lightParameters();
    added.insert(added.begin(), {"kind", Type::Choice, "its form", "sphere", 0, 0, "sphere cone capsule area screen"});
    added.push_back({"shape", Type::Objects, "that it is fixed to and moves with", kOptional});
    added.push_back({"name", Type::Text, "by which others find it", ""});
    set.push_back(kLights);
    const Parameter threshold{"threshold", Type::Number, "share of its voxels whose loss puts it out", "0.4", 0.001, 1};
    Parameter otherThreshold = threshold;
    otherThreshold.otherwise = kOptional;
    return {
        {"light", "lights", Kind::Edit, "Adds a light.", added, addLight, "light cone 0,3,0 -90,0,0 name=spot"},
        {"set_light", "lights", Kind::Edit, "Changes lights.", set, setLight, "set_light reach=5 what=glow"},
        {"light_group",
         "lights",
         Kind::Edit,
         "Makes a group of lights and glowing voxels that go out together.",
         {{"name", Type::Text, "by which others find it", kRequired},
          threshold,
          {"flicker", Type::Whole, "steps of 1/60 s for which it flickers before it goes out", "30", 0, 3600}},
         addGroup,
         "light_group sign"},
        {"set_light_group",
         "lights",
         Kind::Edit,
         "Switches a light group, or says what puts it out.",
         {{"group", Type::Objects, "the group", kRequired},
          {"on", Type::Flag, "whether it shines", kOptional},
          otherThreshold,
          {"supply", Type::Objects, "the shape in which its wire begins", kOptional},
          {"cell", Type::Cell, "where in that shape", "0,0,0", 0, 4096}},
         setGroup,
         "set_light_group street on=no"},
    };
}

}  // namespace editor
