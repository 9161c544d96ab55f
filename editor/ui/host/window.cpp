#include "editor/ui/host/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "editor/ui/state/keys.h"
#include "editor/ui/state/model_watch.h"

namespace editor {
namespace {

constexpr int kWidth = 1440, kHeight = 900;  ///< of a plain display
constexpr int kFramesOfEvent = 3;            ///< that the interface needs to answer to an event
constexpr double kBetweenLooks = 0.4;        ///< seconds, at files and for a cursor that blinks

/// What the callbacks of GLFW write to.
struct Events {
    Session* session = nullptr;
    int framesDue = kFramesOfEvent;
};

Events& eventsOf(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

void dropFiles(GLFWwindow* window, int count, const char** paths) {
    Events& events = eventsOf(window);
    events.framesDue = kFramesOfEvent;
    if (!events.session) return;
    for (int i = 0; i < count; ++i)
        events.session->run("import", {{"file", paths[i]}, {"at", pointText(events.session->camera.pivot)}});
    events.session->tabs.bottom = "Messages";
    events.session->tabs.isAsked = true;
}

/// Each event asks for some frames: nothing else does while the level stands still.
void watchEvents(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int, int, int, int) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { eventsOf(w).framesDue = kFramesOfEvent; });
    glfwSetDropCallback(window, dropFiles);
}

/// The window's frame needs room as well. Sizes are in pixels of a display that is not scaled.
void limitToScreen(int& width, int& height) {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    int x = 0, y = 0, areaWidth = 0, areaHeight = 0;
    float scale = 1.0f;
    if (monitor) glfwGetMonitorWorkarea(monitor, &x, &y, &areaWidth, &areaHeight);
    if (monitor) glfwGetMonitorContentScale(monitor, &scale, nullptr);
    if (areaWidth <= 0 || areaHeight <= 0 || !(scale > 0.0f)) return;
    width = std::min(width, int(float(areaWidth) / scale));
    height = std::min(height, int(float(areaHeight) / scale) - 40);
}

GLFWwindow* openWindow(std::string& error) {
    if (!glfwInit()) {
        const char* reason = nullptr;
        glfwGetError(&reason);
        error = fmt::format("cannot open a display: {}", reason ? reason : "no reason given");
        return nullptr;
    }
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    int width = kWidth, height = kHeight;
    limitToScreen(width, height);
    for (const auto& [major, minor] : {std::pair(4, 3), std::pair(3, 3)}) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        if (GLFWwindow* window = glfwCreateWindow(width, height, "Rubble", nullptr, nullptr)) return window;
    }
    error = "cannot open a window with OpenGL 3.3 core";
    glfwTerminate();
    return nullptr;
}

/// The open window, with all that is made for it.
class WindowLoop {
public:
    WindowLoop(GLFWwindow* window, const StageSettings& settings)
        : m_window(window),
          m_stage(settings, [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }) {
        m_events.session = &m_stage.session();
        glfwSetWindowUserPointer(window, &m_events);
        watchEvents(window);
        ImGui_ImplGlfw_InitForOpenGL(window, true);
    }
    ~WindowLoop() {
        ImGui_ImplGlfw_Shutdown();
        glfwSetWindowUserPointer(m_window, nullptr);
    }
    WindowLoop(const WindowLoop&) = delete;
    WindowLoop& operator=(const WindowLoop&) = delete;

    Session& session() { return m_stage.session(); }

    void run() {
        while (!isClosed()) {
            wait();
            const double now = glfwGetTime(), seconds = std::min(now - m_last, 0.25);
            m_last = now;
            session().advance(seconds);
            lookAtModels();
            m_events.framesDue = std::max(m_events.framesDue - 1, 0);
            draw();
            showTitle();
        }
    }

private:
    bool isBusy() {
        const bool plays = session().editor().document().isPlaying() && !session().isPaused;
        return plays || m_events.framesDue > 0 || !m_stage.ui().isSettled();
    }

    void wait() {
        if (isBusy()) return glfwPollEvents();
        const bool blinks = ImGui::GetIO().WantTextInput;  // a cursor
        do {
            const bool wakes = blinks || m_models.isWatching();
            wakes ? glfwWaitEventsTimeout(kBetweenLooks) : glfwWaitEvents();
            lookAtModels();
        } while (!blinks && m_models.isWatching() && !m_events.framesDue && !glfwWindowShouldClose(m_window));
        m_events.framesDue = std::max(m_events.framesDue, 1);
        m_last = glfwGetTime();
    }

    /// Not while something is dragged, whose end is a command.
    void lookAtModels() {
        if (!ImGui::IsAnyMouseDown() && m_models.poll(session(), glfwGetTime())) m_events.framesDue = kFramesOfEvent;
    }

    void draw() {
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        m_stage.draw(double(ImGui::GetIO().DisplayFramebufferScale.x), 0);
        glfwSwapBuffers(m_window);
    }

    void showTitle() {
        if (session().version() == m_titled) return;
        m_titled = session().version();
        const Document& document = session().editor().document();
        const std::string path = document.path().empty() ? "a new level" : document.path();
        glfwSetWindowTitle(m_window, (path.substr(path.find_last_of('/') + 1) + " - Rubble").c_str());
    }

    bool isClosed() {
        if (!glfwWindowShouldClose(m_window)) return false;
        if (session().mayClose()) return true;
        glfwSetWindowShouldClose(m_window, GLFW_FALSE);
        m_events.framesDue = kFramesOfEvent;
        return false;
    }

    GLFWwindow* m_window;
    Events m_events;
    Stage m_stage;
    ModelWatch m_models;
    double m_last = 0.0;
    uint64_t m_titled = 0;
};

/// To each user once.
void showTourOnce(Session& session) {
    const std::string folder = userJournals(), mark = folder + "/tour";
    if (folder.empty() || std::filesystem::exists(mark)) return;
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    session.tour = std::ofstream(mark) ? 1 : 0;
}

}  // namespace

bool hasDisplay() {
    const auto isSet = [](const char* name) { return std::getenv(name) && *std::getenv(name); };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
}

std::string runWindow(StageSettings settings, const std::string& level) {
    std::string error;
    GLFWwindow* const window = openWindow(error);
    if (!window) return error;
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    float scale = 1.0f;
    glfwGetWindowContentScale(window, &scale, nullptr);
    settings.scale = std::max(scale, 1.0f);
    try {
        WindowLoop loop(window, settings);
        if (const std::string wrong = loadKeys(userKeys()); !wrong.empty())
            loop.session().say(Message::Kind::Error, wrong);
        if (!level.empty()) {
            loop.session().run("open", {{"file", level}});
            loop.session().frameSelection();
        }
        showTourOnce(loop.session());
        loop.run();
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    glfwDestroyWindow(window);
    glfwTerminate();
    return error;
}

}  // namespace editor
