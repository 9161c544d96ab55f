// What breaks things, in play or while editing.
#include <fmt/format.h>

#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

constexpr double kSootRadius = 1.45;  ///< of an explosion, as a multiple of its size

/// While the level is edited tools leave alone what is locked, as all other edits do.
void requireUnlocked(Editor& editor, const Arguments& arguments, double reach) {
    if (editor.document().isPlaying()) return;
    rubble_query_shape ball{};
    ball.kind = RUBBLE_QUERY_SPHERE;
    put(ball.position, arguments.point("at"));
    ball.radius = reach;
    for (const rubble_shape shape : editor.world().overlap_shapes(ball))
        if (isLocked(editor.world(), shape))
            arguments.refuse("at",
                             fmt::format("what is not locked within {} m, found '{}': unlock it first, or play", reach,
                                         nameOf(editor.world(), editor.world().get_shape_state(shape).body)));
}

void explode(Editor& editor, const Arguments& arguments) {
    rubble_explosion explosion{};
    put(explosion.position, arguments.point("at"));
    explosion.size = arguments.number("size");
    requireUnlocked(editor, arguments, kSootRadius * explosion.size);
    editor.world().explode(explosion);
}

void carve(Editor& editor, const Arguments& arguments) {
    requireUnlocked(editor, arguments, arguments.number("radius"));
    rubble_carve hole{};
    hole.brush = RUBBLE_BRUSH_SPHERE;
    put(hole.position, arguments.point("at"));
    for (double& radius : hole.radii) radius = arguments.number("radius");
    editor.world().carve(hole);
}

void shatter(Editor& editor, const Arguments& arguments) {
    requireUnlocked(editor, arguments, arguments.number("radius"));
    rubble_break blow{};
    put(blow.position, arguments.point("at"));
    for (double& radius : blow.radii) radius = arguments.number("radius");
    blow.seed = uint32_t(arguments.whole("seed"));
    editor.world().break_voxels(blow);
}

void spray(Editor& editor, const Arguments& arguments) {
    requireUnlocked(editor, arguments, arguments.number("radius"));
    rubble_paint paint{};
    const auto color = arguments.color("color");
    std::copy(color.begin(), color.end(), paint.color);
    put(paint.position, arguments.point("at"));
    paint.radius = arguments.number("radius");
    paint.strength = 255;
    editor.world().paint(paint);
}

void push(Editor& editor, const Arguments& arguments) {
    for (const rubble_body body : editor.objects(arguments, "what", {RUBBLE_KIND_BODY})) {
        rubble_impulse impulse{};
        impulse.body = body;
        put(impulse.position, vectorOf(editor.world().get_body_state(body).position));
        put(impulse.impulse, arguments.point("impulse"));
        editor.world().apply_impulse(impulse);
    }
}

}  // namespace

std::vector<Command> toolCommands() {
    const Parameter at{"at", Type::Point, "where, in metres", kRequired};
    const auto radius = [](std::string_view otherwise, double high) {
        return Parameter{"radius", Type::Number, "metres", otherwise, 0.001, high};
    };
    return {
        {"explode",
         "tools",
         Kind::Tool,
         "Breaks and pushes what is around a place.",
         {at, {"size", Type::Number, "metres in which soft things break", "1", 0.5, 4}},
         explode,
         "explode 0,1,2 1"},
        {"carve",
         "tools",
         Kind::Tool,
         "Removes a ball of voxels.",
         {at, radius("0.5", 100)},
         carve,
         "carve 0,1.5,2 0.4"},
        {"shatter",
         "tools",
         Kind::Tool,
         "Breaks a ball of voxels into fragments.",
         {at, radius("0.5", 100), {"seed", Type::Whole, "of the cracks", "1", 0, 1e6}},
         shatter,
         "shatter 0,1.5,2 0.4"},
        {"spray",
         "tools",
         Kind::Tool,
         "Paints the surface of voxels.",
         {at, {"color", Type::Color, "sRGB", "#c03020"}, radius("0.5", 10)},
         spray,
         "spray 0,1,1.9 #c03020"},
        {"push",
         "tools",
         Kind::Tool,
         "Pushes bodies.",
         {{"impulse", Type::Point, "N s", kRequired, -1e9, 1e9}, {"what", Type::Objects, "the bodies", "selected"}},
         push,
         "push 0,0,50 crate"},
    };
}

}  // namespace editor
