#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "editor/core/joints.h"
#include "editor/core/models.h"
#include "editor/core/rotation.h"
#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

void drawName(Session& session, uint64_t handle) {
    std::string name = nameOf(session.world(), handle);
    property("name", "By which commands and scripts find it");
    if (textField("##name", name, "no name")) session.run("name", {{"name", name}, {"what", handleText(handle)}});
}

/// Degrees about x, then y, then z, as rotationOf() takes them.
glm::dvec3 degreesOf(glm::dquat q) {
    return glm::degrees(glm::eulerAngles(q)) + 0.0;
}

void drawPlace(Session& session, const rubble_body_state& body) {
    double position[3], turn[3];
    put(position, vectorOf(body.position));
    put(turn, degreesOf(quaternionOf(body.rotation)));
    const std::string what = referenceTo(session.world(), body.body);
    property("place", "Of the body's frame, in metres");
    const bool isMoved = pointField("##place", position, 0.02);
    property("turn", "Degrees about x, then y, then z");
    const bool isTurned = pointField("##turn", turn, 1.0, "%.1f");
    if (isMoved) session.run("place", {{"at", pointText(vectorOf(position))}, {"what", what}});
    if (isTurned)
        session.run("place",
                    {{"at", pointText(vectorOf(body.position))}, {"turn", pointText(vectorOf(turn))}, {"what", what}});
}

/// While the level is edited nothing moves, asleep or awake.
const char* stateOf(Session& session, const rubble_body_state& body) {
    if (body.flags & RUBBLE_BODY_STATIC) return "static";
    if (!session.editor().document().isPlaying()) return "free: moves in play";
    return body.flags & RUBBLE_BODY_ASLEEP ? "asleep" : "awake";
}

void drawBody(Session& session, rubble_body handle) {
    const rubble_body_state body = session.world().get_body_state(handle);
    const rubble_body_properties properties = session.world().get_body_properties(handle);
    const std::string what = referenceTo(session.world(), handle);
    heading("Body");
    drawName(session, handle);
    drawPlace(session, body);
    bool stands = body.flags & RUBBLE_BODY_STATIC;
    property("static", "Whether it stands still");
    if (ImGui::Checkbox("##static", &stands)) session.run("hold", {{"static", stands ? "yes" : "no"}, {"what", what}});
    double gravity = properties.gravity_scale, damping = properties.linear_damping;
    property("gravity", "Multiple of the world's");
    if (numberField("##gravity", gravity, 0.01))
        session.run("body", {{"gravity", numberText(gravity)}, {"what", what}});
    property("damping", "1/s, of its velocity");
    if (numberField("##damping", damping, 0.01))
        session.run("body", {{"damping", numberText(damping)}, {"what", what}});
    property("mass", "From its voxels and their materials");
    ImGui::Text("%.1f kg", properties.mass);
    property("state", "Whether physics moves it");
    ImGui::TextUnformatted(stateOf(session, body));
}

/// The file to which a shape is linked.
void drawModel(Session& session, rubble_shape handle, const std::string& what) {
    if (!isLinked(session.world(), handle)) return;
    property("model", "The file that it came from, and is linked to");
    ImGui::TextUnformatted(session.world().get_tag(handle, kModelTag).data());
    if (ImGui::Button("Reload")) session.run("reload_models", {{"what", what}});
    commandTooltip("reload_models");
    ImGui::SameLine();
    if (ImGui::Button("Revert")) session.run("reload_models", {{"what", what}, {"revert", "yes"}});
    commandTooltip("reload_models");
    ImGui::SameLine();
    if (ImGui::Button("Unlink")) session.run("unlink_models", {{"what", what}});
    commandTooltip("unlink_models");
}

void drawShape(Session& session, rubble_shape handle) {
    const rubble_shape_state shape = session.world().get_shape_state(handle);
    const rubble_shape_properties own = session.world().get_shape_properties(handle);
    const std::string what = referenceTo(session.world(), handle);
    heading("Shape");
    ImGui::PushID("shape");
    drawName(session, handle);
    drawModel(session, handle, what);
    property("grid", "Cells along each axis");
    ImGui::Text("%d x %d x %d", shape.size[0], shape.size[1], shape.size[2]);
    property("voxels", "That are not empty");
    ImGui::Text("%llu of %.0f mm", static_cast<unsigned long long>(shape.voxel_count), shape.voxel_size * 1000.0);
    const auto number = [&](const char* name, const char* tip, double value) {
        property(name, tip);
        if (numberField(fmt::format("##{}", name).c_str(), value, 0.01))
            session.run("shape", {{name, numberText(value)}, {"shape", what}});
    };
    number("strength", "Multiple of its materials' strengths under load", own.strength);
    number("density", "Multiple of its materials' densities", own.density);
    number("emission", "Multiple of what its entries emit", own.emission);
    bool bears = own.bears_load;
    property("bears load", "Whether weight and impacts may break it");
    if (ImGui::Checkbox("##bears", &bears))
        session.run("shape", {{"bears_load", bears ? "yes" : "no"}, {"shape", what}});
    property("anchors", "Boxes of cells that hold it to the world");
    ImGui::Text("%u", own.anchor_count);
    if (own.is_piece) ImGui::TextDisabled("a piece that came off another shape");
    ImGui::PopID();
}

void drawLight(Session& session, rubble_light handle) {
    const rubble_light_settings light = session.world().get_light_settings(handle);
    const std::string what = handleText(handle);
    heading("Light");
    drawName(session, handle);
    double at[3], color[3], reach = light.reach, radius = light.radius;
    put(at, vectorOf(light.position));
    put(color, vectorOf(light.color));
    property("place", "In metres; on a shape: from the corner of its grid");
    if (pointField("##at", at, 0.02)) session.run("set_light", {{"at", pointText(vectorOf(at))}, {"what", what}});
    property("colour", "Linear radiant intensity of red, green, blue");
    if (pointField("##color", color, 0.1))
        session.run("set_light", {{"color", pointText(vectorOf(color))}, {"what", what}});
    property("reach", "Metres beyond which it lights nothing");
    if (numberField("##reach", reach, 0.1)) session.run("set_light", {{"reach", numberText(reach)}, {"what", what}});
    property("radius", "Metres, of what glows: how soft its shadows are");
    if (numberField("##radius", radius, 0.01))
        session.run("set_light", {{"radius", numberText(radius)}, {"what", what}});
    bool isOn = light.flags & RUBBLE_LIGHT_ENABLED;
    property("on", "Whether it shines");
    if (ImGui::Checkbox("##on", &isOn)) session.run("set_light", {{"on", isOn ? "yes" : "no"}, {"what", what}});
}

/// Place, axis and limits of a joint, which the view has handles for.
void drawFrame(Session& session, rubble_joint handle) {
    const rubble_joint_settings joint = settingsOf(session.world(), handle);
    const std::string what = handleText(handle);
    double at[3], axis[3];
    put(at, vectorOf(joint.position));
    put(axis, quaternionOf(joint.rotation) * glm::dvec3(1, 0, 0));
    for (double& each : axis) each = std::round(each * 1e6) / 1e6 + 0.0;  // no -0
    property("place", "In metres");
    if (pointField("##at", at, 0.02)) session.run("set_joint", {{"at", pointText(vectorOf(at))}, {"what", what}});
    property("axis", "About which it turns, or along which it slides; of a wheel to its left");
    if (pointField("##axis", axis, 0.02))
        session.run("set_joint", {{"axis", pointText(vectorOf(axis))}, {"what", what}});
    if (joint.kind == RUBBLE_JOINT_FIXED) return;
    bool isLimited = joint.flags & RUBBLE_JOINT_LIMITED;
    const bool isMetres = isLimitedInMetres(joint.kind);
    const char* const first = isMetres ? "0.5" : "45";
    property("limited", "Whether its motion has limits");
    if (ImGui::Checkbox("##limited", &isLimited)) {
        if (isLimited)
            session.run("set_joint", {{"low", std::string("-") + first}, {"high", first}, {"what", what}});
        else
            session.run("set_joint", {{"limited", "no"}, {"what", what}});
    }
    if (!(joint.flags & RUBBLE_JOINT_LIMITED)) return;
    const double unit = isMetres ? 1.0 : glm::degrees(1.0);
    const auto limit = [&](const char* name, double value) {
        property(name, "From the present pose: degrees, or metres of a slider or a wheel's suspension");
        if (numberField(fmt::format("##{}", name).c_str(), value, isMetres ? 0.01 : 0.5))
            session.run("set_joint", {{name, numberText(value)}, {"what", what}});
    };
    if (isMetres || joint.kind == RUBBLE_JOINT_HINGE) limit("low", joint.lower_limit * unit);
    limit("high", joint.upper_limit * unit);
}

/// What drives, brakes and steers a wheel.
void drawWheel(Session& session, rubble_joint handle) {
    const rubble_joint_properties wheel = session.world().get_joint_properties(handle);
    const auto number = [&](const char* name, const char* tip, double value, double speed) {
        property(name, tip);
        if (numberField(fmt::format("##{}", name).c_str(), value, speed))
            session.run("set_joint", {{name, numberText(value)}, {"what", handleText(handle)}});
    };
    number("drive", "N m at full throttle", wheel.drive_torque, 5);
    number("brake", "N m at full brake", wheel.brake_torque, 5);
    number("steer", "Degrees to each side", glm::degrees(wheel.max_steer_angle), 0.5);
    number("spin", "Turns a second at full throttle", wheel.max_spin / glm::two_pi<double>(), 0.1);
}

void drawJoint(Session& session, rubble_joint handle) {
    static constexpr const char* kKinds[] = {"ball", "hinge", "slider", "cone", "fixed", "rope", "wheel"};
    const rubble_joint_state joint = session.world().get_joint_state(handle);
    heading("Joint");
    drawName(session, handle);
    property("kind", "What it leaves free");
    ImGui::TextUnformatted(joint.kind < std::size(kKinds) ? kKinds[joint.kind] : "");
    for (const rubble_shape side : joint.shapes) {
        property(side == joint.shapes[0] ? "first" : "second", "The shape that it holds; a click selects it");
        ImGui::PushID(side == joint.shapes[0] ? 0 : 1);
        const std::string name = side ? shownName(session.world(), side) : "the world";
        if (ImGui::Selectable(name.c_str()) && side) session.select(side, false);
        ImGui::PopID();
    }
    if (hasFrame(session.world(), handle)) drawFrame(session, handle);
    if (hasFrame(session.world(), handle) && joint.kind == RUBBLE_JOINT_WHEEL) drawWheel(session, handle);
    if (ImGui::Button("Motor...")) session.wantsCommands = true, session.wantedCommand = "motor";
    commandTooltip("motor");
}

void drawActions(Session& session, bool isBody) {
    const auto button = [&](const char* label, const char* command, bool asks) {
        if (ImGui::Button(label)) {
            if (asks)
                session.wantsCommands = true, session.wantedCommand = command;
            else
                session.run(command, {});
        }
        commandTooltip(command);
    };
    ImGui::Dummy({0, 4 * uiScale()});
    if (isBody) {
        button("Duplicate...", "duplicate", true);
        ImGui::SameLine();
        button("Hollow...", "hollow", true);
        ImGui::SameLine();
    }
    button("Delete", "delete", false);
}

}  // namespace

void drawProperties(Session& session) {
    const std::vector<uint64_t>& selected = session.editor().selection().objects;
    if (selected.empty()) {
        ImGui::TextDisabled("Nothing is selected.");
        ImGui::TextWrapped("Click an object in the view or in the tree; Ctrl+P finds every command.");
        return;
    }
    const uint64_t first = selected.front();
    if (selected.size() > 1) ImGui::TextDisabled("the first of %zu that are selected", selected.size());
    const int kind = kindOf(session.world(), first);
    const bool isBody = kind == RUBBLE_KIND_BODY || kind == RUBBLE_KIND_SHAPE;
    if (isBody) {
        drawBody(session, kind == RUBBLE_KIND_BODY ? first : session.world().get_shape_state(first).body);
        if (const rubble_shape shape = session.selectedShape()) drawShape(session, shape);
    } else if (kind == RUBBLE_KIND_LIGHT) {
        drawLight(session, first);
    } else if (kind == RUBBLE_KIND_JOINT) {
        drawJoint(session, first);
    } else if (kind >= 0) {
        heading(nameOfKind(uint32_t(kind)));
        drawName(session, first);
    }
    if (kind != RUBBLE_KIND_LIGHT_GROUP) drawActions(session, isBody);
}

}  // namespace editor
