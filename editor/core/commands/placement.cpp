// Where bodies are, and how they move.
#include <algorithm>
#include <iterator>

#include "editor/core/editor.h"
#include "editor/core/joints.h"
#include "editor/core/places.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

const Parameter kBodies{"what", Type::Objects, "the bodies", "selected"};
const Parameter kPlaced{"what", Type::Objects, "the bodies, lights and joints", "selected"};

template <class F>
void forEachBody(Editor& editor, const Arguments& arguments, F&& f) {
    for (const rubble_body body : editor.objects(arguments, "what", {RUBBLE_KIND_BODY}))
        f(editor.world().get_body_state(body));
}

/// Bodies, lights and joints; a light or joint on a body that is among them goes with it.
std::vector<uint64_t> placed(Editor& editor, const Arguments& arguments) {
    const rubble::World& world = editor.world();
    const std::vector<uint64_t> all =
        editor.objects(arguments, "what", {RUBBLE_KIND_BODY, RUBBLE_KIND_LIGHT, RUBBLE_KIND_JOINT});
    const auto isOnOne = [&](rubble_shape shape) {
        return shape && std::ranges::find(all, world.get_shape_state(shape).body) != all.end();
    };
    const auto goesAlong = [&](uint64_t each) {
        const int kind = kindOf(world, each);
        if (kind == RUBBLE_KIND_LIGHT) return isOnOne(world.get_light_settings(each).shape);
        return kind == RUBBLE_KIND_JOINT && std::ranges::any_of(world.get_joint_state(each).shapes, isOnOne);
    };
    std::vector<uint64_t> out;
    std::ranges::remove_copy_if(all, std::back_inserter(out), goesAlong);
    for (const uint64_t each : out)
        if (kindOf(world, each) == RUBBLE_KIND_JOINT && !hasFrame(world, each))
            arguments.refuse("what", "no ropes and steered wheels but with their bodies, found " + nameOf(world, each));
    return out;
}

/// Puts one somewhere. What was selected stays so.
void put(Editor& editor, uint64_t object, const Place& place) {
    const uint64_t now = setPlace(editor.world(), object, place);
    std::ranges::replace(editor.selection().objects, object, now);
}

void move(Editor& editor, const Arguments& arguments) {
    const glm::dvec3 by = arguments.point("by");
    for (const uint64_t each : placed(editor, arguments)) {
        Place place = placeOf(editor.world(), each);
        place.position += by;
        arguments.requireNear("by", place.position);
        put(editor, each, place);
    }
}

void drop(Editor& editor, const Arguments& arguments) {
    const double depth = depthBelow(editor.world(), editor.objects(arguments, "what", {RUBBLE_KIND_BODY}));
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        Place place = placeOf(editor.world(), body.body);
        place.position.y -= depth;
        put(editor, body.body, place);
    });
}

void place(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : placed(editor, arguments)) {
        Place place = placeOf(editor.world(), each);
        place.position = arguments.point("at");
        if (arguments.has("turn")) place.rotation = rotationOf(arguments.point("turn"));
        put(editor, each, place);
    }
}

/// About the middle of all of them, or about a point.
void rotate(Editor& editor, const Arguments& arguments) {
    const std::vector<uint64_t> all = placed(editor, arguments);
    glm::dvec3 middle(0.0);
    for (const uint64_t each : all) middle += placeOf(editor.world(), each).position / double(all.size());
    if (arguments.has("about")) middle = arguments.point("about");
    const glm::dquat turn = rotationOf(arguments.point("turn"));
    for (const uint64_t each : all) {
        Place place = placeOf(editor.world(), each);
        place.position = middle + turn * (place.position - middle);
        place.rotation = turn * place.rotation;
        arguments.requireNear("about", place.position);
        put(editor, each, place);
    }
}

void hold(Editor& editor, const Arguments& arguments) {
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        rubble_body_change change{};
        change.body = body.body;
        change.fields = arguments.flag("static") ? RUBBLE_SET_STATIC : RUBBLE_SET_DYNAMIC;
        editor.world().set_body(change);
    });
}

void setBody(Editor& editor, const Arguments& arguments) {
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        const rubble_body_properties now = editor.world().get_body_properties(body.body);
        const auto value = [&](const char* name, double otherwise) {
            return arguments.has(name) ? arguments.number(name) : otherwise;
        };
        rubble_body_change change{};
        change.body = body.body;
        change.fields = RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
        change.gravity_scale = value("gravity", now.gravity_scale);
        change.linear_damping = value("damping", now.linear_damping);
        change.angular_damping = value("spin_damping", now.angular_damping);
        editor.world().set_body(change);
    });
}

}  // namespace

std::vector<Command> placementCommands() {
    const Parameter by{"by", Type::Point, "metres along x, y and z", kRequired};
    const auto number = [](std::string_view name, std::string_view help, double low, double high) {
        return Parameter{name, Type::Number, help, kOptional, low, high};
    };
    return {
        {"move", "bodies", Kind::Edit, "Moves bodies, lights and joints.", {by, kPlaced}, move, "move 0,1,0 crate"},
        {"drop",
         "bodies",
         Kind::Edit,
         "Lowers bodies together until one rests on what is below; where nothing is, on height 0.",
         {kBodies},
         drop,
         "drop floating"},
        {"place",
         "bodies",
         Kind::Edit,
         "Puts bodies, lights or joints at a place.",
         {{"at", Type::Point, "of the frame of the body or joint, or of the light, in metres", kRequired},
          {"turn", Type::Point, "degrees about x, then y, then z", kOptional, -360, 360},
          kPlaced},
         place,
         "place 1,2,3 0,45,0 crate"},
        {"rotate",
         "bodies",
         Kind::Edit,
         "Turns bodies, lights and joints about their common middle, or about a point.",
         {{"turn", Type::Point, "degrees about x, then y, then z", kRequired, -360, 360},
          {"about", Type::Point, "in metres", kOptional},
          kPlaced},
         rotate,
         "rotate 0,90,0 what=crate"},
        {"hold",
         "bodies",
         Kind::Edit,
         "Makes bodies stand still, or lets them move.",
         {{"static", Type::Flag, "whether they stand still", "yes"}, kBodies},
         hold,
         "hold yes crate"},
        {"body",
         "bodies",
         Kind::Edit,
         "Sets how gravity and air act on bodies.",
         {number("gravity", "multiple of the world's", -100, 100), number("damping", "1/s, of their velocity", 0, 1000),
          number("spin_damping", "1/s, of their spin", 0, 1000), kBodies},
         setBody,
         "body gravity=0.5 what=crate"},
    };
}

}  // namespace editor
