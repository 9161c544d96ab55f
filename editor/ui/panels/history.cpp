#include <algorithm>
#include <cstdlib>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {

void drawHistory(Session& session) {
    const Document& document = session.editor().document();
    const int done = int(document.done().size()), all = done + int(document.undone().size());
    int target = -1;
    ImGui::PushFont(monoFont());
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const int lines = std::max(int(ImGui::GetContentRegionAvail().y / line), 1);
    ImGui::BeginChild("steps", {0, float(lines) * line});
    if (ImGui::Selectable("   0  the level as it was opened", done == 0)) target = 0;
    tooltip("A click goes there: it undoes or redoes what lies between");
    ImGuiListClipper clipper;
    clipper.Begin(all);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const bool isDone = i < done;
            const std::string& name = isDone ? document.done()[size_t(i)] : document.undone()[size_t(all - 1 - i)];
            ImGui::PushID(i);
            if (!isDone) ImGui::PushStyleColor(ImGuiCol_Text, theme::kDim);
            char text[512];
            snprintf(text, sizeof text, "%4d  %s", i + 1, name.c_str());
            if (ImGui::Selectable(text, i + 1 == done)) target = i + 1;
            if (!isDone) ImGui::PopStyleColor();
            ImGui::PopID();
        }
    static int shown = -1;
    ImGui::Dummy({1, 0});  // so that the last row ends where a row ends
    if (shown != done) ImGui::SetScrollY(float(std::max(std::min(done + 2, all + 1) - lines, 0)) * line);
    shown = done;
    ImGui::EndChild();
    ImGui::PopFont();
    if (target < 0 || target == done) return;
    session.run(target < done ? "undo" : "redo", {{"times", std::to_string(std::abs(target - done))}});
}

void drawMessages(Session& session) {
    const float line = ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("lines", {0, -line});
    ImGui::PushFont(monoFont());
    for (const Message& message : session.messages()) {
        const bool isCall = message.kind == Message::Kind::Call;
        const ImU32 color = message.kind == Message::Kind::Error ? theme::kError : isCall ? theme::kDim : theme::kText;
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(((isCall ? "> " : "  ") + message.text).c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    static size_t shown = 0;
    if (shown != session.messages().size()) ImGui::SetScrollHereY(1.0f);
    shown = session.messages().size();
    ImGui::EndChild();
    static std::string typed;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##line", "a command, as: create 8,8,8 0,1,0", &typed,
                                 ImGuiInputTextFlags_EnterReturnsTrue)) {
        session.run(typed);
        typed.clear();
        ImGui::SetKeyboardFocusHere(-1);
    }
}

}  // namespace editor
