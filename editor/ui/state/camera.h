#pragma once
#include <imgui.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <rubble/rubble.hpp>

namespace editor {

/// A camera that orbits a point. Yaw 0 looks along -z; positive pitch looks up. Angles in radians, lengths in metres.
struct Camera {
    glm::dvec3 pivot{0.0, 1.0, 0.0};
    double yaw = 0.6, pitch = -0.45, distance = 12.0, fov = 0.9;

    bool operator==(const Camera&) const = default;
    /// From camera space to world space.
    glm::dquat rotation() const;
    /// Where it is.
    glm::dvec3 position() const;
    /// Direction of view, of length 1.
    glm::dvec3 forward() const { return rotation() * glm::dvec3(0, 0, -1); }
    /// Puts it somewhere, looking at a point.
    void look(glm::dvec3 from, glm::dvec3 at);
    /// Turns about the pivot by shares of half a turn.
    void orbit(double right, double up);
    /// Moves sideways and up by shares of the view's height.
    void pan(double right, double up);
    /// Nearer by steps of a wheel.
    void zoom(double steps);
    /// Flies: metres along right, up and forward.
    void fly(glm::dvec3 by);
    /// Shows all of a ball.
    void frame(glm::dvec3 center, double radius);
};

/// A camera and the rectangle of the window that shows what it sees.
struct ViewFrame {
    Camera camera;
    ImVec2 origin, size;

    /// Whether it shows the same.
    bool operator==(const ViewFrame& o) const {
        return camera == o.camera && origin.x == o.origin.x && origin.y == o.origin.y && size.x == o.size.x &&
               size.y == o.size.y;
    }
    /// Where a point is seen; nothing: behind the camera.
    std::optional<ImVec2> project(glm::dvec3 point) const;
    /// Direction in which a point of the window lies, of length 1.
    glm::dvec3 direction(ImVec2 at) const;
    /// Metres of a pixel at a point.
    double metersPerPixel(glm::dvec3 point) const;
    /// Whether a point of the window is in it.
    bool contains(ImVec2 at) const;
    /// As the renderer takes it, into a framebuffer.
    rubble_view view(uint32_t framebuffer, int width, int height) const;
};

}  // namespace editor
