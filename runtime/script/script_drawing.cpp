// What scripts draw over the image of a frame.
#include <algorithm>

#include "runtime/script/script_host.h"

namespace rubble::script {
namespace {

constexpr double kCanvasHeight = 1080.0;

constexpr double kMargin = 16.0, kLine = 24.0;  ///< units of the canvas, of what the host itself writes

/// A line of text from the left upper corner on.
UiItem lineItem(double pixels, size_t line, const std::string& text) {
    UiItem item{sized<rubble_overlay_item>(), text.substr(0, text.find('\0')), "mono"};
    item.row.kind = RUBBLE_OVERLAY_TEXT;
    item.row.font_size = 20.0 * pixels;
    item.row.transform[0] = item.row.transform[3] = 1.0;
    item.row.transform[4] = kMargin * pixels, item.row.transform[5] = (kMargin + kLine * double(line)) * pixels;
    std::fill_n(item.row.color, 4, 1.0);
    item.row.outline = 2.0 * pixels, item.row.outline_color[3] = 0.7;
    return item;
}

}  // namespace

void ScriptHost::setView(const rubble_view& view) {
    UiFrame& frame = m_shared.ui;
    frame.view = view;
    frame.pixels = double(view.height) / kCanvasHeight;
    frame.height = kCanvasHeight;
    frame.width = double(view.width) / frame.pixels;
}

void ScriptHost::beginDrawing(const rubble_view& view) {
    UiFrame& frame = m_shared.ui;
    setView(view);
    frame.items.clear();
    frame.isOpen = true;
    for (Script& script : m_scripts) {
        if (!script.has(Callback::Draw)) continue;
        UiState start;
        start.transform = {frame.pixels, 0, 0, frame.pixels, 0, 0};
        start.width = frame.width, start.height = frame.height;
        script.context().ui.assign(1, start);
    }
}

void ScriptHost::addLinesAndWatches() {
    UiFrame& frame = m_shared.ui;
    for (const WorldLine& line : m_shared.lines) {
        UiItem item{sized<rubble_overlay_item>(), "", ""};
        item.row.kind = RUBBLE_OVERLAY_WORLD_LINE;
        item.row.flags = line.isOccluded ? uint32_t(RUBBLE_OVERLAY_OCCLUDED) : 0u;
        item.row.stroke = 2.0 * frame.pixels;
        std::copy_n(line.from.data(), 3, item.row.position);
        std::copy_n(line.to.data(), 3, item.row.end);
        for (size_t i = 0; i < 4; ++i) item.row.color[i] = std::clamp(line.color[i], 0.0, 1.0);
        frame.items.push_back(std::move(item));
    }
    size_t lines = 0;
    for (const auto& [name, value] : m_shared.watches)
        frame.items.push_back(lineItem(frame.pixels, lines++, name + ": " + value));
}

void ScriptHost::addProfile() {
    if (m_shared.showsProfile != m_profile.has_value()) {
        m_profile.reset();
        if (m_shared.showsProfile) m_profile.emplace();
        for (Script& script : m_scripts)
            if (!m_settings.measuresFunctions)
                script.context().costs.assign(m_profile ? script.context().calls.size() : 0, {});
    }
    if (!m_profile) return;
    m_profile->update(m_scripts);
    UiFrame& frame = m_shared.ui;
    const std::vector<std::string>& lines = m_profile->lines();
    const size_t first = m_shared.watches.size();
    size_t columns = 0;
    for (const std::string& line : lines) columns = std::max(columns, line.size());
    UiItem ground = lineItem(frame.pixels, first, "");
    ground.row.kind = RUBBLE_OVERLAY_BOX;
    ground.row.transform[4] -= 0.5 * kMargin * frame.pixels;
    ground.row.size[0] = (kMargin + 0.61 * 20.0 * double(columns)) * frame.pixels;  // widths of "mono", in em
    ground.row.size[1] = kLine * double(lines.size()) * frame.pixels;
    ground.row.color[0] = ground.row.color[1] = ground.row.color[2] = 0.0, ground.row.color[3] = 0.6;
    frame.items.push_back(std::move(ground));
    for (size_t i = 0; i < lines.size(); ++i) {
        UiItem item = lineItem(frame.pixels, first + i, lines[i]);
        const bool isScript = i > 0 && !lines[i].starts_with("  ");
        if (isScript) item.row.color[2] = 0.4;
        frame.items.push_back(std::move(item));
    }
}

rubble_result ScriptHost::show(rubble_renderer renderer) {
    const rubble_api& api = *m_shared.api;
    for (auto& [name, image] : m_shared.ui.images) {
        if (image.holders.contains(renderer)) continue;
        auto given = sized<rubble_overlay_image>();
        given.name = name.c_str(), given.pixels = image.pixels.data();
        given.width = image.width, given.height = image.height;
        if (const rubble_result result = api.set_overlay_image(renderer, &given); result != RUBBLE_OK) return result;
        image.holders.insert(renderer);
    }
    std::vector<rubble_overlay_item> rows;
    for (const UiItem& item : m_shared.ui.items) {
        rows.push_back(item.row);
        rows.back().text = item.text.c_str();
        rows.back().font = item.font.empty() ? nullptr : item.font.c_str();
    }
    return api.set_overlay(renderer, rows.data(), uint32_t(rows.size()));
}

rubble_result ScriptHost::draw(rubble_renderer renderer, const rubble_view& view, double dt) {
    const size_t lines = m_shared.lines.size();  // those of draw() are of this view alone
    beginDrawing(view);
    beginFrame();
    callAll(Callback::Draw, dt);
    m_shared.ui.isOpen = false;
    for (Script& script : m_scripts) script.context().ui.clear();  // what it has set is of this frame alone
    addLinesAndWatches();
    addProfile();
    m_shared.lines.resize(lines);
    if (!renderer) return RUBBLE_OK;
    const bool draws = !m_shared.ui.items.empty();
    const bool drew = draws ? !m_overlaid.insert(renderer).second : m_overlaid.erase(renderer) > 0;
    return draws || drew ? show(renderer) : RUBBLE_OK;
}

}  // namespace rubble::script
