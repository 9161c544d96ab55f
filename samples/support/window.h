#pragma once
#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "runtime/core/result.h"
#include "samples/support/image.h"

struct GLFWwindow;

namespace rubble {

/// A window with a GL core context, current on the thread that made it. Keys by GLFW's names.
class Window {
public:
    static Result<std::unique_ptr<Window>> create(glm::ivec2 size, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    using Loader = void* (*)(const char* name);
    Loader loader() const;
    /// Handles events; false once the user has closed the window.
    bool poll();
    bool held(int key) const;
    /// True in the first poll() that saw the key down.
    bool pressed(int key) const;
    bool mouseHeld() const;
    /// Pixels that the captured mouse moved since the last call.
    glm::dvec2 takeMouseMotion();
    glm::ivec2 size() const;
    void setTitle(const std::string& title);
    void present();
    /// What was drawn since the last present().
    Image readPixels() const;

private:
    explicit Window(GLFWwindow* window);
    GLFWwindow* m_window;
    glm::dvec2 m_mouse{0.0};
    std::string m_down, m_wasDown;  ///< one byte a key
};

}  // namespace rubble
