#include "editor/ui/view/wires.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

#include "editor/core/rotation.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

constexpr double kNear = 0.05;  ///< metres in front of the camera
constexpr int kRingParts = 48;

}  // namespace

Wires::Wires(const ViewFrame& frame, ImDrawList& list)
    : m_frame(frame),
      m_list(list),
      m_eye(frame.camera.position()),
      m_turn(glm::inverse(frame.camera.rotation())),
      m_focal(double(frame.size.y) / 2.0 / std::tan(frame.camera.fov / 2.0)) {}

glm::dvec3 Wires::seen(glm::dvec3 point) const {
    return m_turn * (point - m_eye);
}

std::optional<ImVec2> Wires::project(glm::dvec3 p) const {
    if (p.z > -kNear * 0.99) return std::nullopt;
    const glm::dvec3 q = p * (m_focal / -p.z);
    if (std::abs(q.x) > 1e5 || std::abs(q.y) > 1e5) return std::nullopt;
    return ImVec2(m_frame.origin.x + m_frame.size.x / 2.0f + float(q.x),
                  m_frame.origin.y + m_frame.size.y / 2.0f - float(q.y));
}

void Wires::line(glm::dvec3 from, glm::dvec3 to, ImU32 color, float width) {
    glm::dvec3 a = seen(from), b = seen(to);
    if (a.z > b.z) std::swap(a, b);  // b is the nearer one
    if (a.z > -kNear) return;
    if (b.z > -kNear) b = a + (b - a) * ((-kNear - a.z) / (b.z - a.z));
    const auto p = project(a), q = project(b);
    if (p && q) m_list.AddLine(*p, *q, color, width * uiScale());
}

void Wires::dot(glm::dvec3 at, ImU32 color, float radius) {
    if (const auto p = project(seen(at))) m_list.AddCircleFilled(*p, radius * uiScale(), color, 16);
}

void Wires::ring(glm::dvec3 center, glm::dvec3 u, glm::dvec3 v, ImU32 color, float width) {
    glm::dvec3 before = center + u;
    for (int i = 1; i <= kRingParts; ++i) {
        const double angle = glm::radians(360.0) * i / kRingParts;
        const glm::dvec3 next = center + u * std::cos(angle) + v * std::sin(angle);
        line(before, next, color, width);
        before = next;
    }
}

void Wires::face(const glm::dvec3 (&corners)[4], ImU32 color) {
    ImVec2 at[4];
    for (int i = 0; i < 4; ++i) {
        const auto p = project(seen(corners[i]));
        if (!p) return;
        at[i] = *p;
    }
    m_list.AddQuadFilled(at[0], at[1], at[2], at[3], color);
}

void Wires::cells(const rubble_shape_state& shape, glm::dvec3 low, glm::dvec3 size, ImU32 color, ImU32 fill,
                  float width) {
    glm::dvec3 corner[8];
    for (int i = 0; i < 8; ++i) corner[i] = worldOf(shape, low + size * glm::dvec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    for (int axis = 0; fill && axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), base = side << axis;
            face({corner[base], corner[base | u], corner[base | u | v], corner[base | v]}, fill);
        }
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (!(i >> axis & 1)) line(corner[i], corner[i | 1 << axis], color, width);
}

void Wires::label(glm::dvec3 at, ImU32 color, const char* text) {
    const auto p = project(seen(at));
    if (!p || !m_frame.contains(*p)) return;
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float margin = 4.0f * uiScale();
    const float right = m_frame.origin.x + m_frame.size.x - size.x - 2.0f * margin;
    const ImVec2 low(std::round(std::min(p->x + 8.0f * uiScale(), right)), std::round(p->y - size.y / 2.0f));
    m_list.AddRectFilled({low.x - margin, low.y - margin / 2}, {low.x + size.x + margin, low.y + size.y + margin / 2},
                         IM_COL32(18, 19, 22, 215), margin);
    m_list.AddText(low, color, text);
}

glm::dvec3 worldOf(const rubble_shape_state& shape, glm::dvec3 cell) {
    return vectorOf(shape.position) + quaternionOf(shape.rotation) * (cell * shape.voxel_size);
}

}  // namespace editor
