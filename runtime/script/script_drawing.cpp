// What scripts draw over the image of a frame.
#include <algorithm>

#include "runtime/script/script_host.h"

namespace rubble::script {
namespace {

constexpr double kCanvasHeight = 1080.0;

rubble_overlay_item watchItem(double pixels, size_t line) {
    auto row = sized<rubble_overlay_item>();
    row.kind = RUBBLE_OVERLAY_TEXT;
    row.font = "mono", row.font_size = 20.0 * pixels;
    row.transform[0] = row.transform[3] = 1.0;
    row.transform[4] = 16.0 * pixels, row.transform[5] = (16.0 + 24.0 * double(line)) * pixels;
    std::fill_n(row.color, 4, 1.0);
    row.outline = 2.0 * pixels, row.outline_color[3] = 0.7;
    return row;
}

}  // namespace

void ScriptHost::beginDrawing(const rubble_view& view) {
    UiFrame& frame = m_shared.ui;
    frame.view = view;
    frame.pixels = double(view.height) / kCanvasHeight;
    frame.height = kCanvasHeight;
    frame.width = double(view.width) / frame.pixels;
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
        item.row.stroke = line.width * frame.pixels;
        std::copy_n(line.from.data(), 3, item.row.position);
        std::copy_n(line.to.data(), 3, item.row.end);
        for (size_t i = 0; i < 4; ++i) item.row.color[i] = std::clamp(line.color[i], 0.0, 1.0);
        frame.items.push_back(std::move(item));
    }
    size_t lines = 0;
    for (const auto& [name, value] : m_shared.watches) {
        const std::string text = name + ": " + value;
        frame.items.push_back({watchItem(frame.pixels, lines++), text.substr(0, text.find('\0')), "mono"});
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
    callAll(Callback::Draw, dt);
    m_shared.ui.isOpen = false;
    addLinesAndWatches();
    m_shared.lines.resize(lines);
    if (!renderer) return RUBBLE_OK;
    const bool draws = !m_shared.ui.items.empty();
    const bool drew = draws ? !m_overlaid.insert(renderer).second : m_overlaid.erase(renderer) > 0;
    return draws || drew ? show(renderer) : RUBBLE_OK;
}

}  // namespace rubble::script
