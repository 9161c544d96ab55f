#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/keys.h"
#include "editor/ui/state/text.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

/// How well a command answers to one word; 0: not at all.
int scoreOf(const Command& command, const std::string& word) {
    const std::string name = lower(command.name);
    if (name == word) return 100;
    if (name.starts_with(word)) return 60;
    if (name.find(word) != name.npos) return 40;
    if (lower(command.subject).find(word) != std::string::npos) return 20;
    return lower(command.help).find(word) != std::string::npos ? 10 : 0;
}

std::vector<std::string> split(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    return all;
}

/// A field for a parameter, which fits its type. The value is kept as it would be typed.
void drawField(const Parameter& parameter, std::string& value) {
    const bool isOptional = parameter.otherwise == kOptional;
    const std::string without = isOptional ? "left out" : std::string(parameter.otherwise);
    const std::string hint = parameter.otherwise == kRequired ? "required" : without.empty() ? "empty" : without;
    const std::string id = fmt::format("##{}", parameter.name);
    if (parameter.type == Type::Choice || parameter.type == Type::Flag) {
        const bool isFlag = parameter.type == Type::Flag;
        std::vector<std::string> names = split(isFlag ? "yes no" : parameter.choices);
        if (ImGui::BeginCombo(id.c_str(), value.empty() ? hint.c_str() : value.c_str())) {
            if (parameter.otherwise != kRequired && ImGui::Selectable(without.c_str(), value.empty())) value.clear();
            for (const std::string& name : names)
                if (name != without && ImGui::Selectable(name.c_str(), name == value)) value = name;
            ImGui::EndCombo();
        }
        return;
    }
    if (parameter.type == Type::Color) {
        unsigned rgb = 0x808080;
        const std::string& from = value.empty() ? without : value;
        if (from.size() == 7) sscanf(from.c_str(), "#%06x", &rgb);
        float color[3] = {float(rgb >> 16) / 255.0f, float(rgb >> 8 & 255) / 255.0f, float(rgb & 255) / 255.0f};
        if (ImGui::ColorEdit3((id + "picker").c_str(), color,
                              ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel))
            value = fmt::format("#{:02x}{:02x}{:02x}", int(color[0] * 255.0f + 0.5f), int(color[1] * 255.0f + 0.5f),
                                int(color[2] * 255.0f + 0.5f));
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1);
    }
    ImGui::InputTextWithHint(id.c_str(), hint.c_str(), &value);
}

bool isFile(const Parameter& parameter) {
    return parameter.type == Type::Text && !parameter.choices.empty();
}

std::string tipOf(const Parameter& parameter) {
    std::string tip(parameter.help);
    if (parameter.type == Type::Number || parameter.type == Type::Whole)
        tip += fmt::format("\nfrom {:g} to {:g}", parameter.low, parameter.high);
    if (parameter.type == Type::Point || parameter.type == Type::Cell) tip += "\nx,y,z";
    if (parameter.type == Type::Objects) tip += "\nnames, #HANDLE, tag:NAME, selected or all, with commas between";
    return tip;
}

/// Name, help, and at the right its keys or its subject.
void drawRow(const Command& command, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string key = keyOf(command.name);
    const std::string right = key.empty() ? std::string(command.subject) : key;
    const float end = at.x + ImGui::GetContentRegionAvail().x - 6 * uiScale();
    const float x = end - ImGui::CalcTextSize(right.c_str()).x, bottom = at.y + ImGui::GetTextLineHeightWithSpacing();
    list.AddText({at.x + 6 * uiScale(), at.y}, theme::kText, command.name.data(),
                 command.name.data() + command.name.size());
    list.PushClipRect(at, {x - 10 * uiScale(), bottom}, true);
    list.AddText({at.x + 142 * uiScale(), at.y}, theme::kDim, command.help.data(),
                 command.help.data() + command.help.size());
    list.PopClipRect();
    list.AddText({x, at.y}, key.empty() ? theme::kDim : theme::kAccent, right.c_str());
}

/// Darkens all behind the palette, and takes its clicks. True: the mouse is there.
bool drawShade(ImVec2 display) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(display);
    ImGui::SetNextWindowBgAlpha(0.5f);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kLine);
    ImGui::Begin("shade", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing);
    const bool isHovered = ImGui::IsWindowHovered();
    ImGui::End();
    ImGui::PopStyleColor();
    return isHovered;
}

}  // namespace

std::vector<const Command*> CommandPalette::find(const std::string& words) {
    std::vector<std::pair<int, const Command*>> scored;
    const std::vector<std::string> wanted = split(lower(words));
    for (const Command& command : allCommands()) {
        int total = 1;
        for (const std::string& word : wanted) {
            const int score = scoreOf(command, word);
            total = score && total ? total + score : 0;
        }
        if (total) scored.emplace_back(total, &command);
    }
    std::stable_sort(scored.begin(), scored.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<const Command*> found;
    for (const auto& each : scored) found.push_back(each.second);
    return found;
}

void CommandPalette::choose(const Command& command) {
    m_chosen = &command;
    m_values.assign(command.parameters.size(), "");
    m_error.clear();
    m_files = {};  // reads its folder again
    m_mustFocus = true;
}

void CommandPalette::drawList(Session& session) {
    ImGui::SetNextItemWidth(-1);
    if (m_mustFocus) ImGui::SetKeyboardFocusHere();
    m_mustFocus = false;
    const std::string before = search;
    const bool isEntered = ImGui::InputTextWithHint("##words", "a command, or words of what it does", &search,
                                                    ImGuiInputTextFlags_EnterReturnsTrue);
    if (before != search) m_marked = 0;
    const std::vector<const Command*> found = find(search);
    const int count = int(found.size());
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++m_marked;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) --m_marked;
    m_marked = std::clamp(m_marked, 0, std::max(count - 1, 0));
    const Command* chosen = isEntered && count ? found[size_t(m_marked)] : nullptr;
    ImGui::BeginChild("commands");
    for (int i = 0; i < count; ++i) {
        const Command& command = *found[size_t(i)];
        ImGui::PushID(i);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (ImGui::Selectable("##row", i == m_marked)) chosen = &command;
        if (i == m_marked && before != search) ImGui::SetScrollHereY();
        drawRow(command, at);
        tooltip(fmt::format("{}\ne.g. {}", command.help, command.example).c_str());
        ImGui::PopID();
    }
    if (!count) ImGui::TextDisabled("No command has these words.");
    ImGui::EndChild();
    if (!chosen) return;
    if (!chosen->parameters.empty()) return choose(*chosen);
    session.run(std::string(chosen->name));
    m_isOpen = false;
}

/// The files that a parameter may name, for the first one that names a file. True: one was clicked twice.
bool CommandPalette::drawFiles(Session& session) {
    for (size_t i = 0; i < m_values.size(); ++i) {
        const Parameter& parameter = m_chosen->parameters[i];
        if (!isFile(parameter)) continue;
        const float height = std::max(ImGui::GetContentRegionAvail().y, 8 * ImGui::GetTextLineHeightWithSpacing());
        ImGui::BeginChild("list of files", {0, height});
        const bool isChosen =
            m_files.draw(m_values[i], parameter.choices, folderOf(session.editor().document().path(), "./"));
        ImGui::EndChild();
        return isChosen;
    }
    return false;
}

void CommandPalette::drawForm(Session& session) {
    const Command& command = *m_chosen;
    ImGui::PushFont(boldFont());
    ImGui::TextUnformatted(std::string(command.name).c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("%s", std::string(command.help).c_str());
    ImGui::BeginChild("form", {0, -2.1f * ImGui::GetFrameHeightWithSpacing()});
    for (size_t i = 0; i < command.parameters.size(); ++i) {
        const Parameter& parameter = command.parameters[i];
        property(std::string(parameter.name).c_str(), tipOf(parameter).c_str());
        if (i == 0 && m_mustFocus) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(isFile(parameter) ? -1 : 210 * uiScale());
        drawField(parameter, m_values[i]);
        if (isFile(parameter)) continue;
        ImGui::SameLine(312 * uiScale());
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextDisabled("%s", std::string(parameter.help).c_str());
        ImGui::PopTextWrapPos();
    }
    m_mustFocus = false;
    const bool isFileChosen = drawFiles(session);
    ImGui::EndChild();
    if (m_error.empty())
        ImGui::TextDisabled("e.g. %s", std::string(command.example).c_str());
    else
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme::kError), "%s", m_error.c_str());
    const bool runs =
        ImGui::Button("Run") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) || isFileChosen;
    tooltip("Enter");
    ImGui::SameLine();
    if (ImGui::Button("Back")) m_chosen = nullptr, m_mustFocus = true;
    if (!runs) return;
    Line line{std::string(command.name), {}};
    for (size_t i = 0; i < m_values.size(); ++i)
        if (!m_values[i].empty()) line.given.push_back({std::string(command.parameters[i].name), m_values[i]});
    if (session.run(line))
        m_isOpen = false;
    else
        m_error = session.messages().back().text;
}

void CommandPalette::draw(Session& session) {
    if (session.wantsCommands) {
        m_isOpen = m_mustFocus = true;
        m_chosen = nullptr;
        m_marked = 0;
        search.clear();
        if (const Command* command = findCommand(session.wantedCommand)) choose(*command);
        for (size_t i = 0; m_chosen && i < m_values.size(); ++i)
            for (const Given& each : session.wantedValues)
                if (each.name == m_chosen->parameters[i].name) m_values[i] = each.value;
        session.wantsCommands = false;
        session.wantedValues.clear();
        session.wantedCommand.clear();
    }
    if (!m_isOpen) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(720 * uiScale(), display.x * 0.9f), std::min(430 * uiScale(), display.y * 0.8f));
    const bool isShadeHovered = drawShade(display);
    ImGui::SetNextWindowPos({(display.x - size.x) / 2, 70 * uiScale()});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * uiScale());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    if (m_mustFocus) ImGui::SetNextWindowFocus();  // not always: that would close the lists of its fields
    ImGui::Begin("commands", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    m_chosen ? drawForm(session) : drawList(session);
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    const bool isOutside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && isShadeHovered;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) || isOutside) m_isOpen = false;
}

}  // namespace editor
