#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "editor/ui/state/session.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// Handles in the view that move or turn the bodies, lights and joints that are selected, or scale a shape: along an
/// axis; moves also by the middle, on the surfaces under the mouse. The drag shows where they would come; its end is
/// one command.
class Gizmo {
public:
    /// Draws it and reacts to the mouse. isMouseFree: no panel wants the mouse. True: the mouse is on it.
    bool update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree);
    /// Whether a handle is held.
    bool isDragging() const { return m_held >= 0; }

private:
    static constexpr int kMiddle = 3;
    int handleUnder(const Session& session, const ViewFrame& frame, ImVec2 mouse) const;
    bool fit(Session& session);
    glm::dvec3 tipOf(int axis) const;
    glm::ivec3 scaledSize(const rubble_shape_state& shape) const;
    void drag(Session& session, const ViewFrame& frame, ImVec2 mouse);
    void dragOnSurface(Session& session, const ViewFrame& frame, ImVec2 mouse);
    void release(Session& session);
    void drawDrag(Session& session, Wires& wires) const;
    void draw(Session& session, const ViewFrame& frame, ImDrawList& list, int hovered) const;

    glm::dvec3 m_center{0.0}, m_half{0.0};  ///< of the box around all
    glm::dquat m_turn{1.0, 0.0, 0.0, 0.0};  ///< of the axes
    double m_length = 1.0;                  ///< metres of an arrow
    Mode m_mode = Mode::Select;
    int m_held = -1;  ///< axis, or kMiddle
    ImVec2 m_start{0, 0};
    glm::dvec3 m_by{0.0};  ///< metres, or degrees
};

/// The shapes of all bodies that are selected.
std::vector<rubble_shape_state> selectedShapes(Session& session);
/// Where the lights and the frames of joints are that are selected.
std::vector<glm::dvec3> selectedPoints(Session& session);

}  // namespace editor
