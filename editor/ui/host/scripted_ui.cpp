#include "editor/ui/host/scripted_ui.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/vec3.hpp>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "editor/core/arguments.h"
#include "editor/core/child_process.h"
#include "editor/ui/state/keys.h"
#include "samples/support/out_folder.h"

namespace editor {
namespace {

constexpr int kMaxFrames = 64;  ///< in which an image gathers its light

using Words = std::vector<Given>;

const std::string& wordAt(const Words& words, size_t place) {
    if (place >= words.size()) throw Refused(fmt::format("expected at least {} values", place + 1));
    return words[place].value;
}

glm::dvec3 pointAt(const Words& words, size_t place) {
    glm::dvec3 point;
    if (sscanf(wordAt(words, place).c_str(), "%lf,%lf,%lf", &point.x, &point.y, &point.z) != 3)
        throw Refused(fmt::format("expected three numbers x,y,z, found '{}'", words[place].value));
    return point;
}

int numberOf(const std::string& text) {
    int number = 0;
    if (sscanf(text.c_str(), "%d", &number) != 1) throw Refused(fmt::format("expected a number, found '{}'", text));
    return number;
}

/// Which of some names a text is.
template <class Names>
int choiceOf(const std::string& text, const Names& names) {
    std::string all;
    int place = 0;
    for (const char* name : names) {
        if (text == name) return place;
        all += std::string(place++ ? " " : "") + name;
    }
    throw Refused(fmt::format("expected one of: {}, found '{}'", all, text));
}

}  // namespace

struct ScriptedUi::Verb {
    const char* name;
    const char* help;
    void (ScriptedUi::*run)(const Words& words);
};

const ScriptedUi::Verb ScriptedUi::kVerbs[] = {
    {"camera", "FROM AT: looks from a point at another one", &ScriptedUi::look},
    {"frame", "shows what is selected, or all", &ScriptedUi::frameSelection},
    {"mode", "select, move, rotate, scale, brush or break", &ScriptedUi::setMode},
    {"brush", "FORM [OPERATION] [size=N] [index=N] [mirror=AXES]", &ScriptedUi::setBrush},
    {"breaker", "COMMAND [METRES]: what a click breaks", &ScriptedUi::setBreaker},
    {"hover", "POINT: the mouse goes to where a point of the world is seen", &ScriptedUi::hover},
    {"at", "X Y: the mouse goes to a pixel of the window", &ScriptedUi::moveTo},
    {"by", "X Y: the mouse moves by pixels", &ScriptedUi::moveBy},
    {"leave", "the mouse goes out of the window", &ScriptedUi::leave},
    {"click", "the left button goes down and up", &ScriptedUi::click},
    {"press", "the left button goes down", &ScriptedUi::press},
    {"release", "the left button goes up", &ScriptedUi::release},
    {"key", "KEYS: presses keys, as Ctrl+D or F5", &ScriptedUi::pressKeys},
    {"tab", "NAME: a panel comes to the front", &ScriptedUi::showTab},
    {"overlay", "NAME [yes|no]", &ScriptedUi::showOverlay},
    {"pass", "NAME: an image of the renderer", &ScriptedUi::showPass},
    {"commands", "[WORDS]: opens the palette of commands", &ScriptedUi::showCommands},
    {"close", "closes it", &ScriptedUi::closeCommands},
    {"form", "COMMAND [NAME=VALUE...]: opens its form, with values in it", &ScriptedUi::showForm},
    {"tour", "STEP: a step of the tour; 0: none", &ScriptedUi::showTour},
    {"play", "STEPS: plays, a frame each step", &ScriptedUi::play},
    {"live", "shows the level again", &ScriptedUi::live},
    {"replay", "STEP: shows a step of the last play", &ScriptedUi::replay},
    {"film", "FILE.mp4 or FOLDER: the view of each step of the last play, by ffmpeg or as images", &ScriptedUi::film},
    {"screenshot", "FILE: writes an image of the window", &ScriptedUi::writeImage},
};

std::string folderError(const std::string& folder) {
    return folder.empty() ? "" : rubble::makeOutFolder(folder);
}

ScriptedUi::ScriptedUi(const StageSettings& settings, int width, int height)
    : m_gl(width, height), m_width(width), m_height(height) {
    m_stage.emplace(settings, m_gl.loader());
    static constexpr std::pair<ImGuiKey, int> kKeys[] = {
        {ImGuiKey_Tab, GLFW_KEY_TAB},
        {ImGuiKey_Enter, GLFW_KEY_ENTER},
        {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
        {ImGuiKey_UpArrow, GLFW_KEY_UP},
        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
        {ImGuiKey_Delete, GLFW_KEY_DELETE},
        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
    };
    for (const auto& [key, code] : kKeys) ImGui::GetIO().KeyMap[key] = code;
}

void ScriptedUi::frame(double share) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {float(m_width), float(m_height)};
    io.DeltaTime = 1.0f / 60.0f;
    io.MousePos = m_x < 0 ? ImVec2(-1e6f, -1e6f) : ImVec2(m_x, m_y);
    io.MouseDown[0] = m_isDown;
    ImGui::NewFrame();
    m_stage->draw(share, m_gl.framebuffer());
}

void ScriptedUi::frames(int count) {
    for (int i = 0; i < count; ++i) frame(0.0);
}

std::string ScriptedUi::run(const std::string& text) {
    try {
        const Line line = readLine(text);
        if (line.command.empty() || line.command.starts_with("--")) return "";
        if (line.command != "ui") {
            const bool isDone = m_stage->session().run(line);
            frames(1);
            return isDone ? "" : m_stage->session().messages().back().text;
        }
        const std::string& name = wordAt(line.given, 0);
        for (const Verb& verb : kVerbs)
            if (name == verb.name) {
                (this->*verb.run)({line.given.begin() + 1, line.given.end()});
                return "";
            }
        std::string all;
        for (const Verb& verb : kVerbs) all += fmt::format("\n  ui {} {}", verb.name, verb.help);
        throw Refused(fmt::format("expected one of these, found '{}':{}", name, all));
    } catch (const std::exception& error) {
        return fmt::format("{}: {}", text, error.what());
    }
}

std::string ScriptedUi::runAll(const std::string& lines, const std::string& file) {
    const std::string place = file.empty() ? "line " : file + ":";
    std::istringstream in(lines);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (const size_t at = line.find("$OUT"); at != line.npos) line.replace(at, 4, m_folder);
        if (const std::string error = run(line); !error.empty()) return fmt::format("{}{}: {}", place, number, error);
    }
    return "";
}

void ScriptedUi::look(const Words& words) {
    m_stage->session().camera.look(pointAt(words, 0), pointAt(words, 1));
    frames(1);
}

void ScriptedUi::frameSelection(const Words&) {
    m_stage->session().frameSelection();
    frames(1);
}

void ScriptedUi::setMode(const Words& words) {
    static constexpr const char* kModes[] = {"select", "move", "rotate", "scale", "brush", "break"};
    m_stage->session().mode = Mode(choiceOf(wordAt(words, 0), kModes));
}

void ScriptedUi::setBrush(const Words& words) {
    Brush& brush = m_stage->session().brush;
    m_stage->session().mode = Mode::Brush;
    for (const Given& word : words) {
        if (word.name == "size")
            brush.size = std::clamp(numberOf(word.value), 1, 64);
        else if (word.name == "index")
            brush.index = std::clamp(numberOf(word.value), 1, 255);
        else if (word.name == "mirror")
            brush.mirror = choiceOf(word.value, kMirrors);
        else if (&word == words.data())
            brush.form = Form(choiceOf(word.value, kForms));
        else
            brush.operation = choiceOf(word.value, kOperations);
    }
}

void ScriptedUi::setBreaker(const Words& words) {
    Session& session = m_stage->session();
    session.mode = Mode::Break;
    session.breaker = choiceOf(wordAt(words, 0), kBreakers);
    if (words.size() > 1) session.breakSize = std::stod(words[1].value);
}

void ScriptedUi::hover(const Words& words) {
    frames(1);
    const auto at = m_stage->ui().view().project(pointAt(words, 0));
    if (!at || !m_stage->ui().view().contains(*at)) throw Refused("expected a point that the view shows");
    m_x = at->x, m_y = at->y;
    frames(2);
}

void ScriptedUi::moveTo(const Words& words) {
    m_x = float(numberOf(wordAt(words, 0)));
    m_y = float(numberOf(wordAt(words, 1)));
    frames(2);
}

void ScriptedUi::moveBy(const Words& words) {
    m_x += float(numberOf(wordAt(words, 0)));
    m_y += float(numberOf(wordAt(words, 1)));
    frames(2);
}

void ScriptedUi::leave(const Words&) {
    m_x = m_y = -1.0f;
    frames(2);
}

void ScriptedUi::press(const Words&) {
    m_isDown = true;
    frames(2);
}

void ScriptedUi::release(const Words&) {
    m_isDown = false;
    frames(2);
}

void ScriptedUi::click(const Words& words) {
    press(words);
    release(words);
}

void ScriptedUi::pressKeys(const Words& words) {
    const KeyPress press = readKeys(wordAt(words, 0));
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = press.hasCtrl, io.KeyShift = press.hasShift;
    io.KeysDown[press.key] = true;
    frames(1);
    io.KeysDown[press.key] = io.KeyCtrl = io.KeyShift = false;
    frames(1);
}

void ScriptedUi::showTab(const Words& words) {
    static constexpr const char* kRight[] = {"Properties", "Palette", "Sky", "View"};
    static constexpr const char* kBottom[] = {"History", "Messages", "Profiler", "Replay"};
    Tabs& tabs = m_stage->session().tabs;
    const std::string& name = wordAt(words, 0);
    const bool isRight = std::find(std::begin(kRight), std::end(kRight), name) != std::end(kRight);
    (isRight ? tabs.right : tabs.bottom) = isRight ? name : kBottom[choiceOf(name, kBottom)];
    tabs.isAsked = true;
    frames(2);
}

void ScriptedUi::showOverlay(const Words& words) {
    std::vector<const char*> names;
    for (const OverlayName& each : kOverlays) names.push_back(each.name);
    const OverlayName& chosen = kOverlays[choiceOf(wordAt(words, 0), names)];
    m_stage->editor().view().overlays.*chosen.shown = words.size() < 2 || words[1].value == "yes";
    frames(1);
}

void ScriptedUi::showPass(const Words& words) {
    const std::vector<std::string>& all = m_stage->viewport().passes();
    std::vector<const char*> names;
    for (const std::string& each : all) names.push_back(each.c_str());
    m_stage->session().pass = names[size_t(choiceOf(wordAt(words, 0), names))];
}

void ScriptedUi::showCommands(const Words& words) {
    m_stage->session().wantsCommands = true;
    frames(2);
    for (const Given& word : words)
        for (const char c : word.value + (&word == &words.back() ? "" : " ")) {
            ImGui::GetIO().AddInputCharacter(unsigned(c));
            frames(1);
        }
    frames(2);
}

void ScriptedUi::closeCommands(const Words&) {
    m_stage->ui().commands().close();
    frames(1);
}

void ScriptedUi::showTour(const Words& words) {
    m_stage->session().tour = std::clamp(numberOf(wordAt(words, 0)), 0, kTourSteps);
    frames(2);
}

void ScriptedUi::showForm(const Words& words) {
    if (!findCommand(wordAt(words, 0))) throw Refused(fmt::format("expected a command, found '{}'", words[0].value));
    m_stage->session().wantedCommand = words[0].value;
    m_stage->session().wantedValues = {words.begin() + 1, words.end()};
    m_stage->session().wantsCommands = true;
    frames(3);
}

void ScriptedUi::play(const Words& words) {
    Session& session = m_stage->session();
    if (!session.editor().document().isPlaying()) session.run("play", {});
    session.isPaused = false;
    for (int i = numberOf(wordAt(words, 0)); i > 0; --i) {
        session.speed = 1.0;
        session.advance(1.0 / 60.0);
        frame(0.25);
    }
    session.isPaused = true;
}

void ScriptedUi::replay(const Words& words) {
    Session& session = m_stage->session();
    const int step = numberOf(wordAt(words, 0)), size = int(session.replay.size());
    if (step < 1 || step > size)
        throw Refused(size ? fmt::format("expected a step from 1 to {}, found {}", size, step)
                           : std::string("expected steps that were played, found none"));
    session.replay.seek(size_t(step));
    session.showsReplay = true;
    frames(1);
}

void ScriptedUi::live(const Words&) {
    m_stage->session().showsReplay = false;
}

void ScriptedUi::film(const Words& words) {
    namespace fs = std::filesystem;
    Session& session = m_stage->session();
    const std::string path = (fs::path(m_folder) / wordAt(words, 0)).string();
    const bool isFilm = path.ends_with(".mp4");
    const ScratchFolder scratch;
    const fs::path folder = isFilm ? fs::path(scratch / "") : fs::path(path);
    if (session.replay.size() == 0) throw Refused("expected steps that were played, found none");
    fs::create_directories(folder);
    session.showsReplay = true;
    for (size_t step = 1; step <= session.replay.size(); ++step) {
        session.replay.seek(step);
        frame(1.0);
        const std::string image = (folder / fmt::format("{:06}.png", step)).string();
        if (const std::string error = m_stage->ui().shownViewport().write(image); !error.empty()) throw Refused(error);
    }
    if (!isFilm) return;
    constexpr int kSeconds = 600;
    const ChildResult made =
        runChild({"ffmpeg", "-loglevel", "error", "-y", "-framerate", "60", "-i", scratch / "%06d.png", "-vf",
                  "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", path},
                 kSeconds);
    if (!made.isDone)
        throw Refused(
            fmt::format("{}: expected ffmpeg (Debian package ffmpeg) to write it: {} {}", path, made.end, made.output));
}

void ScriptedUi::writeImage(const Words& words) {
    namespace fs = std::filesystem;
    const fs::path path = fs::path(m_folder) / wordAt(words, 0);
    std::error_code ignored;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), ignored);
    int count = 0;
    do frame(1.0);
    while (!m_stage->ui().isSettled() && ++count < kMaxFrames);
    frame(1.0);
    if (const std::string error = m_gl.write(path.string()); !error.empty()) throw Refused(error);
}

}  // namespace editor
