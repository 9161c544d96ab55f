#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "editor/ui/state/session.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// Handles in the view that move or turn the bodies that are selected. The drag shows where they would come; its end is
/// one command.
class Gizmo {
public:
    /// Draws it and reacts to the mouse. isMouseFree: no panel wants the mouse. True: the mouse is on it.
    bool update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree);
    /// Whether a handle is held.
    bool isDragging() const { return m_held >= 0; }

private:
    int handleUnder(const Session& session, const ViewFrame& frame, ImVec2 mouse) const;
    void drag(const Session& session, const ViewFrame& frame, ImVec2 mouse);
    void release(Session& session);
    void draw(Session& session, const ViewFrame& frame, ImDrawList& list, int hovered) const;

    glm::dvec3 m_center{0.0};
    double m_length = 1.0;  ///< metres of an arrow
    int m_held = -1;        ///< axis
    ImVec2 m_start{0, 0};
    double m_amount = 0.0;  ///< metres or degrees
};

/// The shapes of all bodies that are selected.
std::vector<rubble_shape_state> selectedShapes(Session& session);

}  // namespace editor
