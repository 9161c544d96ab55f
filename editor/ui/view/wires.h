#pragma once
#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>
#include <rubble/rubble.hpp>

#include "editor/ui/state/camera.h"

namespace editor {

/// Lines and marks at places of the world, drawn over the view.
class Wires {
public:
    /// Both outlive it.
    Wires(const ViewFrame& frame, ImDrawList& list);

    /// A line from point to point.
    void line(glm::dvec3 from, glm::dvec3 to, ImU32 color, float width = 1.5f);
    /// A disc of some pixels.
    void dot(glm::dvec3 at, ImU32 color, float radius);
    /// A ring around a centre, in the plane of two axes as long as its radius.
    void ring(glm::dvec3 center, glm::dvec3 u, glm::dvec3 v, ImU32 color, float width = 1.5f);
    /// A face by its four corners; not drawn where one is behind the camera.
    void face(const glm::dvec3 (&corners)[4], ImU32 color);
    /// A box of cells of a shape; fill: of its faces, 0: none.
    void cells(const rubble_shape_state& shape, glm::dvec3 low, glm::dvec3 size, ImU32 color, ImU32 fill = 0,
               float width = 1.5f);
    /// A rectangle of the window.
    void tile(ImVec2 low, ImVec2 high, ImU32 color) { m_list.AddRectFilled(low, high, color); }
    /// What it draws over.
    const ViewFrame& frame() const { return m_frame; }
    /// A text beside a point.
    void label(glm::dvec3 at, ImU32 color, const char* text);

private:
    std::optional<ImVec2> project(glm::dvec3 seen) const;
    glm::dvec3 seen(glm::dvec3 point) const;

    const ViewFrame& m_frame;
    ImDrawList& m_list;
    glm::dvec3 m_eye;
    glm::dquat m_turn;
    double m_focal;
};

/// Where a cell's corner, or a point in cells, is in the world.
glm::dvec3 worldOf(const rubble_shape_state& shape, glm::dvec3 cell);

}  // namespace editor
