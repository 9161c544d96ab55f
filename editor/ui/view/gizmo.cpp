#include "editor/ui/view/gizmo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "editor/core/rotation.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

constexpr double kPixels = 90.0;  ///< of an arrow
constexpr float kCatch = 8.0f;    ///< pixels around a handle in which the mouse holds it
constexpr double kDegrees = 0.5;  ///< of a turn, each pixel of a drag

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

int Gizmo::handleUnder(const Session& session, const ViewFrame& frame, ImVec2 mouse) const {
    int best = -1;
    float least = kCatch * uiScale();
    for (int a = 0; a < 3; ++a) {
        if (session.mode == Mode::Move) {
            const auto p = frame.project(m_center), q = frame.project(m_center + axisOf(a) * m_length);
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

void Gizmo::drag(const Session& session, const ViewFrame& frame, ImVec2 mouse) {
    const double dx = double(mouse.x - m_start.x), dy = double(mouse.y - m_start.y);
    if (session.mode == Mode::Rotate) {
        const double towards = glm::dot(axisOf(m_held), frame.camera.forward()) > 0.0 ? 1.0 : -1.0;
        m_amount = snapped((dx - dy) * kDegrees * -towards, session.snapAngle);
        return;
    }
    const auto p = frame.project(m_center), q = frame.project(m_center + axisOf(m_held) * m_length);
    if (!p || !q) return;
    const double ax = double(q->x - p->x), ay = double(q->y - p->y);
    const double length2 = std::max(ax * ax + ay * ay, 1.0);
    m_amount = snapped((dx * ax + dy * ay) / length2 * m_length, session.snap);
}

void Gizmo::release(Session& session) {
    const glm::dvec3 by = axisOf(m_held) * m_amount;
    m_held = -1;
    if (m_amount == 0.0) return;
    if (session.mode == Mode::Move)
        session.run("move", {{"by", pointText(by)}});
    else
        session.run("rotate", {{"turn", pointText(by)}});
}

void Gizmo::draw(Session& session, const ViewFrame& frame, ImDrawList& list, int hovered) const {
    Wires wires(frame, list);
    const auto colorOf = [&](int a) { return a == m_held || a == hovered ? theme::kAccent : theme::kAxes[a]; };
    for (int a = 0; a < 3; ++a) {
        const float width = a == m_held || a == hovered ? 4.0f : 3.0f;
        if (session.mode == Mode::Rotate) {
            wires.ring(m_center, axisOf((a + 1) % 3) * m_length, axisOf((a + 2) % 3) * m_length, colorOf(a), width);
            continue;
        }
        const glm::dvec3 tip = m_center + axisOf(a) * m_length;
        wires.line(m_center, tip, colorOf(a), width);
        wires.dot(tip, colorOf(a), 6.0f);
    }
    wires.dot(m_center, IM_COL32(240, 240, 240, 255), 4.0f);
    if (m_held < 0) return;
    const glm::dvec3 by = axisOf(m_held) * m_amount;
    for (rubble_shape_state shape : selectedShapes(session)) {
        if (session.mode == Mode::Move) {
            put(shape.position, vectorOf(shape.position) + by);
        } else {
            const glm::dquat turn = rotationOf(by);
            put(shape.position, m_center + turn * (vectorOf(shape.position) - m_center));
            put(shape.rotation, turn * quaternionOf(shape.rotation));
        }
        wires.cells(shape, glm::dvec3(0.0), {shape.size[0], shape.size[1], shape.size[2]}, theme::kAccent,
                    theme::kAccentFaint & 0x28ffffffu);
    }
    const char* unit = session.mode == Mode::Move ? "m" : "\u00b0";
    wires.label(m_center + axisOf(m_held) * m_length, theme::kText,
                fmt::format("{} {} {}", "xyz"[m_held], numberText(m_amount), unit).c_str());
}

bool Gizmo::update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree) {
    const std::vector<rubble_shape_state> shapes = selectedShapes(session);
    if (shapes.empty() || session.editor().document().isPlaying()) return m_held = -1, false;
    if (m_held < 0) {
        glm::dvec3 low(1e30), high(-1e30);
        for (const rubble_shape_state& shape : shapes) {
            const glm::dvec3 size(shape.size[0], shape.size[1], shape.size[2]);
            for (int i = 0; i < 8; ++i) {
                const glm::dvec3 at = worldOf(shape, size * glm::dvec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
                low = glm::min(low, at), high = glm::max(high, at);
            }
        }
        m_center = (low + high) * 0.5;
    }
    m_length = frame.metersPerPixel(m_center) * kPixels * double(uiScale());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const int hovered = isMouseFree && m_held < 0 ? handleUnder(session, frame, mouse) : -1;
    if (hovered >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) m_held = hovered, m_start = mouse, m_amount = 0.0;
    if (m_held >= 0) drag(session, frame, mouse);
    draw(session, frame, list, hovered);
    const bool wasHeld = m_held >= 0;
    if (wasHeld && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) release(session);
    return wasHeld || hovered >= 0;
}

}  // namespace editor
