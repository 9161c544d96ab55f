// Sky, sun, air, gravity.
#include <cmath>
#include <glm/trigonometric.hpp>

#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

template <class F>
void change(Editor& editor, F&& f) {
    rubble_environment environment = editor.world().get_environment();
    f(environment);
    editor.world().set_environment(environment);
}

/// Towards the sun at an hour of a day on which it rises at 6 in the east (+x) and stands 55 degrees high at noon.
glm::dvec3 sunAt(double hour) {
    const double angle = (hour - 6.0) / 12.0 * glm::radians(180.0), tilt = glm::radians(55.0);
    return {std::cos(angle), std::sin(angle) * std::sin(tilt), std::sin(angle) * std::cos(tilt)};
}

void setTime(Editor& editor, const Arguments& arguments) {
    change(editor, [&](rubble_environment& environment) {
        if (arguments.has("clouds")) environment.clouds = arguments.number("clouds");
        double sun[3];
        put(sun, sunAt(arguments.number("hour")));
        environment = rubble::apply_sky_model(environment, sun);
        put(environment.sun_direction, vectorOf(sun));
    });
}

void setFog(Editor& editor, const Arguments& arguments) {
    change(editor, [&](rubble_environment& environment) {
        environment.fog_density = arguments.number("density");
        environment.fog_base = arguments.number("base");
        environment.fog_height = arguments.number("height");
        if (arguments.has("haze")) environment.fog_distance = arguments.number("haze");
    });
}

void setGravity(Editor& editor, const Arguments& arguments) {
    change(editor, [&](rubble_environment& environment) { put(environment.gravity, arguments.point("gravity")); });
}

void setExposure(Editor& editor, const Arguments& arguments) {
    change(editor, [&](rubble_environment& environment) { environment.exposure = arguments.number("factor"); });
}

void setWetness(Editor& editor, const Arguments& arguments) {
    change(editor, [&](rubble_environment& environment) { environment.wetness = arguments.number("share"); });
}

void setStress(Editor& editor, const Arguments& arguments) {
    rubble_settings settings = editor.world().get_settings();
    settings.flags = (settings.flags & ~uint32_t(RUBBLE_SETTING_STRESS)) |
                     (arguments.flag("on") ? uint32_t(RUBBLE_SETTING_STRESS) : 0u);
    settings.strength_scale = arguments.number("strength");
    editor.world().set_settings(settings);
    editor.say("no level holds this: it lasts until another level is opened");
}

}  // namespace

std::vector<Command> environmentCommands() {
    const auto number = [](std::string_view name, std::string_view help, std::string_view otherwise, double low,
                           double high) { return Parameter{name, Type::Number, help, otherwise, low, high}; };
    return {
        {"time",
         "environment",
         Kind::Edit,
         "Sets the time of day: sun, sky, haze and stars.",
         {number("hour", "0 to 24; 12: noon", "15", 0, 24), number("clouds", "0: clear, 1: overcast", kOptional, 0, 1)},
         setTime,
         "time 18.5"},
        {"fog",
         "environment",
         Kind::Edit,
         "Sets the fog that shows shafts of light.",
         {number("density", "extinction per metre; 0: none", "0.02", 0, 10),
          number("base", "height at which it begins to thin out, in metres", "0", -1000, 1000),
          number("height", "metres in which it thins to 1/e", "10", 0.1, 1e4),
          number("haze", "metres at which haze hides half", kOptional, 1, 1e5)},
         setFog,
         "fog 0.03"},
        {"gravity",
         "environment",
         Kind::Edit,
         "Sets gravity.",
         {{"gravity", Type::Point, "m/s2", "0,-9.81,0", -1000, 1000}},
         setGravity,
         "gravity 0,-3.7,0"},
        {"exposure",
         "environment",
         Kind::Edit,
         "Sets the factor on all light.",
         {number("factor", "1: as it is", "1", 0.001, 1000)},
         setExposure,
         "exposure 1.5"},
        {"wetness",
         "environment",
         Kind::Edit,
         "Sets how wet is what is open to the sky.",
         {number("share", "0: dry, 1: with puddles", "0.5", 0, 1)},
         setWetness,
         "wetness 0.7"},
        {"stress",
         "environment",
         Kind::Edit,
         "Says whether what stands breaks under its weight, until another level is opened: no level holds it.",
         {{"on", Type::Flag, "whether it does", "yes"},
          number("strength", "multiple of all materials' strengths", "1", 1e-6, 1e6)},
         setStress,
         "stress yes 0.8"},
    };
}

}  // namespace editor
