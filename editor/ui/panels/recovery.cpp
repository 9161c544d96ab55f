#include <fmt/format.h>

#include <optional>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {

void drawRecovery(Session& session) {
    constexpr const char* kTitle = "Changes that were not saved";
    const std::optional<Recovery> found = session.editor().document().recovery();
    if (!found) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({480 * uiScale(), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * uiScale());
    const bool isOpen =
        ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    if (!isOpen) return;
    ImGui::PushFont(boldFont());
    ImGui::TextUnformatted(kTitle);
    ImGui::PopFont();
    ImGui::Spacing();
    const std::string level = found->level.path.empty() ? "a level without a file" : found->level.path;
    ImGui::TextWrapped("%s",
                       fmt::format("An editor of {} ended before it could save {} change{}.{}", level, found->changes,
                                   found->changes == 1 ? "" : "s",
                                   found->isTailLost ? " The journal is damaged, and what came later is lost." : "")
                           .c_str());
    ImGui::Spacing();
    const bool isRecovered = ImGui::Button("Recover");
    tooltip("The level as it was then, without its history");
    ImGui::SameLine();
    const bool isDiscarded = ImGui::Button("Discard");
    tooltip("The level as it was last saved");
    if (isRecovered || isDiscarded) {
        session.run(isRecovered ? "recover" : "discard");
        session.frameSelection();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace editor
