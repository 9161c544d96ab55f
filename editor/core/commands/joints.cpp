// Joints and ropes.
#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include "editor/core/editor.h"
#include "editor/core/rotation.h"

namespace editor {
namespace {

/// The shape that an end holds on to; 0: the world.
rubble_shape endOf(Editor& editor, const Arguments& arguments, std::string_view parameter) {
    if (arguments.text(parameter) == "world") return 0;
    return editor.object(arguments, parameter, {RUBBLE_KIND_SHAPE});
}

/// A rotation that brings x to an axis.
glm::dquat rotationToAxis(const Arguments& arguments) {
    const glm::dvec3 axis = arguments.point("axis");
    if (glm::length(axis) == 0.0) arguments.refuse("axis", "a direction, found 0,0,0");
    return glm::dquat(glm::dvec3(1.0, 0.0, 0.0), glm::normalize(axis));
}

void make(Editor& editor, const Arguments& arguments, const rubble_joint_settings& settings) {
    const rubble_joint made = editor.world().create_joint(settings);
    editor.giveName(arguments, made);
    editor.selection() = {{made}, {}};
}

void addJoint(Editor& editor, const Arguments& arguments) {
    static constexpr uint32_t kKinds[] = {RUBBLE_JOINT_HINGE, RUBBLE_JOINT_BALL, RUBBLE_JOINT_PRISMATIC,
                                          RUBBLE_JOINT_CONE, RUBBLE_JOINT_FIXED};
    rubble_joint_settings joint{};
    joint.kind = kKinds[arguments.choice("kind")];
    joint.shapes[0] = endOf(editor, arguments, "a");
    joint.shapes[1] = endOf(editor, arguments, "b");
    put(joint.position, arguments.point("at"));
    put(joint.rotation, rotationToAxis(arguments));
    joint.anchor_radius = arguments.number("search");
    const bool slides = joint.kind == RUBBLE_JOINT_PRISMATIC;
    const auto limit = [&](const char* name) {
        return slides ? arguments.number(name) : glm::radians(arguments.number(name));
    };
    if (arguments.has("low") != arguments.has("high"))
        arguments.refuse(arguments.has("low") ? "high" : "low", "both limits, found one");
    if (arguments.has("low") && arguments.number("low") > arguments.number("high"))
        arguments.refuse("high", fmt::format("low or more, which is {:g}, found {:g}", arguments.number("low"),
                                             arguments.number("high")));
    if (arguments.has("low")) {
        joint.flags |= RUBBLE_JOINT_LIMITED;
        joint.lower_limit = limit("low"), joint.upper_limit = limit("high");
    }
    if (arguments.has("speed")) {
        joint.motor = RUBBLE_MOTOR_SPEED;
        joint.motor_target = limit("speed");
        joint.motor_max_force = arguments.number("force");
    }
    joint.spring_hertz = arguments.number("spring");
    joint.spring_damping_ratio = arguments.number("damping");
    joint.friction = arguments.number("friction");
    joint.break_force = arguments.number("breaks_at");
    make(editor, arguments, joint);
}

void addRope(Editor& editor, const Arguments& arguments) {
    rubble_joint_settings rope{};
    rope.kind = RUBBLE_JOINT_ROPE;
    rope.shapes[0] = endOf(editor, arguments, "a");
    rope.shapes[1] = endOf(editor, arguments, "b");
    if (!rope.shapes[0] && !rope.shapes[1]) arguments.refuse("b", "a shape at one side at least, found world at both");
    put(rope.position, arguments.point("from"));
    put(rope.rope_end, arguments.point("to"));
    rope.anchor_radius = arguments.number("search");
    rope.rope_length = arguments.number("length");
    rope.rope_radius = arguments.number("radius");
    rope.rope_strength = arguments.number("breaks_at");
    make(editor, arguments, rope);
}

void setMotor(Editor& editor, const Arguments& arguments) {
    for (const rubble_joint each : editor.objects(arguments, "what", {RUBBLE_KIND_JOINT})) {
        const rubble_joint_properties now = editor.world().get_joint_properties(each);
        const bool slides = now.kind == RUBBLE_JOINT_PRISMATIC || now.kind == RUBBLE_JOINT_ROPE;
        rubble_joint_motor motor{};
        motor.joint = each;
        motor.motor = uint32_t(arguments.choice("motor"));
        motor.motor_target = slides ? arguments.number("target") : glm::radians(arguments.number("target"));
        motor.motor_max_force = arguments.number("force");
        motor.friction = now.friction;
        editor.world().set_joint_motor(motor);
    }
}

Parameter number(std::string_view name, std::string_view help, std::string_view otherwise, double low, double high) {
    return {name, Type::Number, help, otherwise, low, high};
}

}  // namespace

std::vector<Command> jointCommands() {
    const Parameter a{"a", Type::Objects, "the shape at its first side, or world", kRequired};
    const Parameter b{"b", Type::Objects, "the shape at its second side, or world", kRequired};
    const Parameter name{"name", Type::Text, "by which others find it", ""};
    const Parameter search =
        number("search", "metres around each end in which its voxel is looked for", "0.3", 0.001, 10);
    const Parameter breaks = number("breaks_at", "N; 0: it never breaks", "0", 0, 1e9);
    return {
        {"joint",
         "joints",
         Kind::Edit,
         "Joins two shapes, or a shape and the world.",
         {{"kind", Type::Choice, "what it leaves free", "hinge", 0, 0, "hinge ball slider cone fixed"},
          a,
          b,
          {"at", Type::Point, "where, in metres", kRequired},
          {"axis", Type::Point, "direction about which it turns, or along which it slides", "0,1,0"},
          number("low", "limit: degrees, or metres of a slider", kOptional, -180, 180),
          number("high", "limit: degrees, or metres of a slider", kOptional, -180, 180),
          number("speed", "of its motor: degrees or metres a second", kOptional, -1e4, 1e4),
          number("force", "of its motor: N m, or N", "1000", 0, 1e9),
          number("spring", "Hz at which it swings back; 0: no spring", "0", 0, 60),
          number("damping", "of the spring; 1: critical", "1", 0, 10),
          number("friction", "N m, or N", "0", 0, 1e9),
          breaks,
          search,
          name},
         addJoint,
         "joint hinge crate world 0.4,0.4,0 0,1,0 low=-90 high=90 name=pivot"},
        {"rope",
         "joints",
         Kind::Edit,
         "Hangs a rope between two shapes, or a shape and the world.",
         {a,
          b,
          {"from", Type::Point, "its first end, in metres", kRequired},
          {"to", Type::Point, "its second end, in metres", kRequired},
          number("length", "metres; 0: the distance of its ends", "0", 0, 1000),
          number("radius", "metres", "0.03", 0.001, 1),
          breaks,
          search,
          name},
         addRope,
         "rope crate world 0,0.8,0 0,3,0 length=3 name=line"},
        {"motor",
         "joints",
         Kind::Edit,
         "Sets the motors of joints; of ropes: their winches.",
         {{"motor", Type::Choice, "what it holds", "speed", 0, 0, "off speed position"},
          number("target", "degrees or metres, a second for a speed", "90", -1e4, 1e4),
          number("force", "N m, or N", "1000", 0, 1e9),
          {"what", Type::Objects, "the joints", "selected"}},
         setMotor,
         "motor speed 45 what=door_hinge"},
    };
}

}  // namespace editor
