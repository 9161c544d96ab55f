#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

Icon iconOf(uint32_t kind) {
    static constexpr Icon kIcons[] = {Icon::Body,  Icon::Shape,   Icon::Light, Icon::Group,
                                      Icon::Water, Icon::Trigger, Icon::Body,  Icon::Joint};
    return kind < std::size(kIcons) ? kIcons[kind] : Icon::Body;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

}  // namespace

void TreePanel::gather(Session& session) {
    m_rows.clear();
    rubble::World& all = session.world();
    const auto add = [&](uint64_t handle, uint32_t kind, int depth) {
        std::string name = nameOf(all, handle);
        if (name.empty()) name = nameOfKind(kind);
        m_rows.push_back({handle, kind, depth, std::move(name)});
    };
    for (const uint64_t body : all.get_objects(RUBBLE_KIND_BODY)) {
        add(body, RUBBLE_KIND_BODY, 0);
        for (const uint64_t shape : all.get_objects_of(body, RUBBLE_KIND_SHAPE)) add(shape, RUBBLE_KIND_SHAPE, 1);
    }
    for (const uint32_t kind :
         {RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP, RUBBLE_KIND_JOINT, RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER})
        for (const uint64_t each : all.get_objects(kind)) add(each, kind, 0);
}

void TreePanel::drawRow(Session& session, const Row& row) {
    const std::vector<uint64_t>& selected = session.editor().selection().objects;
    const bool isSelected = std::find(selected.begin(), selected.end(), row.handle) != selected.end();
    const float side = ImGui::GetTextLineHeight();
    ImGui::PushID(int(row.handle ^ row.handle >> 32));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float indent = float(row.depth) * 16 * uiScale();
    if (ImGui::Selectable("##row", isSelected))
        session.select(row.handle, ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) session.frameSelection();
    tooltip(fmt::format("{} {}\nA double click shows it", nameOfKind(row.kind), handleText(row.handle)).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawIcon(list, iconOf(row.kind), {at.x + indent + 2 * uiScale(), at.y}, side,
             isSelected ? theme::kAccent : theme::kDim);
    list.AddText({at.x + indent + side + 9 * uiScale(), at.y}, row.depth ? theme::kDim : theme::kText,
                 row.name.c_str());
    ImGui::PopID();
}

void TreePanel::draw(Session& session) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search by name", &m_search);
    tooltip("Shows objects whose name or kind has these letters");
    const bool isOld = session.version() != m_version;
    if (isOld && !(session.editor().document().isPlaying() && !session.isPaused && ImGui::GetFrameCount() % 15))
        gather(session), m_version = session.version(), m_searched = "\n";
    if (m_searched != m_search) {
        m_shown.clear();
        const std::string wanted = lower(m_search);
        for (const Row& row : m_rows)
            if (wanted.empty() || lower(row.name + " " + nameOfKind(row.kind)).find(wanted) != std::string::npos)
                m_shown.push_back(row);
        m_searched = m_search;
    }
    ImGui::TextDisabled("%zu of %zu objects", m_shown.size(), m_rows.size());
    ImGui::BeginChild("rows");
    ImGuiListClipper clipper;
    clipper.Begin(int(m_shown.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(session, m_shown[size_t(i)]);
    ImGui::EndChild();
}

}  // namespace editor
