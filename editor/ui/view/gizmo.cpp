#include "editor/ui/view/gizmo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "editor/core/joints.h"
#include "editor/core/places.h"
#include "editor/core/rotation.h"
#include "editor/ui/state/theme.h"
#include "editor/ui/view/picking.h"

namespace editor {
namespace {

constexpr double kPixels = 90.0;   ///< of an arrow
constexpr float kCatch = 8.0f;     ///< pixels around a handle in which the mouse holds it
constexpr double kDegrees = 0.5;   ///< of a turn, each pixel of a drag
constexpr double kReach = 2000.0;  ///< metres in which surfaces are looked for

glm::dvec3 axisOf(int axis) {
    glm::dvec3 v(0.0);
    v[axis] = 1.0;
    return v;
}

float distanceTo(ImVec2 p, ImVec2 a, ImVec2 b) {
    const float dx = b.x - a.x, dy = b.y - a.y, length2 = std::max(dx * dx + dy * dy, 1e-6f);
    const float t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0f, 1.0f);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double snapped(double amount, double step) {
    return step > 0.0 ? std::round(amount / step) * step : amount;
}

}  // namespace

std::vector<rubble_shape_state> selectedShapes(Session& session) {
    std::vector<rubble_shape_state> all;
    std::vector<uint64_t> bodies;
    for (const uint64_t each : session.editor().selection().objects) {
        const int kind = kindOf(session.world(), each);
        uint64_t body = 0;
        if (kind == RUBBLE_KIND_BODY) body = each;
        if (kind == RUBBLE_KIND_SHAPE) body = session.world().get_shape_state(each).body;
        if (!body || std::find(bodies.begin(), bodies.end(), body) != bodies.end()) continue;
        bodies.push_back(body);
        for (const rubble_shape_state& shape : session.world().get_shape_states(body)) all.push_back(shape);
    }
    return all;
}

std::vector<glm::dvec3> selectedPoints(Session& session) {
    std::vector<glm::dvec3> all;
    for (const uint64_t each : session.editor().selection().objects) {
        const int kind = kindOf(session.world(), each);
        if (kind == RUBBLE_KIND_LIGHT || (kind == RUBBLE_KIND_JOINT && hasFrame(session.world(), each)))
            all.push_back(placeOf(session.world(), each).position);
    }
    return all;
}

int Gizmo::handleUnder(const Session& session, const ViewFrame& frame, ImVec2 mouse) const {
    int best = -1;
    float least = kCatch * uiScale();
    const auto middle = frame.project(m_center);
    if (session.mode == Mode::Move && middle && distanceTo(mouse, *middle, *middle) < least) return kMiddle;
    for (int a = 0; a < 3; ++a) {
        if (session.mode != Mode::Rotate) {
            const auto p = frame.project(m_center), q = frame.project(tipOf(a));
            if (!p || !q) continue;
            if (const float d = distanceTo(mouse, *p, *q); d < least) best = a, least = d;
            continue;
        }
        for (int i = 0; i < 32; ++i) {
            const auto at = [&](int part) {
                const double angle = glm::radians(360.0) * part / 32.0;
                return frame.project(m_center + m_length * (axisOf((a + 1) % 3) * std::cos(angle) +
                                                            axisOf((a + 2) % 3) * std::sin(angle)));
            };
            const auto p = at(i), q = at(i + 1);
            if (!p || !q) continue;
            if (const float d = distanceTo(mouse, *p, *q); d < least) best = a, least = d;
        }
    }
    return best;
}

glm::dvec3 Gizmo::tipOf(int axis) const {
    return m_center + m_turn * axisOf(axis) * m_length;
}

/// The box around all that is selected; false: nothing is. Scaled is one shape, along the axes of its grid.
bool Gizmo::fit(Session& session) {
    m_turn = glm::dquat(1, 0, 0, 0);
    if (session.mode == Mode::Scale) {
        const rubble_shape handle = session.selectedShape();
        if (!handle) return false;
        const rubble_shape_state shape = session.world().get_shape_state(handle);
        m_turn = quaternionOf(shape.rotation);
        m_center = worldOf(shape, glm::dvec3(shape.size[0], shape.size[1], shape.size[2]) * 0.5);
        return true;
    }
    glm::dvec3 low(1e30), high(-1e30);
    const auto add = [&](glm::dvec3 at) { low = glm::min(low, at), high = glm::max(high, at); };
    for (const rubble_shape_state& shape : selectedShapes(session)) {
        const glm::dvec3 size(shape.size[0], shape.size[1], shape.size[2]);
        for (int i = 0; i < 8; ++i) add(worldOf(shape, size * glm::dvec3(i & 1, (i >> 1) & 1, (i >> 2) & 1)));
    }
    for (const glm::dvec3 point : selectedPoints(session)) add(point);
    if (low.x > high.x) return false;
    m_center = (low + high) * 0.5;
    m_half = (high - low) * 0.5;
    return true;
}

void Gizmo::drag(Session& session, const ViewFrame& frame, ImVec2 mouse) {
    if (m_held == kMiddle) return dragOnSurface(session, frame, mouse);
    const double dx = double(mouse.x - m_start.x), dy = double(mouse.y - m_start.y);
    if (session.mode == Mode::Rotate) {
        const double towards = glm::dot(axisOf(m_held), frame.camera.forward()) > 0.0 ? 1.0 : -1.0;
        m_by = axisOf(m_held) * snapped((dx - dy) * kDegrees * -towards, session.snapAngle);
        return;
    }
    const auto p = frame.project(m_center), q = frame.project(tipOf(m_held));
    if (!p || !q) return;
    const double ax = double(q->x - p->x), ay = double(q->y - p->y);
    const double length2 = std::max(ax * ax + ay * ay, 1.0);
    const double amount = (dx * ax + dy * ay) / length2 * m_length;
    m_by = axisOf(m_held) * (session.mode == Mode::Move ? snapped(amount, session.snap) : amount);
}

/// The cells that the shape comes to have.
glm::ivec3 Gizmo::scaledSize(const rubble_shape_state& shape) const {
    const glm::dvec3 size(shape.size[0], shape.size[1], shape.size[2]);
    return glm::clamp(glm::ivec3(glm::round(size + m_by / shape.voxel_size)), 1, 4096);
}

/// The box comes to lie on what is under the mouse, else on height 0.
void Gizmo::dragOnSurface(Session& session, const ViewFrame& frame, ImVec2 mouse) {
    std::vector<rubble_body> own;
    for (const rubble_shape_state& shape : selectedShapes(session)) own.push_back(shape.body);
    rubble_query_filter filter = seenBy(session);
    filter.rejected_bodies = own.data();
    filter.rejected_body_count = uint32_t(own.size());
    const rubble_ray ray = rayAt(frame, mouse);
    const glm::dvec3 from = frame.camera.position(), direction = frame.direction(mouse);
    const rubble_hit hit = session.world().cast_rays(&ray, 1, filter).at(0);
    if (!hit.hit && !(from.y > 0.0 && direction.y < -1e-6 && from.y / -direction.y < kReach)) return;
    const glm::dvec3 at = hit.hit ? vectorOf(hit.position) : from + direction * (from.y / -direction.y);
    const glm::dvec3 normal = hit.hit ? vectorOf(hit.normal) : axisOf(1);
    const glm::dvec3 facing = glm::abs(normal);
    const int out = facing.y >= facing.x && facing.y >= facing.z ? 1 : facing.x >= facing.z ? 0 : 2;
    m_by = at + normal * glm::dot(facing, m_half) - m_center;
    for (int a = 0; a < 3; ++a)
        if (a != out) m_by[a] = snapped(m_by[a], session.snap);
}

void Gizmo::release(Session& session) {
    m_held = -1;
    if (m_by == glm::dvec3(0.0)) return;
    if (session.mode == Mode::Move) return void(session.run("move", {{"by", pointText(m_by)}}));
    if (session.mode == Mode::Rotate) return void(session.run("rotate", {{"turn", pointText(m_by)}}));
    const rubble_shape_state shape = session.world().get_shape_state(session.selectedShape());
    const glm::ivec3 size = scaledSize(shape);
    if (size == glm::ivec3(shape.size[0], shape.size[1], shape.size[2])) return;
    session.run("scale", {{"size", cellText(size)}, {"shape", referenceTo(session.world(), shape.shape)}});
}

/// Where all would come.
void Gizmo::drawDrag(Session& session, Wires& wires) const {
    if (session.mode == Mode::Scale) {
        const rubble_shape_state shape = session.world().get_shape_state(session.selectedShape());
        const glm::ivec3 size = scaledSize(shape);
        wires.cells(shape, glm::dvec3(0.0), size, theme::kAccent, theme::kAccentFaint & 0x28ffffffu);
        return wires.label(tipOf(m_held), theme::kText, (cellText(size) + " cells").c_str());
    }
    const bool moves = session.mode == Mode::Move;
    const glm::dquat turn = moves ? glm::dquat(1, 0, 0, 0) : rotationOf(m_by);
    const glm::dvec3 by = moves ? m_by : glm::dvec3(0.0);
    const auto moved = [&](glm::dvec3 at) { return m_center + by + turn * (at - m_center); };
    for (rubble_shape_state shape : selectedShapes(session)) {
        put(shape.position, moved(vectorOf(shape.position)));
        put(shape.rotation, turn * quaternionOf(shape.rotation));
        wires.cells(shape, glm::dvec3(0.0), {shape.size[0], shape.size[1], shape.size[2]}, theme::kAccent,
                    theme::kAccentFaint & 0x28ffffffu);
    }
    for (const glm::dvec3 point : selectedPoints(session)) wires.dot(moved(point), theme::kAccent, 7.0f);
    if (m_held == kMiddle) return wires.label(m_center + m_by, theme::kText, ("by " + pointText(m_by)).c_str());
    wires.label(m_center + axisOf(m_held) * m_length, theme::kText,
                fmt::format("{} {} {}", "xyz"[m_held], numberText(m_by[m_held]), moves ? "m" : "\u00b0").c_str());
}

void Gizmo::draw(Session& session, const ViewFrame& frame, ImDrawList& list, int hovered) const {
    Wires wires(frame, list);
    const auto colorOf = [&](int a, ImU32 otherwise) {
        return a == m_held || a == hovered ? theme::kAccent : otherwise;
    };
    for (int a = 0; a < 3; ++a) {
        const float width = a == m_held || a == hovered ? 4.0f : 3.0f;
        const ImU32 color = colorOf(a, theme::kAxes[a]);
        if (session.mode == Mode::Rotate) {
            wires.ring(m_center, axisOf((a + 1) % 3) * m_length, axisOf((a + 2) % 3) * m_length, color, width);
            continue;
        }
        const glm::dvec3 tip = tipOf(a);
        wires.line(m_center, tip, color, width);
        wires.dot(tip, color, 6.0f);
        if (session.mode == Mode::Scale) wires.dot(tip, theme::kPanel, 3.0f);
    }
    wires.dot(m_center, colorOf(kMiddle, IM_COL32(240, 240, 240, 255)), session.mode == Mode::Move ? 6.0f : 4.0f);
    if (m_held >= 0) drawDrag(session, wires);
}

bool Gizmo::update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree) {
    const bool isOther = std::exchange(m_mode, session.mode) != session.mode;
    if (isOther || (session.mode == Mode::Scale && !session.selectedShape())) m_held = -1;  // by keys, during a drag
    if (session.editor().document().isPlaying() || (m_held < 0 && !fit(session))) return m_held = -1, false;
    m_length = frame.metersPerPixel(m_center) * kPixels * double(uiScale());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const int hovered = isMouseFree && m_held < 0 ? handleUnder(session, frame, mouse) : -1;
    if (hovered >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        m_held = hovered, m_start = mouse, m_by = glm::dvec3(0.0);
    const bool isDragged = mouse.x != m_start.x || mouse.y != m_start.y;
    if (m_held >= 0 && isDragged) drag(session, frame, mouse);
    draw(session, frame, list, hovered);
    const bool wasHeld = m_held >= 0;
    if (wasHeld && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) release(session);
    return wasHeld || hovered >= 0;
}

}  // namespace editor
