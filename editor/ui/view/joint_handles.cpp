#include "editor/ui/view/joint_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "editor/core/joints.h"
#include "editor/core/rotation.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

constexpr ImU32 kLink = IM_COL32(120, 190, 240, 255), kFan = IM_COL32(120, 190, 240, 44);
constexpr float kCatch = 9.0f;                             ///< pixels around a handle in which the mouse holds it
constexpr double kSmallest = 0.4, kLargest = 3.0;          ///< metres of an arc's radius
constexpr double kPart = glm::radians(5.0), kTried = 1.0;  ///< of an arc that is drawn; degrees between tried angles

bool isFree(const rubble::World& world, rubble_shape shape) {
    return shape && !(world.get_body_state(world.get_shape_state(shape).body).flags & RUBBLE_BODY_STATIC);
}

float distance(ImVec2 a, ImVec2 b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

/// False: no joint with a frame is selected.
bool JointHandles::fit(Session& session) {
    const std::vector<uint64_t>& selected = session.editor().selection().objects;
    const rubble::World& world = session.world();
    if (selected.size() != 1 || kindOf(world, selected[0]) != RUBBLE_KIND_JOINT || !hasFrame(world, selected[0]))
        return false;
    m_joint = selected[0];
    m_settings = settingsOf(world, m_joint);
    m_at = vectorOf(m_settings.position);
    const glm::dquat turn = quaternionOf(m_settings.rotation);
    m_axis = turn * glm::dvec3(1, 0, 0);
    const int moving = isFree(world, m_settings.shapes[1]) || !m_settings.shapes[0] ? 1 : 0;
    m_sign = moving == 1 ? 1.0 : -1.0;
    m_zero = turn * glm::dvec3(0, 1, 0);
    m_slide = m_settings.kind == RUBBLE_JOINT_WHEEL ? m_zero : m_axis;
    m_radius = kSmallest;
    if (m_settings.kind != RUBBLE_JOINT_HINGE) return true;
    const rubble_shape_state shape = world.get_shape_state(m_settings.shapes[moving]);
    glm::dvec3 out = worldOf(shape, glm::dvec3(shape.size[0], shape.size[1], shape.size[2]) * 0.5) - m_at;
    out -= m_axis * glm::dot(out, m_axis);
    if (glm::length(out) > 1e-3) m_zero = glm::normalize(out);
    m_radius = std::clamp(glm::length(out), kSmallest, kLargest);
    return true;
}

bool JointHandles::hasLimit(Limit limit) const {
    if (!(m_settings.flags & RUBBLE_JOINT_LIMITED)) return false;
    if (m_settings.kind == RUBBLE_JOINT_CONE || m_settings.kind == RUBBLE_JOINT_BALL) return limit == kHigh;
    return m_settings.kind == RUBBLE_JOINT_HINGE || slides();
}

double JointHandles::valueOf(Limit limit) const {
    if (limit == m_held) return m_value;
    return limit == kLow ? m_settings.lower_limit : m_settings.upper_limit;
}

glm::dvec3 JointHandles::tipOf(double value) const {
    switch (m_settings.kind) {
        case RUBBLE_JOINT_HINGE:
            return m_at + glm::angleAxis(m_sign * value, m_axis) * m_zero * m_radius;
        case RUBBLE_JOINT_PRISMATIC:
        case RUBBLE_JOINT_WHEEL:
            return m_at + m_slide * (m_sign * value);
        default:
            return m_at + (m_axis * std::cos(value) + m_zero * std::sin(value)) * m_radius;
    }
}

JointHandles::Limit JointHandles::limitUnder(const ViewFrame& frame, ImVec2 mouse) const {
    for (const Limit limit : {kLow, kHigh}) {
        const auto at = hasLimit(limit) ? frame.project(tipOf(valueOf(limit))) : std::nullopt;
        if (at && distance(*at, mouse) < kCatch * uiScale()) return limit;
    }
    return kNone;
}

/// The value whose tip is seen nearest to the mouse, in steps of the toolbar, on its side of the other limit.
double JointHandles::valueAt(const Session& session, const ViewFrame& frame, ImVec2 mouse) const {
    double value = m_value;
    if (slides()) {
        const auto p = frame.project(m_at), q = frame.project(tipOf(1.0));
        if (!p || !q) return value;
        const double x = double(q->x - p->x), y = double(q->y - p->y);
        value = (double(mouse.x - p->x) * x + double(mouse.y - p->y) * y) / std::max(x * x + y * y, 1.0);
    } else {
        const double first = m_settings.kind == RUBBLE_JOINT_HINGE ? -180.0 : 0.0;
        float nearest = 1e30f;
        for (double degrees = first; degrees <= 180.0; degrees += kTried) {
            const auto at = frame.project(tipOf(glm::radians(degrees)));
            if (!at || distance(*at, mouse) >= nearest) continue;
            nearest = distance(*at, mouse);
            value = glm::radians(degrees);
        }
    }
    const double step = slides() ? session.snap : glm::radians(session.snapAngle);
    if (step > 0.0) value = std::round(value / step) * step;
    if (hasLimit(kLow)) value = m_held == kLow ? std::min(value, valueOf(kHigh)) : std::max(value, valueOf(kLow));
    return value;
}

void JointHandles::release(Session& session) {
    const char* const name = m_held == kLow ? "low" : "high";
    m_held = kNone;
    const double before = name[0] == 'l' ? m_settings.lower_limit : m_settings.upper_limit;
    if (std::abs(m_value - before) < 1e-9) return;
    session.run("set_joint",
                {{name, numberText(slides() ? m_value : glm::degrees(m_value))}, {"what", handleText(m_joint)}});
}

void JointHandles::draw(Wires& wires, Limit hovered) const {
    wires.line(m_at - m_axis * (m_radius * 0.4), m_at + m_axis * m_radius, kLink, 2.5f);
    wires.dot(m_at + m_axis * m_radius, kLink, 4.0f);
    if (!hasLimit(kHigh)) return;
    const bool isCone = !hasLimit(kLow);
    const double low = isCone ? 0.0 : valueOf(kLow), high = valueOf(kHigh);
    if (isCone) {
        const glm::dvec3 side = glm::cross(m_axis, m_zero) * (m_radius * std::sin(high));
        wires.ring(m_at + m_axis * (m_radius * std::cos(high)), m_zero * (m_radius * std::sin(high)), side, kLink);
    }
    const int parts = slides() ? 1 : std::max(1, int(std::ceil((high - low) / kPart)));
    for (int i = 0; i < parts; ++i) {
        const glm::dvec3 from = tipOf(low + (high - low) * i / parts), to = tipOf(low + (high - low) * (i + 1) / parts);
        wires.line(from, to, kLink, slides() ? 4.0f : 2.0f);
        if (!slides()) wires.face({m_at, from, to, to}, kFan);
    }
    for (const Limit limit : {kLow, kHigh}) {
        if (!hasLimit(limit)) continue;
        const bool isLit = limit == hovered || limit == m_held;
        const double value = valueOf(limit);
        if (!slides()) wires.line(m_at, tipOf(value), kLink, 1.5f);
        wires.dot(tipOf(value), isLit ? theme::kAccent : kLink, 6.0f);
        if (isLit)
            wires.label(tipOf(value), theme::kText,
                        fmt::format("{} {} {}", limit == kLow ? "low" : "high",
                                    numberText(slides() ? value : glm::degrees(value)), slides() ? "m" : "\u00b0")
                            .c_str());
    }
}

bool JointHandles::update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree) {
    const bool isEditing =
        !session.editor().document().isPlaying() && session.mode != Mode::Brush && session.mode != Mode::Break;
    if (!isEditing || !fit(session)) return m_held = kNone, false;
    if (!hasLimit(m_held)) m_held = kNone;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Limit hovered = isMouseFree && m_held == kNone ? limitUnder(frame, mouse) : kNone;
    if (hovered != kNone && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        m_value = valueOf(hovered);
        m_held = hovered;
    } else if (m_held != kNone && (ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f)) {
        m_value = valueAt(session, frame, mouse);
    }
    Wires wires(frame, list);
    draw(wires, hovered);
    const bool wasHeld = m_held != kNone;
    if (wasHeld && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) release(session);
    return wasHeld || hovered != kNone;
}

}  // namespace editor
