#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>

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
    using Clock = std::chrono::steady_clock;
    const rubble_step_stats step = session.world().get_step_stats();
    const rubble_draw_stats draw = viewport.stats();
    m_samples[m_next] = {std::chrono::duration<double>(Clock::now().time_since_epoch()).count(),
                         {step.edits_ms, step.physics_ms, step.poses_ms, step.impacts_ms, step.shadow_ms,
                          step.publish_ms, draw.apply_ms, draw.draw_ms, uiMs},
                         step,
                         draw};
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
        most = std::max(most, std::accumulate(newest(s).ms, newest(s).ms + kRows, 0.0));
    }
    const double shown = most * 1.15;
    const float bar = size.x / float(kSamples);
    for (int s = 0; s < m_count; ++s) {
        const float right = low.x + size.x - float(s) * bar;
        double below = 0.0;
        for (int i = 0; i < kRows; ++i) {
            const double above = below + newest(s).ms[i];
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

/// The stages of a sample follow each other up to its end; a step that was sampled before is left out.
std::string ProfilerPanel::writeTrace(const std::string& path) const {
    std::string events = R"({"ph":"M","pid":1,"tid":1,"name":"thread_name","args":{"name":"step"}},
{"ph":"M","pid":1,"tid":2,"name":"thread_name","args":{"name":"frame"}})";
    const double origin = newest(m_count - 1).seconds;
    double end = 0.0;
    uint64_t stepBefore = ~uint64_t(0);
    for (int s = m_count - 1; s >= 0; --s) {
        const Sample& sample = newest(s);
        const int first = sample.step.step == stepBefore ? kStepRows : 0;
        stepBefore = sample.step.step;
        const double sum = std::accumulate(sample.ms + first, sample.ms + kRows, 0.0);
        double at = std::max((sample.seconds - origin) * 1e3 - sum, end);  // milliseconds
        events += fmt::format(
            ",\n"
            R"({{"ph":"C","pid":1,"name":"step","ts":{:.1f},"args":{{"bodies awake":{},"contacts":{}}}}})",
            at * 1e3, sample.step.bodies_awake, sample.step.contacts);
        for (int i = first; i < kRows; at += sample.ms[i++])
            events += fmt::format(
                ",\n"
                R"({{"ph":"X","pid":1,"tid":{},"name":"{}","ts":{:.1f},"dur":{:.1f}}})",
                i < kStepRows ? 1 : 2, kStages[i].name, at * 1e3, sample.ms[i] * 1e3);
        end = at;
    }
    std::ofstream file(path);
    file << "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" << events << "\n]}\n";
    return file.flush() ? "" : path + ": cannot be written";
}

void ProfilerPanel::draw(Session& session) const {
    const Sample& last = newest(0);
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
        const std::string ms = fmt::format("{:.2f} ms", last.ms[i]);
        list.AddText({at.x + 164 * uiScale() - ImGui::CalcTextSize(ms.c_str()).x, at.y}, theme::kDim, ms.c_str());
        ImGui::Dummy({164 * uiScale(), rowHeight});
        tooltip(kStages[i].tip);
    }
    ImGui::SetCursorScreenPos({origin.x, origin.y + 5.2f * rowHeight});
    ImGui::TextDisabled("%u of %u bodies awake, %u contacts", last.step.bodies_awake, last.step.bodies,
                        last.step.contacts);
    ImGui::TextDisabled("%u draw calls, %u bricks, %.0f MB", last.draw.draw_calls, last.draw.bricks,
                        double(last.draw.texture_bytes) / 1e6);
    if (ImGui::Button("Save trace...")) {
        session.wantsCommands = true;
        session.wantedCommand = "export";
        session.wantedValues = {{"file", "trace.json"}};
    }
    tooltip("Writes the samples as a trace that Perfetto opens");
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("graph");
    drawGraph();
    ImGui::EndChild();
}

}  // namespace editor
