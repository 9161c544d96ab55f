#include "editor/ui/state/keys.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <vector>

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
    {GLFW_KEY_COMMA, 0, ",", "rewind", [](Session& s) { s.run("rewind", {}); }},
    {GLFW_KEY_F, 0, "F", nullptr, [](Session& s) { s.frameSelection(); }},
    {GLFW_KEY_H, 0, "H", "hide", [](Session& s) { s.run("hide", {}); }},
    {GLFW_KEY_H, kShift, "Shift+H", "hide_others", [](Session& s) { s.run("hide_others", {}); }},
    {GLFW_KEY_H, kCtrl, "Ctrl+H", "show", [](Session& s) { s.run("show", {}); }},
    {GLFW_KEY_END, 0, "End", "drop", [](Session& s) { s.run("drop", {}); }},
    {GLFW_KEY_V, 0, "V", "select", [](Session& s) { s.mode = Mode::Select; }},
    {GLFW_KEY_G, 0, "G", "move", [](Session& s) { s.mode = Mode::Move; }},
    {GLFW_KEY_R, 0, "R", "rotate", [](Session& s) { s.mode = Mode::Rotate; }},
    {GLFW_KEY_S, 0, "S", "scale", [](Session& s) { s.mode = Mode::Scale; }},
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

/// A key of the user's own, and what it runs.
struct OwnKey {
    KeyPress press;
    std::string shown;
    Line line;
};
std::vector<OwnKey> g_ownKeys;

/// Runs a command, or opens its form where it needs more than is given.
void runOwn(Session& session, const Line& line) {
    const Command& command = *findCommand(line.command);
    const bool needsMore =
        line.given.empty() && std::any_of(command.parameters.begin(), command.parameters.end(),
                                          [](const Parameter& each) { return each.otherwise == kRequired; });
    if (needsMore) return openForm(session, command.name.data());
    session.run(line);
}

OwnKey readOwn(const std::string& text) {
    const size_t space = text.find(' ');
    OwnKey own{readKeys(text.substr(0, space)), text.substr(0, space), {}};
    if (space != text.npos) own.line = readLine(std::string_view(text).substr(space));
    if (!findCommand(own.line.command)) throw Refused(fmt::format("expected a command, found '{}'", own.line.command));
    if (!own.line.given.empty()) Arguments(*findCommand(own.line.command), own.line.given);  // throws of wrong ones
    return own;
}

}  // namespace

KeyPress readKeys(std::string_view shown) {
    KeyPress press;
    std::string_view rest = shown;
    for (bool isHeld = true; isHeld;) {
        isHeld = rest.starts_with("Ctrl+") || rest.starts_with("Shift+");
        (rest.starts_with("Ctrl+") ? press.hasCtrl : press.hasShift) |= isHeld;
        if (isHeld) rest.remove_prefix(rest.find('+') + 1);
    }
    int number = 0;
    const bool isLetter = rest.size() == 1 && (std::isupper(uint8_t(rest[0])) || std::isdigit(uint8_t(rest[0])));
    if (isLetter) press.key = rest[0];  // GLFW has them by their ASCII codes
    if (rest.size() > 1 && rest[0] == 'F' &&
        std::from_chars(rest.data() + 1, rest.data() + rest.size(), number).ptr == rest.data() + rest.size() &&
        number >= 1 && number <= 12)
        press.key = GLFW_KEY_F1 + number - 1;
    for (const Key& key : kKeys)
        if (key.modifiers == 0 && rest == key.shown) press.key = key.key;
    if (!press.key) throw Refused(fmt::format("expected keys as Ctrl+K, Shift+F5, Del, Space or A, found '{}'", shown));
    return press;
}

std::string loadKeys(const std::string& path) {
    g_ownKeys.clear();
    std::ifstream file(path);
    std::string errors;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == line.npos || line.starts_with("--")) continue;
        try {
            g_ownKeys.push_back(readOwn(line));
        } catch (const Refused& error) {
            errors += fmt::format("{}{}:{}: {}", errors.empty() ? "" : "\n", path, number, error.what());
        }
    }
    return errors;
}

std::string userKeys() {
    const char *config = std::getenv("XDG_CONFIG_HOME"), *home = std::getenv("HOME");
    if (config && *config) return std::string(config) + "/rubble/keys.txt";
    return home && *home ? std::string(home) + "/.config/rubble/keys.txt" : "";
}

void handleKeys(Session& session, bool isTyping) {
    const ImGuiIO& io = ImGui::GetIO();
    const int held = (io.KeyCtrl ? kCtrl : 0) | (io.KeyShift ? kShift : 0);
    if (isTyping && !(held & kCtrl && ImGui::IsKeyPressed(GLFW_KEY_P, false))) return;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return;  // the camera flies
    for (const OwnKey& own : g_ownKeys)
        if (own.press.hasCtrl == io.KeyCtrl && own.press.hasShift == io.KeyShift &&
            ImGui::IsKeyPressed(own.press.key, false))
            return runOwn(session, own.line);
    for (const Key& key : kKeys)
        if (key.modifiers == held && ImGui::IsKeyPressed(key.key, false)) return key.act(session);
}

std::string keyOf(std::string_view command) {
    for (const OwnKey& own : g_ownKeys)
        if (own.line.command == command) return own.shown;
    for (const Key& key : kKeys)
        if (key.command && key.command == command) return key.shown;
    return "";
}

}  // namespace editor
