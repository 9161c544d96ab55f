#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <string>

namespace rubble {
class Display;
}

namespace lua_sample {

/// A camera at a place that looks at another one, both in metres.
struct Camera {
    double eye[3] = {3.5, 2.2, -7.0}, target[3] = {0.0, 1.0, 0.0};
};

/// What it sees.
rubble_view viewOf(const Camera& camera, uint32_t width, uint32_t height);

/// Draws a world, and what scripts draw over it, without a window.
class OffscreenView {
public:
    /// Makes a GL context and tells the host's services of it, before worlds are made. What is missing, or "".
    std::string open(const rubble_api& api, const rubble_view& view);
    /// Draws nothing until open().
    OffscreenView();
    ~OffscreenView();

    /// Makes the renderer of a world, which sees it from the next step on. What is wrong, or "".
    std::string begin(rubble_world world);
    /// Before the world is destroyed.
    void end();
    /// Of begin(), else 0.
    rubble_renderer renderer() const { return m_renderer; }
    /// The view of the camera.
    const rubble_view& view() const { return m_view; }
    /// Draws some frames of the world as it is, so that light settles, and writes the last one as PNG. What is wrong,
    /// or "".
    std::string write(const std::string& path);

private:
    const rubble_api* m_api = nullptr;
    rubble_view m_view = {};
    rubble_renderer m_renderer = 0;
    std::unique_ptr<rubble::Display> m_display;
};

}  // namespace lua_sample
