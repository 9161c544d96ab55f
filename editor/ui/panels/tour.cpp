#include <fmt/format.h>

#include <algorithm>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

struct TourStep {
    const char *title, *text;
};

constexpr TourStep kSteps[kTourSteps] = {
    {"Look around",
     "Drag with the right button to orbit, with Shift as well to move sideways. The wheel zooms. F shows all, or what "
     "is selected."},
    {"Select and move",
     "V and a click select a body, in the view or in the tree at the left. G shows its handles: drag an arrow, or the "
     "white middle, which follows the surfaces under the mouse. End lowers it onto what is below."},
    {"Draw",
     "B takes a brush: the view shows what a click would draw in the shape under the mouse. T adds, E erases, P "
     "paints. "
     "The palette at the right has its colours and materials."},
    {"Break",
     "Space plays from here, and X breaks things where you click. A comma goes back half a second. Esc stops: the "
     "level "
     "is as it was before."},
    {"Find everything",
     "Ctrl+P finds each command by words, with a form of its parameters. Ctrl+Z takes any step back; the history below "
     "lists them. Ctrl+S saves."},
};

}  // namespace

void drawTour(Session& session, const ViewFrame& view) {
    if (session.tour < 1 || session.tour > kTourSteps) return;
    const TourStep& step = kSteps[session.tour - 1];
    const float s = uiScale();
    ImGui::SetNextWindowPos({view.origin.x + 14 * s, view.origin.y + view.size.y - 14 * s}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::min(380 * s, view.size.x - 28 * s), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14 * s, 12 * s));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * s);
    ImGui::Begin("tour", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar(2);
    ImGui::PushFont(boldFont());
    ImGui::TextUnformatted(step.title);
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("%d of %d", session.tour, kTourSteps);
    ImGui::Spacing();
    ImGui::TextWrapped("%s", step.text);
    ImGui::Spacing();
    const bool isLast = session.tour == kTourSteps;
    if (ImGui::Button(isLast ? "Done" : "Next")) session.tour = isLast ? 0 : session.tour + 1;
    if (session.tour > 1) {
        ImGui::SameLine();
        if (ImGui::Button("Back")) --session.tour;
    }
    if (!isLast) {
        ImGui::SameLine();
        if (ImGui::Button("Close")) session.tour = 0;
        tooltip("View at the right shows it again");
    }
    ImGui::End();
}

}  // namespace editor
