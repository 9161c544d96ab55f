// Joints and ropes.
#include "editor/core/joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "editor/core/rotation.h"
#include "editor/core/round_shapes.h"

namespace editor {
namespace {

/// The shape that an end holds on to; 0: the world.
rubble_shape endOf(Editor& editor, const Arguments& arguments, std::string_view parameter) {
    if (arguments.text(parameter) == "world") return 0;
    return editor.object(arguments, parameter, {RUBBLE_KIND_SHAPE});
}

/// Turns a frame by no more than brings its x to the axis.
glm::dquat turnedToAxis(const Arguments& arguments, const glm::dquat& frame) {
    const glm::dvec3 axis = arguments.point("axis");
    if (glm::length(axis) == 0.0) arguments.refuse("axis", "a direction, found 0,0,0");
    return glm::dquat(frame * glm::dvec3(1.0, 0.0, 0.0), glm::normalize(axis)) * frame;
}

/// What a joint says in degrees, or of a slide in metres, as its settings have it.
double inUnits(uint32_t kind, double value) {
    return isLimitedInMetres(kind) ? value : glm::radians(value);
}

/// Reads the limits that are given; of a joint that has some, one may be left out.
void readLimits(const Arguments& arguments, rubble_joint_settings& joint) {
    const bool hasLow = arguments.has("low"), hasHigh = arguments.has("high");
    if (!hasLow && !hasHigh) return;
    const auto limit = [&](const char* name, double& value) {
        if (arguments.has(name)) value = inUnits(joint.kind, arguments.number(name));
    };
    if (hasLow != hasHigh && !(joint.flags & RUBBLE_JOINT_LIMITED))
        arguments.refuse(hasLow ? "high" : "low", "both limits, found one");
    limit("low", joint.lower_limit), limit("high", joint.upper_limit);
    const double unit = isLimitedInMetres(joint.kind) ? 1.0 : glm::degrees(1.0);
    if (joint.lower_limit > joint.upper_limit)
        arguments.refuse("high", fmt::format("low or more, which is {:g}, found {:g}", joint.lower_limit * unit,
                                             joint.upper_limit * unit));
    joint.flags |= RUBBLE_JOINT_LIMITED;
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
    put(joint.rotation, turnedToAxis(arguments, glm::dquat(1, 0, 0, 0)));
    joint.anchor_radius = arguments.number("search");
    readLimits(arguments, joint);
    if (arguments.has("speed")) {
        joint.motor = RUBBLE_MOTOR_SPEED;
        joint.motor_target = inUnits(joint.kind, arguments.number("speed"));
        joint.motor_max_force = arguments.number("force");
    }
    joint.spring_hertz = arguments.number("spring");
    joint.spring_damping_ratio = arguments.number("damping");
    joint.friction = arguments.number("friction");
    joint.break_force = arguments.number("breaks_at");
    make(editor, arguments, joint);
}

/// Reads what only wheels have.
void readWheel(const Arguments& arguments, rubble_joint_settings& joint) {
    const auto read = [&](const char* name, double unit, double& value) {
        if (!arguments.has(name)) return;
        if (joint.kind != RUBBLE_JOINT_WHEEL) arguments.refuse(name, "a wheel, found another joint");
        value = unit * arguments.number(name);
    };
    read("drive", 1.0, joint.drive_torque), read("brake", 1.0, joint.brake_torque);
    read("spin", glm::two_pi<double>(), joint.max_spin);
    read("steer", glm::radians(1.0), joint.max_steer_angle), read("steer_rate", glm::radians(1.0), joint.steer_rate);
}

/// The frame of a wheel by its axis.
glm::dquat readWheelFrame(const Arguments& arguments, glm::dvec3 up) {
    const glm::dvec3 axis = arguments.point("axis");
    const std::optional<glm::dquat> frame = wheelFrame(axis, up);
    if (!frame)
        arguments.refuse("axis", fmt::format("a direction across that of the suspension, found {:g},{:g},{:g}", axis.x,
                                             axis.y, axis.z));
    return *frame;
}

/// Lets a shape be touched as the cylinder about that of its axes which is nearest to a direction.
void makeRound(Editor& editor, rubble_shape shape, glm::dvec3 axis) {
    rubble::World& world = editor.world();
    const glm::dvec3 own = glm::abs(glm::inverse(quaternionOf(world.get_shape_state(shape).rotation)) * axis);
    const int along = own.x >= own.y && own.x >= own.z ? 0 : own.y >= own.z ? 1 : 2;
    rubble_collision_shape round{};
    round.shape = shape, round.kind = RUBBLE_COLLISION_CYLINDER_X + uint32_t(along);
    world.set_collision_shape(round);
    if (!isTouchedAs(world, shape, round.kind))
        editor.say(shownName(world, shape) +
                   " is not round about its axle: it rolls on its voxels, as with round=no, if at all");
}

void addWheel(Editor& editor, const Arguments& arguments) {
    rubble_joint_settings joint{};
    joint.kind = RUBBLE_JOINT_WHEEL;
    joint.shapes[0] = editor.object(arguments, "chassis", {RUBBLE_KIND_SHAPE});
    joint.shapes[1] = editor.object(arguments, "wheel", {RUBBLE_KIND_SHAPE});
    const rubble_shape_state wheel = editor.world().get_shape_state(joint.shapes[1]);
    const Cells solid = solidOf(editor.world(), joint.shapes[1]);
    const glm::dvec3 inGrid = glm::dvec3(2 * solid.low + solid.size) * (0.5 * wheel.voxel_size);
    const glm::dvec3 middle = vectorOf(wheel.position) + quaternionOf(wheel.rotation) * inGrid;
    put(joint.position, arguments.has("at") ? arguments.point("at") : middle);
    const glm::dquat frame = readWheelFrame(arguments, {0, 1, 0});
    put(joint.rotation, frame);
    joint.anchor_radius = arguments.number("search");
    readLimits(arguments, joint);
    readWheel(arguments, joint);
    joint.spring_hertz = arguments.number("spring");
    joint.spring_damping_ratio = arguments.number("damping");
    joint.friction = arguments.number("friction");
    joint.break_force = arguments.number("breaks_at");
    if (arguments.flag("round")) makeRound(editor, joint.shapes[1], frame * glm::dvec3(1, 0, 0));
    make(editor, arguments, joint);
}

bool hasWheels(const rubble::World& world, rubble_body body) {
    for (const rubble_shape shape : world.get_objects_of(body, RUBBLE_KIND_SHAPE))
        for (const rubble_joint joint : world.get_objects_of(shape, RUBBLE_KIND_JOINT))
            if (world.get_joint_properties(joint).kind == RUBBLE_JOINT_WHEEL) return true;
    return false;
}

void drive(Editor& editor, const Arguments& arguments) {
    std::vector<rubble_body> bodies = editor.objects(arguments, "what", {RUBBLE_KIND_BODY});
    const rubble_body first = bodies.front();
    std::erase_if(bodies, [&](rubble_body each) { return !hasWheels(editor.world(), each); });
    if (bodies.empty())
        arguments.refuse("what", fmt::format("bodies with wheels, found {} without", shownName(editor.world(), first)));
    for (const rubble_body each : bodies) {
        rubble_drive drive{};
        drive.body = each;
        drive.throttle = arguments.number("throttle");
        drive.steer = arguments.number("steer");
        drive.brake = arguments.number("brake");
        editor.world().drive_wheels(drive);
    }
}

void setJoint(Editor& editor, const Arguments& arguments) {
    rubble::World& world = editor.world();
    for (const rubble_joint each : editor.objects(arguments, "what", {RUBBLE_KIND_JOINT})) {
        if (!hasFrame(world, each))
            arguments.refuse("what", "joints other than ropes and steered wheels, found " + shownName(world, each));
        rubble_joint_settings joint = settingsOf(world, each);
        const glm::dquat frame = quaternionOf(joint.rotation);
        const bool isWheel = joint.kind == RUBBLE_JOINT_WHEEL;
        if (arguments.has("at")) put(joint.position, arguments.point("at"));
        if (arguments.has("axis"))
            put(joint.rotation,
                isWheel ? readWheelFrame(arguments, frame * glm::dvec3(0, 1, 0)) : turnedToAxis(arguments, frame));
        readWheel(arguments, joint);
        readLimits(arguments, joint);
        if (arguments.has("limited") && !arguments.flag("limited")) joint.flags &= ~uint32_t(RUBBLE_JOINT_LIMITED);
        const auto read = [&](const char* name, double& value) {
            if (arguments.has(name)) value = arguments.number(name);
        };
        read("spring", joint.spring_hertz), read("damping", joint.spring_damping_ratio);
        read("friction", joint.friction), read("breaks_at", joint.break_force), read("search", joint.anchor_radius);
        std::ranges::replace(editor.selection().objects, each, remakeJoint(world, each, joint));
    }
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
        motor.steer_angle = arguments.has("steer") ? glm::radians(arguments.number("steer")) : now.steer_angle;
        if (arguments.has("steer") && now.kind != RUBBLE_JOINT_WHEEL)
            arguments.refuse("steer", "a wheel, found another joint");
        editor.world().set_joint_motor(motor);
    }
}

constexpr std::string_view kDriveHelp = "of a wheel: N m at full throttle";
constexpr std::string_view kBrakeHelp = "of a wheel: N m at full brake";
constexpr std::string_view kSteerHelp = "of a wheel: degrees that it can be steered to each side";
constexpr std::string_view kSpinHelp = "of a wheel: turns a second at full throttle; backward half of it";
constexpr std::string_view kSteerRateHelp = "of a wheel: degrees a second of its steering";

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
        {"wheel",
         "joints",
         Kind::Edit,
         "Puts a wheel on a body that it carries and drives: with an axle, a suspension, a brake, and a steering.",
         {{"chassis", Type::Objects, "the shape that it carries", kRequired},
          {"wheel", Type::Objects, "the shape that rolls, of a body of its own", kRequired},
          {"at", Type::Point, "of its axle, in metres; else the middle of the wheel", kOptional},
          {"axis", Type::Point, "direction of its axle, to the left of who drives", "1,0,0"},
          number("steer", kSteerHelp, "0", 0, 85),
          number("drive", kDriveHelp, "500", 0, 1e9),
          number("brake", kBrakeHelp, "1000", 0, 1e9),
          number("low", "metres that it goes down; limit of its suspension", "-0.12", -10, 0),
          number("high", "metres that it goes up; limit of its suspension", "0.12", 0, 10),
          number("spring", "Hz of its suspension, of the wheel's mass against the body's; 0: none", "8", 0, 60),
          number("damping", "of the spring; 1: critical", "0.7", 0, 10),
          number("friction", "N m, a brake that is always on", "0", 0, 1e9),
          number("spin", kSpinHelp, "10", 0.1, 100),
          number("steer_rate", kSteerRateHelp, "120", 1, 1000),
          {"round", Type::Flag, "whether it rolls as a cylinder, not on the corners of its voxels", "yes"},
          breaks,
          number("search", "metres around its axle in which a voxel of each side is looked for", "0.6", 0.001, 10),
          name},
         addWheel,
         "wheel cart rear drive=200 name=rear_wheel"},
        {"drive",
         "joints",
         Kind::Tool,
         "Drives, steers and brakes all wheels of bodies, until it is told otherwise. Bodies without wheels stay.",
         {number("throttle", "from -1, backward, to 1", "1", -1, 1),
          number("steer", "from -1, to the right, to 1, to the left", "0", -1, 1),
          number("brake", "from 0 to 1", "0", 0, 1),
          {"what", Type::Objects, "the bodies, not their wheels", "selected"}},
         drive,
         "drive 0.5 1 what=cart"},
        {"set_joint",
         "joints",
         Kind::Edit,
         "Changes joints other than ropes: makes them again, from the pose that their shapes have now.",
         {{"at", Type::Point, "where, in metres", kOptional},
          {"axis", Type::Point, "direction about which they turn, or along which they slide; of a wheel to its left",
           kOptional},
          number("low", "limit from the present pose: degrees; metres of a slider or wheel", kOptional, -180, 180),
          number("high", "limit from the present pose: degrees; metres of a slider or wheel", kOptional, -180, 180),
          {"limited", Type::Flag, "no: without limits", kOptional},
          number("spring", "Hz at which they swing back; 0: no spring", kOptional, 0, 60),
          number("damping", "of the spring; 1: critical", kOptional, 0, 10),
          number("friction", "N m, or N", kOptional, 0, 1e9),
          number("breaks_at", "N; 0: they never break", kOptional, 0, 1e9),
          number("search", "metres around each end in which its voxel is looked for", kOptional, 0.001, 10),
          {"what", Type::Objects, "the joints", "selected"},
          number("drive", kDriveHelp, kOptional, 0, 1e9),
          number("brake", kBrakeHelp, kOptional, 0, 1e9),
          number("steer", kSteerHelp, kOptional, 0, 85),
          number("spin", kSpinHelp, kOptional, 0.1, 100),
          number("steer_rate", kSteerRateHelp, kOptional, 1, 1000)},
         setJoint,
         "set_joint 7.65,0.5,2 low=-30 high=60 what=door_hinge"},
        {"motor",
         "joints",
         Kind::Tool,
         "Sets the motors of joints; of ropes: their winches; of wheels: their spin. In play they turn at once.",
         {{"motor", Type::Choice, "what it holds", "speed", 0, 0, "off speed position"},
          number("target", "degrees or metres, a second for a speed", "90", -1e4, 1e4),
          number("force", "N m, or N", "1000", 0, 1e9),
          {"what", Type::Objects, "the joints", "selected"},
          number("steer", "of wheels: degrees to the left", kOptional, -170, 170)},
         setMotor,
         "motor speed 45 what=door_hinge"},
    };
}

}  // namespace editor
