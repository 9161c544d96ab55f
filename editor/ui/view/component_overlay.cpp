#include "editor/ui/view/component_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/ui/state/theme.h"
#include "editor/ui/view/picking.h"

namespace editor {
namespace {

constexpr float kCoarse = 8.0f, kFine = 3.0f;  ///< pixels of a plain display: while something changes, and then
constexpr float kMaxRays = 40000.0f;           ///< of a whole view
constexpr size_t kMaxBoxes = 200, kMaxLabels = 12;

ImU32 withAlpha(ImU32 color, uint32_t alpha) {
    return (color & 0x00ffffffu) | alpha << 24;
}

/// The part of the view that shows a box of cells.
std::pair<ImVec2, ImVec2> rectangleOf(const rubble_shape_state& shape, const ViewFrame& frame) {
    const ImVec2 first = frame.origin, last{frame.origin.x + frame.size.x, frame.origin.y + frame.size.y};
    ImVec2 low = last, high = first;
    for (int i = 0; i < 8; ++i) {
        const auto at = frame.project(
            worldOf(shape, {i & 1 ? shape.size[0] : 0u, i & 2 ? shape.size[1] : 0u, i & 4 ? shape.size[2] : 0u}));
        if (!at) return {first, last};
        low = {std::min(low.x, at->x), std::min(low.y, at->y)};
        high = {std::max(high.x, at->x), std::max(high.y, at->y)};
    }
    return {{std::max(low.x, first.x), std::max(low.y, first.y)}, {std::min(high.x, last.x), std::min(high.y, last.y)}};
}

}  // namespace

ImU32 ComponentOverlay::colorOf(const Component& component, size_t place) {
    const float share = std::fmod(float(place) * 0.618034f, 1.0f);  // of neighbours far apart
    const float hue = component.isAnchored() ? 0.34f + 0.42f * share : std::fmod(0.84f + 0.17f * share, 1.0f);
    ImVec4 color{0, 0, 0, 1};
    ImGui::ColorConvertHSVtoRGB(hue, 0.75f, 0.95f, color.x, color.y, color.z);
    return ImGui::ColorConvertFloat4ToU32(color);
}

ImU32 ComponentOverlay::tintOf(const rubble_hit& hit, rubble_shape shape) const {
    if (!hit.hit || hit.shape != shape) return 0;
    const glm::ivec3 cell(hit.cell[0], hit.cell[1], hit.cell[2]);
    const int place = m_components.at(cell);
    if (place < 0) return 0;
    if (m_components.isAnchored(cell)) return withAlpha(theme::kAccent, 200);
    return withAlpha(colorOf(m_components.all()[size_t(place)], size_t(place)), 130);
}

/// By a ray for each tile: what hides the shape hides its colours too.
void ComponentOverlay::findTiles(Session& session, const rubble_shape_state& shape, const ViewFrame& frame) {
    m_tiles.clear();
    const auto [low, high] = rectangleOf(shape, frame);
    const ImVec2 size(high.x - low.x, high.y - low.y);
    if (size.x <= 0.0f || size.y <= 0.0f) return;
    const float side = std::max(m_pixels, std::sqrt(size.x * size.y / kMaxRays));
    const int columns = int(std::ceil(size.x / side)), rows = int(std::ceil(size.y / side));
    const auto cornerOf = [&, from = low](int x, int y) {
        return ImVec2(from.x + float(x) * side, from.y + float(y) * side);
    };
    std::vector<rubble_ray> rays;
    rays.reserve(size_t(columns) * size_t(rows));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const ImVec2 corner = cornerOf(x, y);
            rays.push_back(rayAt(frame, {corner.x + side / 2, corner.y + side / 2}));
        }
    const std::vector<rubble_hit> hits = session.world().cast_rays(rays.data(), uint32_t(rays.size()), seenBy(session));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns;) {
            const auto tintAt = [&](int column) {
                return tintOf(hits[size_t(y) * size_t(columns) + size_t(column)], shape.shape);
            };
            const ImU32 color = tintAt(x);
            int end = x + 1;
            while (end < columns && tintAt(end) == color) ++end;
            if (color) m_tiles.push_back({cornerOf(x, y), cornerOf(end, y + 1), color});
            x = end;
        }
}

void ComponentOverlay::draw(Session& session, Wires& wires) {
    const rubble_shape shape = session.selectedShape();
    if (!shape) return;
    const bool isOther = shape != m_shape || session.version() != m_version;
    if (isOther) m_components = Components(session.world(), shape);
    m_shape = shape, m_version = session.version();
    const rubble_shape_state state = session.world().get_shape_state(shape);
    const ViewFrame& frame = wires.frame();
    const bool isChanging = isOther || frame != m_frame;
    const float wanted = (isChanging ? kCoarse : kFine) * uiScale();
    if (isChanging || wanted < m_pixels) {
        m_pixels = wanted;
        findTiles(session, state, frame);
    }
    m_frame = frame;
    for (const Tile& each : m_tiles) wires.tile(each.low, each.high, each.color);
    const std::vector<Component>& all = m_components.all();
    for (size_t i = 0; i < std::min(all.size(), kMaxBoxes); ++i) {
        wires.cells(state, all[i].low, all[i].size, colorOf(all[i], i), 0, 2.0f);
        if (i < kMaxLabels)
            wires.label(
                worldOf(state, glm::dvec3(all[i].low) + glm::dvec3(all[i].size) * 0.5), theme::kText,
                fmt::format("{} voxels, {}", all[i].voxels, all[i].isAnchored() ? "anchored" : "loose").c_str());
    }
}

}  // namespace editor
