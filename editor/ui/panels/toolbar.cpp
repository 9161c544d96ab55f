#include <fmt/format.h>

#include <algorithm>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

/// A line between groups of buttons.
void gap() {
    ImGui::SameLine(0, 8 * uiScale());
    const float height = ImGui::GetFrameHeight() + 4 * uiScale();
    ImGui::Dummy({1, height});
    const ImVec2 at = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 4 * uiScale()}, {at.x, at.y + height - 4 * uiScale()},
                                        IM_COL32(70, 73, 80, 255));
    ImGui::SameLine(0, 8 * uiScale());
}

void openForm(Session& session, const char* command) {
    session.wantsCommands = true;
    session.wantedCommand = command;
}

void drawFiles(Session& session) {
    if (iconButton("open", Icon::Open, false, "Open a level  (Ctrl+O)")) openForm(session, "open");
    ImGui::SameLine(0, 2);
    if (iconButton("save", Icon::Save, false, "Save the level  (Ctrl+S)")) {
        if (session.editor().document().path().empty())
            openForm(session, "save");
        else
            session.run("save", {});
    }
    gap();
    const Document& document = session.editor().document();
    if (iconButton("undo", Icon::Undo, false, "Undo  (Ctrl+Z)", !document.done().empty() && !document.isPlaying()))
        session.run("undo", {});
    ImGui::SameLine(0, 2);
    if (iconButton("redo", Icon::Redo, false, "Redo  (Ctrl+Y)", !document.undone().empty() && !document.isPlaying()))
        session.run("redo", {});
    gap();
}

void drawModes(Session& session) {
    struct Row {
        Mode mode;
        Icon icon;
        const char* tip;
    };
    static constexpr Row kRows[] = {
        {Mode::Select, Icon::Select, "Select bodies and shapes  (V)\nShift adds, Alt takes the shape of a body"},
        {Mode::Move, Icon::Move, "Move what is selected  (G)"},
        {Mode::Rotate, Icon::Rotate, "Turn what is selected  (R)"},
        {Mode::Scale, Icon::Scale, "Make the selected shape larger or smaller  (S)"},
        {Mode::Brush, Icon::Brush, "Draw voxels  (B)\nAlt picks the entry under the mouse"},
        {Mode::Break, Icon::Break, "Break things  (X)\nin play, or as a step of the history"},
    };
    for (const Row& row : kRows) {
        if (&row != kRows) ImGui::SameLine(0, 2);
        if (iconButton(row.tip, row.icon, session.mode == row.mode, row.tip)) session.mode = row.mode;
    }
    gap();
}

/// Fields of a row stand in its middle, as its buttons are higher.
void centerField() {
    ImGui::SetCursorPosY(ImGui::GetStyle().WindowPadding.y + 2 * uiScale());
}

void choice(const char* id, int& value, const char* const* names, int count, float width, const char* tip) {
    ImGui::SameLine(0, 5 * uiScale());
    centerField();
    ImGui::SetNextItemWidth(width * uiScale());
    ImGui::Combo(id, &value, names, count);
    tooltip(tip);
}

void drawBrush(Session& session) {
    static constexpr Icon kIcons[] = {Icon::Voxel, Icon::Box, Icon::Sphere, Icon::Line, Icon::Face, Icon::Flood};
    Brush& brush = session.brush;
    for (int i = 0; i < 6; ++i) {
        const Command* command = findCommand(kForms[i]);
        const std::string tip = command ? std::string(command->help) + fmt::format("  ({})", i + 1) : kForms[i];
        if (i) ImGui::SameLine(0, 2);
        if (iconButton(kForms[i], kIcons[i], int(brush.form) == i, tip.c_str())) brush.form = Form(i);
    }
    choice("##operation", brush.operation, kOperations, 4, 84, "What becomes of the cells  (T add, E erase, P paint)");
    ImGui::SameLine(0, 5 * uiScale());
    centerField();
    ImGui::SetNextItemWidth(64 * uiScale());
    ImGui::DragInt("##size", &brush.size, 0.1f, 1, 64, "size %d");
    tooltip("Cells: radius of balls and lines, depth of faces  ([ and ])");
    brush.size = std::clamp(brush.size, 1, 64);
    choice("##mirror", brush.mirror, kMirrors, 8, 62, "Draws the same again, mirrored about the middle of the grid");
}

void drawModeSettings(Session& session) {
    if (session.mode == Mode::Brush) return drawBrush(session);
    centerField();
    ImGui::AlignTextToFramePadding();
    if (session.mode == Mode::Break) {
        ImGui::Dummy({0, 0});
        choice("##breaker", session.breaker, kBreakers, 4, 92, "What a click does");
        ImGui::SameLine(0, 5 * uiScale());
        centerField();
        ImGui::SetNextItemWidth(92 * uiScale());
        numberField("##breaksize", session.breakSize, 0.02, "%.2f m");
        session.breakSize = std::clamp(session.breakSize, 0.05, 10.0);
        return tooltip("Radius");
    }
    if (session.mode == Mode::Scale) return ImGui::TextDisabled("whole cells");
    ImGui::TextDisabled("snap");
    ImGui::SameLine();
    centerField();
    ImGui::SetNextItemWidth(86 * uiScale());
    if (session.mode == Mode::Rotate) {
        numberField("##snap", session.snapAngle, 0.5, "%.1f\u00b0");
        return tooltip("Turns go by steps of this; 0: freely");
    }
    numberField("##snap", session.snap, 0.01, "%.3f m");
    tooltip("Moves go by steps of this; 0: freely");
}

/// Where the buttons of play begin, at the right end.
float playBegin() {
    const float side = ImGui::GetFrameHeight() + 4 * uiScale();
    return ImGui::GetWindowWidth() - 5 * side - 88 * uiScale();
}

void drawPlay(Session& session) {
    const bool isPlaying = session.editor().document().isPlaying();
    const bool runs = isPlaying && !session.isPaused;
    ImGui::SameLine(playBegin());
    ImGui::SetCursorPosY(ImGui::GetStyle().WindowPadding.y);
    if (iconButton("play", runs ? Icon::Pause : Icon::Play, runs, runs ? "Pause  (Space)" : "Play from here  (Space)"))
        session.togglePlay();
    ImGui::SameLine(0, 2);
    if (iconButton("step", Icon::Step, false, "Play one step of 1/60 s  (.)")) session.stepOnce();
    ImGui::SameLine(0, 2);
    if (iconButton("stop", Icon::Stop, false, "Stop: the level is as it was before  (Esc)", isPlaying))
        session.run("stop", {});
    ImGui::SameLine(0, 2);
    if (iconButton("keep", Icon::Keep, false, "Stop and keep what became of the level", isPlaying))
        session.run("keep", {});
    static constexpr const char* kNames[] = {"1/16", "1/4", "1/2", "1", "2"};
    static constexpr double kSpeeds[] = {0.0625, 0.25, 0.5, 1.0, 2.0};
    int speed = 3;
    for (int i = 0; i < 5; ++i)
        if (session.speed == kSpeeds[i]) speed = i;
    choice("##speed", speed, kNames, 5, 62, "Speed of play: slow motion below 1");
    session.speed = kSpeeds[speed];
    ImGui::SameLine(0, 4 * uiScale());
    ImGui::SetCursorPosY(ImGui::GetStyle().WindowPadding.y);
    if (iconButton("search", Icon::Search, false, "All commands  (Ctrl+P)")) session.wantsCommands = true;
}

}  // namespace

void drawToolbar(Session& session) {
    drawFiles(session);
    drawModes(session);
    // In a narrow window they end where the buttons of play begin.
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::PushClipRect(at, {at.x + playBegin() - 6 * uiScale(), at.y + size.y}, true);
    drawModeSettings(session);
    ImGui::PopClipRect();
    drawPlay(session);
}

void drawStatus(Session& session, const Viewport& viewport) {
    const Document& document = session.editor().document();
    const rubble_draw_stats& stats = viewport.stats();
    std::string right = fmt::format("{} bricks    {:.0f} ms a frame", stats.bricks, stats.apply_ms + stats.draw_ms);
    if (document.isPlaying())
        right = fmt::format("{} {:.2f} s    ", session.isPaused ? "paused" : "playing", document.playedSteps() / 60.0) +
                right;
    if (const size_t hidden = session.editor().view().hidden.size())
        right = fmt::format("{} shape{} hidden    ", hidden, hidden == 1 ? "" : "s") + right;
    const std::string path = document.path().empty() ? "a new level" : document.path();
    right = path.substr(path.find_last_of('/') + 1) + "    " + right;
    const float begin = ImGui::GetWindowWidth() - ImGui::CalcTextSize(right.c_str()).x - 12 * uiScale();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::PushClipRect(at, {at.x + begin - 12 * uiScale(), at.y + size.y}, true);
    ImGui::TextUnformatted(session.status.empty() ? "Right button: orbit    Shift+right: pan    wheel: zoom    F: frame"
                                                  : session.status.c_str());
    ImGui::PopClipRect();
    ImGui::SameLine(begin);
    ImGui::TextDisabled("%s", right.c_str());
}

}  // namespace editor
