// Where bodies are, and how they move.
#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

const Parameter kBodies{"what", Type::Objects, "the bodies", "selected"};

void setPose(Editor& editor, rubble_body body, glm::dvec3 position, const glm::dquat& rotation) {
    rubble_body_change change{};
    change.body = body;
    change.fields = RUBBLE_SET_POSE;
    put(change.position, position);
    put(change.rotation, glm::normalize(rotation));
    editor.world().set_body(change);
}

template <class F>
void forEachBody(Editor& editor, const Arguments& arguments, F&& f) {
    for (const rubble_body body : editor.objects(arguments, "what", {RUBBLE_KIND_BODY}))
        f(editor.world().get_body_state(body));
}

void move(Editor& editor, const Arguments& arguments) {
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        const glm::dvec3 to = vectorOf(body.position) + arguments.point("by");
        arguments.requireNear("by", to);
        setPose(editor, body.body, to, quaternionOf(body.rotation));
    });
}

void place(Editor& editor, const Arguments& arguments) {
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        setPose(editor, body.body, arguments.point("at"),
                arguments.has("turn") ? rotationOf(arguments.point("turn")) : quaternionOf(body.rotation));
    });
}

/// About the middle of all of them, or about a point.
void rotate(Editor& editor, const Arguments& arguments) {
    const std::vector<uint64_t> bodies = editor.objects(arguments, "what", {RUBBLE_KIND_BODY});
    glm::dvec3 middle(0.0);
    for (const rubble_body each : bodies) {
        const rubble_body_state state = editor.world().get_body_state(each);
        middle += vectorOf(state.position) / double(bodies.size());
    }
    if (arguments.has("about")) middle = arguments.point("about");
    const glm::dquat turn = rotationOf(arguments.point("turn"));
    forEachBody(editor, arguments, [&](const rubble_body_state& body) {
        const glm::dvec3 to = middle + turn * (vectorOf(body.position) - middle);
        arguments.requireNear("about", to);
        setPose(editor, body.body, to, turn * quaternionOf(body.rotation));
    });
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
        {"move", "bodies", Kind::Edit, "Moves bodies.", {by, kBodies}, move, "move 0,1,0 crate"},
        {"place",
         "bodies",
         Kind::Edit,
         "Puts bodies at a place.",
         {{"at", Type::Point, "of the body's frame, in metres", kRequired},
          {"turn", Type::Point, "degrees about x, then y, then z", kOptional, -360, 360},
          kBodies},
         place,
         "place 1,2,3 0,45,0 crate"},
        {"rotate",
         "bodies",
         Kind::Edit,
         "Turns bodies about their common middle, or about a point.",
         {{"turn", Type::Point, "degrees about x, then y, then z", kRequired, -360, 360},
          {"about", Type::Point, "in metres", kOptional},
          kBodies},
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
