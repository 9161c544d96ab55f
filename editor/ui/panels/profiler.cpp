#include <fmt/format.h>

#include <algorithm>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

struct Row {
    const char* name;
    const char* tip;
    ImU32 color;
};
constexpr Row kStages[ProfilerPanel::kRows] = {
    {"edits", "Edits, splits and fire of a step", IM_COL32(242, 163, 58, 255)},
    {"physics", "Contacts, solver, joints, sleep", IM_COL32(206, 131, 92, 255)},
    {"poses", "Poses back into the world", IM_COL32(164, 118, 110, 255)},
    {"impacts", "Damage by impacts", IM_COL32(130, 108, 120, 255)},
    {"shadow", "Handing changes to the shadow volume", IM_COL32(112, 120, 146, 255)},
    {"publish", "The snapshot for the renderer", IM_COL32(106, 138, 168, 255)},
    {"apply", "The renderer takes over what steps have changed", IM_COL32(110, 158, 178, 255)},
    {"draw", "The calls of a frame; a GPU may take longer", IM_COL32(138, 184, 188, 255)},
    {"interface", "Panels of this window", IM_COL32(170, 176, 186, 255)},
};

}  // namespace

void ProfilerPanel::sample(Session& session, const Viewport& viewport, double uiMs) {
    m_step = session.world().get_step_stats();
    m_draw = viewport.stats();
    const double all[kRows] = {m_step.edits_ms,   m_step.physics_ms, m_step.poses_ms,
                               m_step.impacts_ms, m_step.shadow_ms,  m_step.publish_ms,
                               m_draw.apply_ms,   m_draw.draw_ms,    uiMs};
    for (int i = 0; i < kRows; ++i) m_ms[i][m_next] = all[i];
    m_next = (m_next + 1) % kSamples;
    m_count = std::min(m_count + 1, kSamples);
}

/// Stacked bars, a sample each, the newest at the right.
void ProfilerPanel::drawGraph() const {
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, IM_COL32(24, 25, 29, 255), 4 * uiScale());
    double most = 4.0;
    for (int s = 0; s < m_count; ++s) {
        double sum = 0.0;
        for (int i = 0; i < kRows; ++i) sum += m_ms[i][s];
        most = std::max(most, sum);
    }
    const double shown = most * 1.15;
    const float bar = size.x / float(kSamples);
    for (int s = 0; s < m_count; ++s) {
        const int sample = (m_next - 1 - s + 2 * kSamples) % kSamples;
        const float right = low.x + size.x - float(s) * bar;
        double below = 0.0;
        for (int i = 0; i < kRows; ++i) {
            const double above = below + m_ms[i][sample];
            const auto y = [&](double ms) { return low.y + size.y * float(1.0 - ms / shown); };
            list.AddRectFilled({right - bar, y(above)}, {right, y(below)}, kStages[i].color);
            below = above;
        }
    }
    double step = 1.0;
    for (const double factor : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0})
        if (shown / step > 5.0) step *= factor;
    for (double ms = step; ms < shown; ms += step) {
        const float y = low.y + size.y * float(1.0 - ms / shown);
        list.AddLine({low.x, y}, {low.x + size.x, y}, IM_COL32(255, 255, 255, 26));
        list.AddText({low.x + 5 * uiScale(), y + 1}, theme::kDim, fmt::format("{:.0f} ms", ms).c_str());
    }
    ImGui::Dummy(size);
    tooltip("Each bar is a frame with the step before it; the newest is at the right");
}

void ProfilerPanel::draw(Session&) const {
    const int last = (m_next - 1 + kSamples) % kSamples;
    const float rowHeight = ImGui::GetTextLineHeight() + 1 * uiScale();
    ImGui::BeginChild("stages", {360 * uiScale(), 0}, false, ImGuiWindowFlags_NoScrollbar);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    for (int i = 0; i < kRows; ++i) {
        const ImVec2 at(origin.x + float(i % 2) * 178 * uiScale(), origin.y + float(i / 2) * rowHeight);
        ImGui::SetCursorScreenPos(at);
        const float side = ImGui::GetTextLineHeight() * 0.55f, drop = ImGui::GetTextLineHeight() * 0.25f;
        list.AddRectFilled({at.x, at.y + drop}, {at.x + side, at.y + drop + side}, kStages[i].color, 2);
        list.AddText({at.x + side + 6 * uiScale(), at.y}, theme::kText, kStages[i].name);
        const std::string ms = fmt::format("{:.2f} ms", m_count ? m_ms[i][last] : 0.0);
        list.AddText({at.x + 164 * uiScale() - ImGui::CalcTextSize(ms.c_str()).x, at.y}, theme::kDim, ms.c_str());
        ImGui::Dummy({164 * uiScale(), rowHeight});
        tooltip(kStages[i].tip);
    }
    ImGui::SetCursorScreenPos({origin.x, origin.y + 5.2f * rowHeight});
    ImGui::TextDisabled("%u of %u bodies awake, %u contacts", m_step.bodies_awake, m_step.bodies, m_step.contacts);
    ImGui::TextDisabled("%u draw calls, %u bricks, %.0f MB", m_draw.draw_calls, m_draw.bricks,
                        double(m_draw.texture_bytes) / 1e6);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("graph");
    drawGraph();
    ImGui::EndChild();
}

}  // namespace editor
