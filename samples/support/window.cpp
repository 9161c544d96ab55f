#include "samples/support/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "samples/support/gl_context.h"

namespace rubble {

bool Window::hasDisplay() {
    const auto isSet = [](const char* name) { return std::getenv(name) && *std::getenv(name); };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
}

Result<std::unique_ptr<Window>> Window::create(glm::ivec2 size, const std::string& title) {
    const auto failure = [](const char* what) {
        const char* reason = nullptr;
        glfwGetError(&reason);
        glfwTerminate();
        return Error{std::string(what) + ": " + (reason ? reason : "no reason given")};
    };
    if (!glfwInit()) return failure("cannot open a display");
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = nullptr;
    for (const GlVersion wanted : kWantedGl) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, wanted.major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, wanted.minor);
        window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
        if (window) break;
    }
    if (!window) return failure("cannot open a window with OpenGL 3.3 core");
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    glfwSetInputMode(window, GLFW_CURSOR, GLFW_CURSOR_DISABLED);
    return std::unique_ptr<Window>(new Window(window));
}

Window::Window(GLFWwindow* window) : m_window(window), m_down(GLFW_KEY_LAST + 1, 0), m_wasDown(m_down) {
    glfwGetCursorPos(m_window, &m_mouse.x, &m_mouse.y);
    // What is pressed for less than a frame counts.
    for (const int mode : {GLFW_STICKY_KEYS, GLFW_STICKY_MOUSE_BUTTONS}) glfwSetInputMode(m_window, mode, GLFW_TRUE);
    glfwSetWindowUserPointer(m_window, this);
    glfwSetScrollCallback(m_window, [](GLFWwindow* w, double, double turned) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->m_wheel += turned;
    });
    glfwSetDropCallback(m_window, [](GLFWwindow* w, int count, const char** paths) {
        auto& drops = static_cast<Window*>(glfwGetWindowUserPointer(w))->m_drops;
        drops.insert(drops.end(), paths, paths + count);
    });
}

Window::~Window() {
    glfwDestroyWindow(m_window);
    glfwTerminate();
}

Window::Loader Window::loader() const {
    return [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); };
}

bool Window::poll() {
    glfwPollEvents();
    m_wasDown = m_down;
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
        m_down[size_t(key)] = glfwGetKey(m_window, key) == GLFW_PRESS;
    return !glfwWindowShouldClose(m_window);
}

bool Window::held(int key) const {
    return m_down[size_t(key)];
}
bool Window::pressed(int key) const {
    return m_down[size_t(key)] && !m_wasDown[size_t(key)];
}
bool Window::mouseHeld() const {
    return glfwGetMouseButton(m_window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
}

bool Window::buttonHeld(int button) const {
    return glfwGetMouseButton(m_window, button) == GLFW_PRESS;
}
double Window::takeWheel() {
    return std::exchange(m_wheel, 0.0);
}

std::vector<std::string> Window::takeDrops() {
    return std::exchange(m_drops, {});
}

void Window::captureCursor(bool isCaptured) {
    if (isCaptured == m_isCaptured) return;
    m_isCaptured = isCaptured;
    glfwSetInputMode(m_window, GLFW_CURSOR, isCaptured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(m_window, &m_mouse.x, &m_mouse.y);
}

glm::dvec2 Window::cursor() const {
    glm::dvec2 at, units;
    glfwGetCursorPos(m_window, &at.x, &at.y);
    int width = 0, height = 0;
    glfwGetWindowSize(m_window, &width, &height);
    units = {std::max(width, 1), std::max(height, 1)};
    return at * glm::dvec2(size()) / units;
}

glm::dvec2 Window::takeMouseMotion() {
    glm::dvec2 now;
    glfwGetCursorPos(m_window, &now.x, &now.y);
    return now - std::exchange(m_mouse, now);
}

glm::ivec2 Window::size() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(m_window, &size.x, &size.y);
    return size;
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(m_window, title.c_str());
}
void Window::present() {
    glfwSwapBuffers(m_window);
}

Image Window::readPixels() const {
    const glm::ivec2 pixels = size();
    Image flipped(pixels.x, pixels.y), image(pixels.x, pixels.y);
    const auto readBuffer = reinterpret_cast<void (*)(GLenum)>(glfwGetProcAddress("glReadBuffer"));
    const auto pixelStore = reinterpret_cast<void (*)(GLenum, GLint)>(glfwGetProcAddress("glPixelStorei"));
    const auto read = reinterpret_cast<void (*)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)>(
        glfwGetProcAddress("glReadPixels"));
    readBuffer(GL_BACK);
    pixelStore(GL_PACK_ALIGNMENT, 1);
    read(0, 0, pixels.x, pixels.y, GL_RGB, GL_UNSIGNED_BYTE, flipped.rgb.data());
    for (int y = 0; y < pixels.y; ++y)
        std::copy_n(flipped.at(0, pixels.y - 1 - y), size_t(pixels.x) * 3, image.at(0, y));
    return image;
}

}  // namespace rubble
