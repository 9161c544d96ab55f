#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <string>

namespace rubble::script {
class ScriptHost;
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

    /// The view of the camera.
    const rubble_view& view() const { return m_view; }
    /// Draws some frames of the world as it is, so that light settles, and writes the last one as PNG. What is wrong,
    /// or "".
    std::string write(rubble::script::ScriptHost& scripts, rubble_world world, const std::string& path);

private:
    struct Gl;
    const rubble_api* m_api = nullptr;
    rubble_view m_view = {};
    std::unique_ptr<Gl> m_gl;
};

}  // namespace lua_sample
