#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

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

/// Of a body, or a shape itself; none of other kinds.
std::vector<rubble_shape> shapesOf(const rubble::World& world, uint64_t object, uint32_t kind) {
    if (kind == RUBBLE_KIND_BODY) return world.get_objects_of(object, RUBBLE_KIND_SHAPE);
    return kind == RUBBLE_KIND_SHAPE ? std::vector<rubble_shape>{object} : std::vector<rubble_shape>();
}

}  // namespace

void TreePanel::addRow(Session& session, uint64_t handle, uint32_t kind, int depth) {
    std::string name = nameOf(session.world(), handle);
    if (name.empty()) name = nameOfKind(kind);
    const ViewState& view = session.editor().view();
    Eye eye = Eye::None;
    if (kind == RUBBLE_KIND_SHAPE) eye = view.hides(handle) ? Eye::Closed : Eye::Open;
    m_rows.push_back({handle, kind, depth, std::move(name), handleText(handle), eye});
}

/// The rows of a body, whose eye is closed if those of all its shapes are.
void TreePanel::addBody(Session& session, rubble_body body) {
    const size_t own = m_rows.size();
    addRow(session, body, RUBBLE_KIND_BODY, 0);
    for (const uint64_t shape : session.world().get_objects_of(body, RUBBLE_KIND_SHAPE))
        addRow(session, shape, RUBBLE_KIND_SHAPE, 1);
    for (size_t i = own + 1; i < m_rows.size(); ++i)
        if (m_rows[own].eye != Eye::Open) m_rows[own].eye = m_rows[i].eye;
}

/// One for each name of a layer. Its eye is closed if all that is in it is hidden.
void TreePanel::gatherLayers(Session& session) {
    rubble::World& all = session.world();
    std::map<std::string, Eye> layers;
    for (uint32_t kind = RUBBLE_KIND_BODY; kind <= RUBBLE_KIND_JOINT; ++kind)
        for (const uint64_t each : all.find_by_tag(kind, kLayerTag, nullptr)) {
            Eye& eye = layers.try_emplace(all.get_tag(each, kLayerTag).data(), Eye::None).first->second;
            for (const rubble_shape shape : shapesOf(all, each, kind))
                if (eye != Eye::Open) eye = session.editor().view().hides(shape) ? Eye::Closed : Eye::Open;
        }
    for (const auto& [name, eye] : layers)
        m_rows.push_back({0, 0, 0, name, fmt::format("tag:{}={}", kLayerTag, name), eye});
}

void TreePanel::gather(Session& session) {
    m_rows.clear();
    gatherLayers(session);
    rubble::World& all = session.world();
    for (const uint64_t body : all.get_objects(RUBBLE_KIND_BODY)) addBody(session, body);
    for (const uint32_t kind :
         {RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP, RUBBLE_KIND_JOINT, RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER})
        for (const uint64_t each : all.get_objects(kind)) addRow(session, each, kind, 0);
}

/// At the right end of the row that was drawn last.
void TreePanel::drawEye(Session& session, const Row& row) {
    if (row.eye == Eye::None) return;
    const bool isHidden = row.eye == Eye::Closed;
    const float side = ImGui::GetTextLineHeight();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - side);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("eye", {side, side})) session.run(isHidden ? "show" : "hide", {{"what", row.what}});
    const ImU32 color = ImGui::IsItemHovered() ? theme::kAccent : isHidden ? theme::kText : theme::kDim;
    drawIcon(*ImGui::GetWindowDrawList(), isHidden ? Icon::Hidden : Icon::Shown, at, side, color);
    tooltip(isHidden ? "Hidden: a click shows it in the view"
                     : "A click hides it in the view. Its shadow stays: below a hidden roof it is as dark as before");
}

void TreePanel::drawRow(Session& session, const Row& row) {
    const std::vector<uint64_t>& selected = session.editor().selection().objects;
    const bool isSelected = std::find(selected.begin(), selected.end(), row.handle) != selected.end();
    const float side = ImGui::GetTextLineHeight();
    ImGui::PushID(row.what.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float indent = float(row.depth) * 16 * uiScale();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    const bool isOnEye = row.eye != Eye::None && ImGui::GetMousePos().x >= right - side;
    const bool adds = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
    if (ImGui::Selectable("##row", isSelected, ImGuiSelectableFlags_AllowItemOverlap))
        session.run("select", {{"what", row.what}, {"more", adds ? "yes" : "no"}});
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) session.frameSelection();
    const std::string tip = fmt::format("{} {}\nA double click shows it", row.handle ? nameOfKind(row.kind) : "layer",
                                        row.handle ? handleText(row.handle) : row.name);
    tooltip(isOnEye ? "" : tip.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool isFaint = row.depth || row.eye == Eye::Closed;
    drawIcon(list, row.handle ? iconOf(row.kind) : Icon::Layer, {at.x + indent + 2 * uiScale(), at.y}, side,
             isSelected ? theme::kAccent : theme::kDim);
    list.PushClipRect(at, {right - (row.eye == Eye::None ? 0.0f : side), at.y + 2 * side}, true);
    list.AddText({at.x + indent + side + 9 * uiScale(), at.y}, isFaint ? theme::kDim : theme::kText, row.name.c_str());
    list.PopClipRect();
    drawEye(session, row);
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
            if (wanted.empty() ||
                lower(row.name + " " + (row.handle ? nameOfKind(row.kind) : "layer")).find(wanted) != std::string::npos)
                m_shown.push_back(row);
        m_searched = m_search;
    }
    ImGui::TextDisabled("%zu of %zu rows", m_shown.size(), m_rows.size());
    ImGui::BeginChild("rows");
    ImGuiListClipper clipper;
    clipper.Begin(int(m_shown.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(session, m_shown[size_t(i)]);
    ImGui::EndChild();
}

}  // namespace editor
