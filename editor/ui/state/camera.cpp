#include "editor/ui/state/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "editor/core/rotation.h"

namespace editor {
namespace {

constexpr double kMaxPitch = 1.55;    ///< radians
constexpr double kNear = 0.02;        ///< metres
constexpr double kZoomStep = 0.88;    ///< of the distance, each step of the wheel
constexpr double kMinDistance = 0.1;  ///< metres

}  // namespace

glm::dquat Camera::rotation() const {
    return glm::angleAxis(yaw, glm::dvec3(0, 1, 0)) * glm::angleAxis(pitch, glm::dvec3(1, 0, 0));
}

glm::dvec3 Camera::position() const {
    return pivot - forward() * distance;
}

void Camera::look(glm::dvec3 from, glm::dvec3 at) {
    const glm::dvec3 d = at - from;
    distance = std::max(glm::length(d), kMinDistance);
    yaw = std::atan2(-d.x, -d.z);
    pitch = std::clamp(std::asin(std::clamp(d.y / distance, -1.0, 1.0)), -kMaxPitch, kMaxPitch);
    pivot = at;
}

void Camera::orbit(double right, double up) {
    const double halfTurn = glm::radians(180.0);
    yaw = std::remainder(yaw - right * halfTurn, 2.0 * halfTurn);
    pitch = std::clamp(pitch + up * halfTurn, -kMaxPitch, kMaxPitch);
}

void Camera::pan(double right, double up) {
    const double height = 2.0 * distance * std::tan(fov / 2.0);
    pivot += rotation() * glm::dvec3(-right * height, up * height, 0.0);
}

void Camera::zoom(double steps) {
    distance = std::clamp(distance * std::pow(kZoomStep, steps), kMinDistance, 5000.0);
}

void Camera::fly(glm::dvec3 by) {
    pivot += rotation() * glm::dvec3(by.x, by.y, -by.z);
}

void Camera::frame(glm::dvec3 center, double radius) {
    pivot = center;
    distance = std::max(radius, 0.2) / std::tan(fov / 2.0) * 0.8;
}

std::optional<ImVec2> ViewFrame::project(glm::dvec3 point) const {
    const glm::dvec3 p = glm::inverse(camera.rotation()) * (point - camera.position());
    if (p.z > -kNear) return std::nullopt;
    const double focal = double(size.y) / 2.0 / std::tan(camera.fov / 2.0);
    return ImVec2(origin.x + size.x / 2.0f + float(p.x / -p.z * focal),
                  origin.y + size.y / 2.0f - float(p.y / -p.z * focal));
}

glm::dvec3 ViewFrame::direction(ImVec2 at) const {
    const double focal = double(size.y) / 2.0 / std::tan(camera.fov / 2.0);
    const glm::dvec3 d(double(at.x - origin.x - size.x / 2.0f), double(origin.y + size.y / 2.0f - at.y), -focal);
    return camera.rotation() * glm::normalize(d);
}

double ViewFrame::metersPerPixel(glm::dvec3 point) const {
    const double depth = std::max(glm::dot(point - camera.position(), camera.forward()), kNear);
    return 2.0 * depth * std::tan(camera.fov / 2.0) / std::max(double(size.y), 1.0);
}

bool ViewFrame::contains(ImVec2 at) const {
    return at.x >= origin.x && at.y >= origin.y && at.x < origin.x + size.x && at.y < origin.y + size.y;
}

rubble_view ViewFrame::view(uint32_t framebuffer, int width, int height) const {
    rubble_view view{};
    view.framebuffer = framebuffer;
    view.width = uint32_t(width), view.height = uint32_t(height);
    put(view.position, camera.position());
    put(view.rotation, camera.rotation());
    view.vertical_fov = camera.fov;
    view.alpha = 1.0;
    return view;
}

}  // namespace editor
