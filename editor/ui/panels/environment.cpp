#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "editor/core/rotation.h"
#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

/// The hour at which the command `time` puts the sun where it is.
double hourOf(const rubble_environment& environment) {
    const double height = environment.sun_direction[1] / std::sin(glm::radians(55.0));
    const double angle = std::atan2(height, environment.sun_direction[0]);
    const double hour = 6.0 + angle / glm::radians(180.0) * 12.0;
    return hour < 0.0 ? hour + 24.0 : hour;
}

void drawTime(Session& session, const rubble_environment& environment) {
    static float hour = 12.0f;
    static bool isHeld = false;
    if (!isHeld) hour = float(hourOf(environment));
    ImGui::SetNextItemWidth(-1);
    const std::string shown = fmt::format("{:02d}:{:02d}", int(hour), int((hour - std::floor(hour)) * 60.0f));
    if (ImGui::SliderFloat("##hour", &hour, 0.0f, 24.0f, shown.c_str()))
        session.preview(Line{"time", {{"hour", numberText(double(hour))}}});
    isHeld = ImGui::IsItemActive();
    if (ImGui::IsItemDeactivated()) session.endPreview();
    commandTooltip("time");
}

}  // namespace

void drawEnvironment(Session& session) {
    const rubble_environment environment = session.world().get_environment();
    heading("Time of day");
    drawTime(session, environment);
    const auto number = [&](const char* label, const char* tip, const char* command, const char* parameter,
                            double value, double speed) {
        property(label, tip);
        if (numberField(fmt::format("##{}", label).c_str(), value, speed))
            session.run(command, {{parameter, numberText(value)}});
    };
    double clouds = environment.clouds;
    property("clouds", "0: clear, 1: overcast");
    if (numberField("##clouds", clouds, 0.01))
        session.run("time", {{"hour", numberText(hourOf(environment))}, {"clouds", numberText(clouds)}});
    number("exposure", "Factor on all light", "exposure", "factor", environment.exposure, 0.01);
    number("wetness", "0: dry, 1: with puddles", "wetness", "share", environment.wetness, 0.01);
    heading("Fog");
    double density = environment.fog_density, base = environment.fog_base, height = environment.fog_height;
    double haze = environment.fog_distance;
    property("density", "Extinction per metre; 0: none");
    bool isChanged = numberField("##density", density, 0.001, "%.4f");
    property("base", "Height at which it begins to thin out, in metres");
    isChanged = numberField("##base", base, 0.1) || isChanged;
    property("height", "Metres in which it thins to 1/e");
    isChanged = numberField("##height", height, 0.1) || isChanged;
    property("haze", "Metres at which haze hides half");
    isChanged = numberField("##haze", haze, 10.0, "%.0f") || isChanged;
    if (isChanged)
        session.run("fog", {{"density", numberText(density)},
                            {"base", numberText(base)},
                            {"height", numberText(height)},
                            {"haze", numberText(haze)}});
    heading("World");
    double gravity[3];
    put(gravity, vectorOf(environment.gravity));
    property("gravity", "m/s2");
    if (pointField("##gravity", gravity, 0.05)) session.run("gravity", {{"gravity", pointText(vectorOf(gravity))}});
    const rubble_settings settings = session.world().get_settings();
    bool breaks = settings.flags & RUBBLE_SETTING_STRESS;
    double strength = settings.strength_scale;
    property("stress", "Whether what stands breaks under its weight; no level holds it");
    if (ImGui::Checkbox("##stress", &breaks))
        session.run("stress", {{"on", breaks ? "yes" : "no"}, {"strength", numberText(strength)}});
    property("strength", "Multiple of all materials' strengths; no level holds it");
    if (numberField("##strength", strength, 0.01))
        session.run("stress", {{"on", breaks ? "yes" : "no"}, {"strength", numberText(strength)}});
}

void drawViewSettings(Session& session, const Viewport& viewport) {
    heading("Overlays");
    for (const OverlayName& each : kOverlays) {
        ImGui::Checkbox(each.label, &(session.editor().view().overlays.*each.shown));
        tooltip(each.tip);
    }
    heading("Image of the renderer");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##pass", session.pass.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const std::string& name : viewport.passes())
            if (ImGui::Selectable(name.c_str(), name == session.pass)) session.pass = name;
        ImGui::EndCombo();
    }
    tooltip("final: the finished frame; the others are its intermediate images");
    if (ImGui::Button("Save image...")) {
        session.wantsCommands = true;
        session.wantedCommand = "export";
        session.wantedValues = {{"file", "view.png"}};
    }
    tooltip("Writes what the view shows as PNG");
    ImGui::SameLine();
    if (ImGui::Button("Tour")) session.tour = 1;
    tooltip("Five steps through the window");
    heading("Camera");
    double pivot[3], fov = glm::degrees(session.camera.fov);
    put(pivot, session.camera.pivot);
    property("pivot", "Which the camera orbits");
    if (pointField("##pivot", pivot, 0.05)) session.camera.pivot = vectorOf(pivot);
    property("distance", "Metres from it");
    numberField("##distance", session.camera.distance, 0.05);
    session.camera.distance = std::max(session.camera.distance, 0.1);
    property("field", "Of view, degrees up and down");
    if (numberField("##fov", fov, 0.2, "%.1f")) session.camera.fov = glm::radians(std::clamp(fov, 5.0, 120.0));
}

}  // namespace editor
