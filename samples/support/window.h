#pragma once
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "samples/support/image.h"

struct GLFWwindow;

namespace rubble {

/// A window with a GL core context, current on the thread that created it. Keys are GLFW's key codes.
class Window {
public:
    /// Whether there is a display to open a window on.
    static bool hasDisplay();
    /// Opens a window of `size` pixels, the cursor captured. An error without a display or without OpenGL 3.3.
    static Result<std::unique_ptr<Window>> create(glm::ivec2 size, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    using Loader = void* (*)(const char* name);
    /// Finds GL functions by name, for Renderer::create().
    Loader loader() const;
    /// Handles events; false once the user has closed the window.
    bool poll();
    /// Whether a key was down at the last poll().
    bool held(int key) const;
    /// Whether a key went down between the last two calls of poll().
    bool pressed(int key) const;
    /// Whether the left mouse button is down.
    bool mouseHeld() const;
    /// Whether a button of the mouse is down: 0 left, 1 right, 2 middle.
    bool buttonHeld(int button) const;
    /// How far the wheel was turned since the last call.
    double takeWheel();
    /// Paths of the files that were dropped on it since the last call, UTF-8.
    std::vector<std::string> takeDrops();
    /// A captured cursor is hidden and never leaves the window.
    void captureCursor(bool isCaptured);
    /// Where a free cursor is, in pixels of the framebuffer.
    glm::dvec2 cursor() const;
    /// Pixels that the captured mouse moved since the last call.
    glm::dvec2 takeMouseMotion();
    /// Size of the framebuffer in pixels.
    glm::ivec2 size() const;
    /// Sets the text of the title bar.
    void setTitle(const std::string& title);
    /// Shows what was drawn, in step with the display.
    void present();
    /// The image that was drawn since the last present().
    Image readPixels() const;

private:
    explicit Window(GLFWwindow* window);
    GLFWwindow* m_window;
    glm::dvec2 m_mouse{0.0};
    double m_wheel = 0.0;
    std::vector<std::string> m_drops;
    bool m_isCaptured = true;
    std::string m_down, m_wasDown;  ///< one byte a key
};

}  // namespace rubble
