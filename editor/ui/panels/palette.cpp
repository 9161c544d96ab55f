#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

std::vector<rubble_palette_entry> entriesOf(Session& session, rubble_shape shape) {
    rubble_palette_range range{};
    range.shape = shape;
    range.first = 1;
    range.count = 255;
    return session.world().get_palette(range);
}

std::vector<std::string> materialNames(Session& session) {
    std::vector<std::string> names{"none"};
    for (uint32_t i = 1; i < session.world().get_material_count(); ++i)
        names.emplace_back(session.world().get_material(i).name);
    return names;
}

/// Whether somebody has set an entry: the last ones of a palette are seldom.
bool isSet(const rubble_palette_entry& entry, const rubble_palette_entry& last) {
    return !std::equal(entry.color, entry.color + 3, last.color) || entry.material != last.material ||
           entry.roughness != last.roughness || entry.emission != last.emission || entry.opacity != last.opacity;
}

void drawSwatch(Session& session, const rubble_palette_entry& entry, int index, const std::string& material) {
    const float side = 24 * uiScale();
    ImGui::PushID(index);
    if (ImGui::InvisibleButton("##swatch", {side, side})) session.brush.index = index;
    const bool isChosen = session.brush.index == index;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = IM_COL32(entry.color[0], entry.color[1], entry.color[2], 255);
    const float margin = isChosen ? 3 * uiScale() : 0.0f;
    list.AddRectFilled({low.x + margin, low.y + margin}, {high.x - margin, high.y - margin}, color, 3 * uiScale());
    if (entry.emission > 0.0)
        list.AddCircleFilled({high.x - 6 * uiScale(), low.y + 6 * uiScale()}, 2.5f * uiScale(), theme::kText);
    if (isChosen) list.AddRect(low, high, theme::kAccent, 4 * uiScale(), 0, 2 * uiScale());
    tooltip(fmt::format("entry {}: {}, #{:02x}{:02x}{:02x}{}", index, material, entry.color[0], entry.color[1],
                        entry.color[2], entry.emission > 0.0 ? ", glows" : "")
                .c_str());
    ImGui::PopID();
}

void drawEntry(Session& session, const rubble_palette_entry& entry, const std::vector<std::string>& materials,
               rubble_shape shape) {
    const auto set = [&](const char* name, const std::string& value) {
        session.run("entry", {{"index", std::to_string(session.brush.index)},
                              {name, value},
                              {"shape", referenceTo(session.world(), shape)}});
    };
    heading(fmt::format("Entry {}", session.brush.index).c_str());
    float color[3];
    for (int i = 0; i < 3; ++i) color[i] = float(entry.color[i]) / 255.0f;
    property("colour", "sRGB, as #rrggbb; a click on the square opens the picker");
    if (colorField("##color", color))
        set("color", fmt::format("#{:02x}{:02x}{:02x}", int(std::lround(color[0] * 255)),
                                 int(std::lround(color[1] * 255)), int(std::lround(color[2] * 255))));
    int material = entry.material;
    property("material", "What its voxels are made of: how they weigh, break, burn and slide");
    if (choiceField("##material", material, materials) && material) set("material", materials[size_t(material)]);
    const auto share = [&](const char* name, const char* tip, uint8_t byte) {
        double value = byte / 255.0;
        property(name, tip);
        if (numberField(fmt::format("##{}", name).c_str(), value, 0.005, "%.2f"))
            set(name, numberText(std::clamp(value, 0.0, 1.0)));
    };
    share("opacity", "1: opaque; below: transparent, as glass", entry.opacity);
    share("roughness", "0: a mirror", entry.roughness);
    share("metallic", "1: metal", entry.metallic);
    share("reflectivity", "Of what is no metal, seen from above", entry.reflectivity);
    double glow = entry.emission;
    property("glow", "Radiance, in multiples of the colour");
    if (numberField("##glow", glow, 0.05, "%.2f")) set("glow", numberText(std::max(glow, 0.0)));
}

}  // namespace

void drawPalette(Session& session) {
    const rubble_shape shape = session.selectedShape();
    if (!shape) {
        ImGui::TextDisabled("No shape is selected.");
        ImGui::TextWrapped("Its palette has up to 255 entries: colours with a material.");
        return;
    }
    const std::vector<rubble_palette_entry> entries = entriesOf(session, shape);
    const std::vector<std::string> materials = materialNames(session);
    const auto nameOfMaterial = [&](uint8_t index) { return index < materials.size() ? materials[index] : "none"; };
    static bool showsAll = false;
    ImGui::Checkbox("all 255", &showsAll);
    tooltip("Also entries that nobody has set");
    const std::string what = referenceTo(session.world(), shape);
    const auto button = [&](const char* label, const char* command) {
        ImGui::SameLine();
        const bool isPressed = ImGui::SmallButton(label);
        commandTooltip(command);
        return isPressed;
    };
    if (button("sort", "sort_entries")) session.run("sort_entries", {{"shape", what}});
    if (button("merge", "merge_entries")) session.run("merge_entries", {{"shape", what}});
    if (button("reduce...", "reduce_entries")) {
        session.wantsCommands = true;
        session.wantedCommand = "reduce_entries";
        session.wantedValues = {{"shape", what}};
    }
    const float spacing = 4 * uiScale();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(spacing, spacing));
    ImGui::BeginChild("swatches", {0, std::min(ImGui::GetContentRegionAvail().y * 0.42f, 200 * uiScale())});
    const float right = ImGui::GetContentRegionAvail().x;
    float x = 0;
    for (int i = 1; i <= int(entries.size()); ++i) {
        if (!showsAll && !isSet(entries[size_t(i - 1)], entries.back()) && i != session.brush.index) continue;
        const float side = 24 * uiScale();
        if (x > 0 && x + side <= right)
            ImGui::SameLine();
        else
            x = 0;
        x += side + spacing;
        drawSwatch(session, entries[size_t(i - 1)], i, nameOfMaterial(entries[size_t(i - 1)].material));
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    drawEntry(session, entries[size_t(session.brush.index - 1)], materials, shape);
}

}  // namespace editor
