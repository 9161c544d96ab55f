#pragma once
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>

#include "editor/core/joints.h"
#include "editor/ui/state/session.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// Shows the axis and the limits of the joint that is selected, and lets its limits be dragged: on an arc about the
/// axis of a hinge, along that of a slider, around that of a cone; along the suspension of a wheel. The end of a drag
/// is one command.
class JointHandles {
public:
    /// Draws them and reacts to the mouse. isMouseFree: no panel wants the mouse. True: the mouse is on one.
    bool update(Session& session, const ViewFrame& frame, ImDrawList& list, bool isMouseFree);

private:
    enum Limit { kLow, kHigh, kNone };
    bool fit(Session& session);
    bool slides() const { return isLimitedInMetres(m_settings.kind); }
    bool hasLimit(Limit limit) const;
    double valueOf(Limit limit) const;
    glm::dvec3 tipOf(double value) const;
    Limit limitUnder(const ViewFrame& frame, ImVec2 mouse) const;
    double valueAt(const Session& session, const ViewFrame& frame, ImVec2 mouse) const;
    void release(Session& session);
    void draw(Wires& wires, Limit hovered) const;

    rubble_joint m_joint = 0;
    rubble_joint_settings m_settings{};
    glm::dvec3 m_at{0.0}, m_axis{1, 0, 0}, m_zero{0, 1, 0};  ///< zero: to where the moving side is now
    glm::dvec3 m_slide{1, 0, 0};                             ///< along which it slides
    double m_radius = 1.0, m_sign = 1.0;                     ///< sign: of the motion of the side that moves
    Limit m_held = kNone;
    double m_value = 0.0;  ///< radians or metres, of the limit that is held
};

}  // namespace editor
