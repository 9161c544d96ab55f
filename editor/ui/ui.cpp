#include "editor/ui/ui.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "editor/core/rotation.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/keys.h"
#include "editor/ui/state/theme.h"
#include "editor/ui/view/ghost.h"

namespace editor {
namespace {

constexpr float kToolbar = 44, kStatus = 26, kLeft = 232, kRight = 296, kBottom = 168;  ///< of a plain display
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

template <class Draw>
void panel(const char* name, ImVec2 low, ImVec2 high, Draw&& draw) {
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize({high.x - low.x, high.y - low.y});
    ImGui::Begin(name, nullptr, kFixed);
    draw();
    ImGui::End();
}

/// A tab that comes to the front when it is asked for. True: it is in front.
bool tab(const char* name, std::string& front, bool isAsked) {
    const bool isShown =
        ImGui::BeginTabItem(name, nullptr, isAsked && front == name ? ImGuiTabItemFlags_SetSelected : 0);
    if (isShown && !isAsked) front = name;
    return isShown;
}

void drawSelection(Session& session, Wires& wires) {
    const std::vector<uint64_t>& selected = session.editor().selection().objects;
    for (const rubble_shape_state& shape : selectedShapes(session)) {
        const bool isItself = std::find(selected.begin(), selected.end(), shape.shape) != selected.end();
        wires.cells(shape, glm::dvec3(0.0), {shape.size[0], shape.size[1], shape.size[2]},
                    isItself ? theme::kAccent : (theme::kAccent & 0x00ffffffu) | 0xa0000000u, 0,
                    isItself ? 2.0f : 1.5f);
    }
    const CellSet& cells = session.editor().selection().cells;
    if (cells.shape && kindOf(session.world(), cells.shape) == RUBBLE_KIND_SHAPE)
        wires.cells(session.world().get_shape_state(cells.shape), cells.low, cells.size, theme::kText,
                    IM_COL32(255, 255, 255, 24));
}

}  // namespace

void Ui::frame(double share) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float s = uiScale(), top = kToolbar * s, bottom = size.y - kStatus * s;
    const float left = kLeft * s, right = size.x - kRight * s, below = bottom - kBottom * s;
    const float line = 1.0f;
    handleKeys(m_session, ImGui::GetIO().WantTextInput || m_commands.isOpen());
    m_frame.origin = {left + line, top + line};
    m_frame.size = {std::max(right - left - 2 * line, 32.0f), std::max(below - top - 2 * line, 32.0f)};
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, theme::kLine);
    drawView(share);
    panel("toolbar", {0, 0}, {size.x, top}, [&] { drawToolbar(m_session); });
    panel("tree", {0, top + line}, {left, below}, [&] { m_tree.draw(m_session); });
    panel("right", {right, top + line}, {size.x, below}, [&] { drawRight(); });
    panel("bottom", {0, below + line}, {size.x, bottom}, [&] { drawBottom(); });
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * s, 4 * s));
    panel("status", {0, bottom + line}, size, [&] { drawStatus(m_session, m_viewport); });
    ImGui::PopStyleVar();
    m_session.tabs.isAsked = false;
    drawTour(m_session, m_frame);
    m_commands.draw(m_session);
    drawRecovery(m_session);
}

void Ui::drawRight() {
    if (!ImGui::BeginTabBar("tabs")) return;
    Tabs& tabs = m_session.tabs;
    const auto page = [&](const char* name, auto&& draw) {
        if (!tab(name, tabs.right, tabs.isAsked)) return;
        ImGui::BeginChild("page");
        draw();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    page("Properties", [&] { drawProperties(m_session); });
    page("Palette", [&] { drawPalette(m_session); });
    page("Sky", [&] { drawEnvironment(m_session); });
    page("View", [&] { drawViewSettings(m_session, m_viewport); });
    ImGui::EndTabBar();
}

void Ui::drawBottom() {
    if (!ImGui::BeginTabBar("tabs")) return;
    Tabs& tabs = m_session.tabs;
    const auto page = [&](const char* name, auto&& draw) {
        if (!tab(name, tabs.bottom, tabs.isAsked)) return;
        draw();
        ImGui::EndTabItem();
    };
    page("History", [&] { drawHistory(m_session); });
    page("Messages", [&] { drawMessages(m_session); });
    page("Profiler", [&] { m_profiler.draw(m_session); });
    page("Replay", [&] { drawReplay(m_session); });
    ImGui::EndTabBar();
}

void Ui::moveCamera(bool isHovered) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool isDown = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    const bool isClicked =
        ImGui::IsMouseClicked(ImGuiMouseButton_Right) || ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
    if (isHovered && isClicked) m_isCameraHeld = true;
    if (!isDown) m_isCameraHeld = false;
    Camera& camera = m_session.camera;
    if (isHovered && io.MouseWheel != 0.0f) camera.zoom(double(io.MouseWheel));
    if (!m_isCameraHeld) return;
    const double dx = double(io.MouseDelta.x / m_frame.size.y), dy = double(io.MouseDelta.y / m_frame.size.y);
    io.KeyShift ? camera.pan(dx, dy) : camera.orbit(dx, -dy);
    glm::dvec3 fly(0.0);
    const auto key = [](int plus, int minus) {
        return double(ImGui::IsKeyDown(plus)) - double(ImGui::IsKeyDown(minus));
    };
    fly.x = key(GLFW_KEY_D, GLFW_KEY_A), fly.y = key(GLFW_KEY_E, GLFW_KEY_Q), fly.z = key(GLFW_KEY_W, GLFW_KEY_S);
    if (fly != glm::dvec3(0.0)) camera.fly(fly * (double(io.DeltaTime) * std::max(camera.distance, 2.0)));
}

void Ui::describe(const std::optional<Hover>& hover) {
    m_session.status.clear();
    if (!hover) return;
    std::string name = nameOf(m_session.world(), hover->hit.shape);
    if (name.empty()) name = nameOf(m_session.world(), hover->hit.body);
    if (name.empty()) name = handleText(hover->hit.shape);
    m_session.status = fmt::format("{}    cell {}    entry {}    {:.2f} m", name, cellText(hover->cell),
                                   hover->hit.palette_index, hover->hit.distance);
}

void Ui::click(const Hover& hover) {
    const ImGuiIO& io = ImGui::GetIO();
    if (m_session.mode != Mode::Break)
        return m_session.select(io.KeyAlt ? hover.hit.shape : hover.hit.body, io.KeyShift || io.KeyCtrl);
    const std::string at = pointText(vectorOf(hover.hit.position));
    const char* const radius = m_session.breaker == 0 ? "size" : "radius";
    m_session.run(kBreakers[m_session.breaker], {{"at", at}, {radius, numberText(m_session.breakSize)}});
}

void Ui::useBrush(Wires& wires, const std::optional<Hover>& hover, bool isFree) {
    const Brush& brush = m_session.brush;
    const bool isPicking = ImGui::GetIO().KeyAlt;
    if (hover && isFree && isPicking && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        m_session.brush.index = int(hover->hit.palette_index);
        return;
    }
    const bool isEditing = !m_session.editor().document().isPlaying();
    if (!isEditing) return m_stroke.reset();
    if (!m_stroke && hover && isFree) {
        const Stroke stroke = beginStroke(brush, *hover);
        drawGhost(wires, m_session.world(), brush, stroke);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) m_stroke = stroke;
    }
    if (!m_stroke) return;
    if (kindOf(m_session.world(), m_stroke->shape) != RUBBLE_KIND_SHAPE) return m_stroke.reset();
    const bool isDragged =
        brush.form != Form::Face && brush.form != Form::Flood && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 4.0f);
    if (isDragged) followMouse(*m_stroke, m_session.world(), m_frame, ImGui::GetIO().MousePos);
    drawGhost(wires, m_session.world(), brush, *m_stroke);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    m_session.run(lineOf(m_session.world(), brush, *m_stroke));
    m_stroke.reset();
}

void Ui::useMouse(Wires& wires, bool isFree) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Mode mode = m_session.mode;
    const bool hasGizmo = mode == Mode::Move || mode == Mode::Rotate || mode == Mode::Scale;
    const bool isOnJoint = m_jointHandles.update(m_session, m_frame, list, isFree && !m_gizmo.isDragging());
    const bool isOnGizmo = hasGizmo && m_gizmo.update(m_session, m_frame, list, isFree && !isOnJoint);
    const bool isPointing = (isFree || m_stroke) && !isOnGizmo && !isOnJoint && !m_isCameraHeld;
    const std::optional<Hover> hover = isPointing ? pick(m_session, m_frame, ImGui::GetIO().MousePos) : std::nullopt;
    describe(hover);
    if (m_session.mode == Mode::Brush) return useBrush(wires, hover, isFree && !m_isCameraHeld);
    m_stroke.reset();
    if (m_session.mode == Mode::Break && hover) {
        const double radius = m_session.breakSize;
        const glm::dvec3 at = vectorOf(hover->hit.position);
        wires.ring(at, {radius, 0, 0}, {0, 0, radius}, theme::kAccent);
        wires.ring(at, {radius, 0, 0}, {0, radius, 0}, theme::kAccent);
        wires.ring(at, {0, radius, 0}, {0, 0, radius}, theme::kAccent);
    }
    if (isPointing && hover && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) click(*hover);
}

void Ui::drawImage(double share) {
    const bool isReplay = m_session.showsReplay && m_session.replay.world();
    if (isReplay && !m_replay && makeViewport) m_replay = makeViewport(*m_session.replay.world());
    if (share > 0.0) drawLevel(shownViewport(), share);
    ImGui::Image(shownViewport().texture(), m_frame.size, {0, 1}, {1, 0});
}

std::string Ui::writeView(const std::string& path) {
    Viewport& shown = shownViewport();
    do drawLevel(shown, 1.0);
    while (!shown.isSettled());
    return shown.write(path);
}

void Ui::drawLevel(Viewport& shown, double share) {
    const bool isReplay = &shown != &m_viewport;
    const uint64_t version = m_session.version() + (isReplay ? m_session.replay.version() : 0);
    shown.draw(m_frame, version, m_session.pass, share, m_session.hiddenShapes(isReplay));
}

void Ui::drawView(double share) {
    m_frame.camera = m_session.camera;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::SetNextWindowPos(m_frame.origin);
    ImGui::SetNextWindowSize(m_frame.size);
    ImGui::Begin("view", nullptr, kFixed);
    ImGui::PopStyleVar();
    drawImage(share);
    const bool isHovered = ImGui::IsWindowHovered();
    moveCamera(isHovered);
    m_frame.camera = m_session.camera;
    Wires wires(m_frame, *ImGui::GetWindowDrawList());
    if (m_session.showsReplay) {
        m_session.status = "The view shows the replay: the level itself stays as it is";
    } else {
        drawSelection(m_session, wires);
        m_marks.draw(m_session, wires);
        useMouse(wires, isHovered);
    }
    ImGui::End();
}

}  // namespace editor
