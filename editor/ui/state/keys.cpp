#include "editor/ui/state/keys.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <glm/trigonometric.hpp>

namespace editor {
namespace {

enum : int { kCtrl = 1, kShift = 2 };

/// A key and what it does. Those of Blender and MagicaVoxel, where the two agree with what is here.
struct Key {
    int key, modifiers;
    const char* shown;
    const char* command;  ///< that it stands for, or null
    void (*act)(Session& session);
};

void openForm(Session& session, const char* command) {
    session.wantsCommands = true;
    session.wantedCommand = command;
}

void look(Session& session, double yaw, double pitch) {
    session.camera.yaw = glm::radians(yaw), session.camera.pitch = glm::radians(pitch);
}

void setForm(Session& session, Form form) {
    session.mode = Mode::Brush;
    session.brush.form = form;
}

void setOperation(Session& session, int operation) {
    session.mode = Mode::Brush;
    session.brush.operation = operation;
}

void escape(Session& session) {
    if (session.editor().document().isPlaying())
        session.run("stop", {});
    else
        session.run("deselect", {});
}

void save(Session& session) {
    if (session.editor().document().path().empty()) return openForm(session, "save");
    session.run("save", {});
}

const Key kKeys[] = {
    {GLFW_KEY_P, kCtrl, "Ctrl+P", nullptr, [](Session& s) { s.wantsCommands = true; }},
    {GLFW_KEY_Z, kCtrl, "Ctrl+Z", "undo", [](Session& s) { s.run("undo", {}); }},
    {GLFW_KEY_Z, kCtrl | kShift, "Ctrl+Shift+Z", nullptr, [](Session& s) { s.run("redo", {}); }},
    {GLFW_KEY_Y, kCtrl, "Ctrl+Y", "redo", [](Session& s) { s.run("redo", {}); }},
    {GLFW_KEY_S, kCtrl, "Ctrl+S", "save", save},
    {GLFW_KEY_O, kCtrl, "Ctrl+O", "open", [](Session& s) { openForm(s, "open"); }},
    {GLFW_KEY_N, kCtrl, "Ctrl+N", "new", [](Session& s) { openForm(s, "new"); }},
    {GLFW_KEY_I, kCtrl, "Ctrl+I", "import", [](Session& s) { openForm(s, "import"); }},
    {GLFW_KEY_C, kCtrl, "Ctrl+C", "copy", [](Session& s) { s.run("copy", {}); }},
    {GLFW_KEY_X, kCtrl, "Ctrl+X", "cut", [](Session& s) { s.run("cut", {}); }},
    {GLFW_KEY_V, kCtrl, "Ctrl+V", "paste", [](Session& s) { openForm(s, "paste"); }},
    {GLFW_KEY_D, kShift, "Shift+D", "duplicate", [](Session& s) { openForm(s, "duplicate"); }},
    {GLFW_KEY_A, kShift, "Shift+A", "create", [](Session& s) { openForm(s, "create"); }},
    {GLFW_KEY_DELETE, 0, "Del", "delete", [](Session& s) { s.run("delete", {}); }},
    {GLFW_KEY_ESCAPE, 0, "Esc", "deselect", escape},
    {GLFW_KEY_SPACE, 0, "Space", "play", [](Session& s) { s.togglePlay(); }},
    {GLFW_KEY_PERIOD, 0, ".", "step", [](Session& s) { s.stepOnce(); }},
    {GLFW_KEY_F, 0, "F", nullptr, [](Session& s) { s.frameSelection(); }},
    {GLFW_KEY_V, 0, "V", "select", [](Session& s) { s.mode = Mode::Select; }},
    {GLFW_KEY_G, 0, "G", "move", [](Session& s) { s.mode = Mode::Move; }},
    {GLFW_KEY_R, 0, "R", "rotate", [](Session& s) { s.mode = Mode::Rotate; }},
    {GLFW_KEY_B, 0, "B", nullptr, [](Session& s) { s.mode = Mode::Brush; }},
    {GLFW_KEY_X, 0, "X", "explode", [](Session& s) { s.mode = Mode::Break; }},
    {GLFW_KEY_1, 0, "1", "voxel", [](Session& s) { setForm(s, Form::Voxel); }},
    {GLFW_KEY_2, 0, "2", "box", [](Session& s) { setForm(s, Form::Box); }},
    {GLFW_KEY_3, 0, "3", "sphere", [](Session& s) { setForm(s, Form::Sphere); }},
    {GLFW_KEY_4, 0, "4", "line", [](Session& s) { setForm(s, Form::Line); }},
    {GLFW_KEY_5, 0, "5", "face", [](Session& s) { setForm(s, Form::Face); }},
    {GLFW_KEY_6, 0, "6", "flood", [](Session& s) { setForm(s, Form::Flood); }},
    {GLFW_KEY_T, 0, "T", nullptr, [](Session& s) { setOperation(s, 0); }},
    {GLFW_KEY_E, 0, "E", nullptr, [](Session& s) { setOperation(s, 1); }},
    {GLFW_KEY_P, 0, "P", nullptr, [](Session& s) { setOperation(s, 2); }},
    {GLFW_KEY_LEFT_BRACKET, 0, "[", nullptr, [](Session& s) { s.brush.size = std::max(s.brush.size - 1, 1); }},
    {GLFW_KEY_RIGHT_BRACKET, 0, "]", nullptr, [](Session& s) { s.brush.size = std::min(s.brush.size + 1, 64); }},
    {GLFW_KEY_KP_1, 0, "Num 1", nullptr, [](Session& s) { look(s, 0, 0); }},
    {GLFW_KEY_KP_3, 0, "Num 3", nullptr, [](Session& s) { look(s, 90, 0); }},
    {GLFW_KEY_KP_7, 0, "Num 7", nullptr, [](Session& s) { look(s, 0, -88); }},
};

}  // namespace

void handleKeys(Session& session, bool isTyping) {
    const ImGuiIO& io = ImGui::GetIO();
    const int held = (io.KeyCtrl ? kCtrl : 0) | (io.KeyShift ? kShift : 0);
    if (isTyping && !(held & kCtrl && ImGui::IsKeyPressed(GLFW_KEY_P, false))) return;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return;  // the camera flies
    for (const Key& key : kKeys)
        if (key.modifiers == held && ImGui::IsKeyPressed(key.key, false)) return key.act(session);
}

std::string keyOf(std::string_view command) {
    for (const Key& key : kKeys)
        if (key.command && key.command == command) return key.shown;
    return "";
}

}  // namespace editor
