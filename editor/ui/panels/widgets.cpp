#include "editor/ui/panels/widgets.h"

#include <algorithm>
#include <array>

#include "editor/ui/state/theme.h"

namespace editor {
namespace {

/// The value of a field while it is being edited: what it is of is read again each frame.
template <class Value>
class Held {
public:
    void restore(const char* id, Value& value) {
        if (m_owner && m_owner == ImGui::GetID(id)) value = m_value;
    }
    /// True: the change is done.
    bool keep(const char* id, const Value& value) {
        const ImGuiID own = ImGui::GetID(id);
        if (ImGui::IsItemActive() || (m_owner == own && ImGui::IsItemEdited())) m_owner = own, m_value = value;
        const bool isDone = ImGui::IsItemDeactivatedAfterEdit();
        if (m_owner == own && !ImGui::IsItemActive()) m_owner = 0;
        return isDone;
    }

private:
    ImGuiID m_owner = 0;
    Value m_value{};
};

}  // namespace

bool iconButton(const char* id, Icon icon, bool isActive, const char* tip, bool isEnabled) {
    const float side = ImGui::GetFrameHeight() + 4.0f * uiScale();
    ImGui::BeginDisabled(!isEnabled);
    const bool isClicked = ImGui::InvisibleButton(id, {side, side});
    const bool isHovered = ImGui::IsItemHovered();
    const bool isHeld = ImGui::IsItemActive();
    ImGui::EndDisabled();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (isActive || isHovered)
        list.AddRectFilled(low, high, isActive ? theme::kAccentFaint : ImGui::GetColorU32(ImGuiCol_ButtonHovered),
                           5.0f * uiScale());
    if (isHeld) list.AddRectFilled(low, high, theme::kAccentFaint, 5.0f * uiScale());
    const float margin = side * 0.22f;
    const ImU32 color = isActive ? theme::kAccent : isEnabled ? theme::kText : IM_COL32(88, 92, 99, 255);
    drawIcon(list, icon, {low.x + margin, low.y + margin}, side - 2 * margin, color);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::BeginTooltip();
        ImGui::TextUnformatted(tip);
        ImGui::EndTooltip();
    }
    return isClicked && isEnabled;
}

void tooltip(const char* text) {
    if (!text || !*text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void commandTooltip(const char* command) {
    const Command* found = findCommand(command);
    if (found) tooltip((std::string(found->name) + ": " + std::string(found->help)).c_str());
}

void heading(const char* text) {
    ImGui::Dummy({0, 2.0f * uiScale()});
    ImGui::PushFont(boldFont());
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void property(const char* name, const char* tip) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name);
    tooltip(tip);
    ImGui::SameLine(92.0f * uiScale());
    ImGui::SetNextItemWidth(-1.0f);
}

bool numberField(const char* id, double& value, double speed, const char* format) {
    static Held<double> held;
    held.restore(id, value);
    ImGui::DragScalar(id, ImGuiDataType_Double, &value, float(speed), nullptr, nullptr, format);
    return held.keep(id, value);
}

bool pointField(const char* id, double (&value)[3], double speed, const char* format) {
    static Held<std::array<double, 3>> held;
    std::array<double, 3> all{value[0], value[1], value[2]};
    held.restore(id, all);
    ImGui::DragScalarN(id, ImGuiDataType_Double, all.data(), 3, float(speed), nullptr, nullptr, format);
    std::copy(all.begin(), all.end(), value);
    return held.keep(id, all);
}

bool textField(const char* id, std::string& value, const char* hint) {
    static Held<std::string> held;
    held.restore(id, value);
    ImGui::InputTextWithHint(id, hint, &value);
    return held.keep(id, value);
}

bool colorField(const char* id, float (&color)[3]) {
    static Held<std::array<float, 3>> held;
    std::array<float, 3> all{color[0], color[1], color[2]};
    held.restore(id, all);
    ImGui::ColorEdit3(id, all.data(), ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
    std::copy(all.begin(), all.end(), color);
    return held.keep(id, all);
}

bool choiceField(const char* id, int& value, const std::vector<std::string>& names) {
    bool isChanged = false;
    const char* shown = value >= 0 && size_t(value) < names.size() ? names[size_t(value)].c_str() : "";
    if (!ImGui::BeginCombo(id, shown)) return false;
    for (size_t i = 0; i < names.size(); ++i)
        if (ImGui::Selectable(names[i].c_str(), int(i) == value)) value = int(i), isChanged = true;
    ImGui::EndCombo();
    return isChanged;
}

}  // namespace editor
