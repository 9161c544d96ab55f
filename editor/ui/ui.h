#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/ui/panels/panels.h"
#include "editor/ui/state/session.h"
#include "editor/ui/view/gizmo.h"
#include "editor/ui/view/joint_handles.h"
#include "editor/ui/view/overlay_marks.h"
#include "editor/ui/view/picking.h"
#include "editor/ui/view/viewport.h"

namespace editor {

/// All of the window but the window itself: lays out the panels, and gives the mouse in the view to camera, tools and
/// gizmo. It belongs to the current ImGui context.
class Ui {
public:
    /// All outlive it.
    Ui(Session& session, Viewport& viewport) : m_session(session), m_viewport(viewport) {}
    /// Makes the image of the replay when it is first wanted.
    std::function<std::unique_ptr<Viewport>(const rubble::World&)> makeViewport;
    /// Whether nothing would become of another frame.
    bool isSettled() { return shownViewport().isSettled(); }

    /// What the view shows: the level, or the replay.
    Viewport& shownViewport() { return m_session.showsReplay && m_replay ? *m_replay : m_viewport; }
    /// Writes it as PNG, with all the light that an image gathers; an error, or empty.
    std::string writeView(const std::string& path);

    /// Writes the profiler's samples as a trace; an error, or empty.
    std::string writeTrace(const std::string& path) const { return m_profiler.writeTrace(path); }

    /// Makes one frame of the interface, between ImGui's NewFrame() and Render(). share: see Viewport::draw();
    /// 0: the image of the level stays.
    void frame(double share);
    /// The rectangle of the view in the last frame, with its camera.
    const ViewFrame& view() const { return m_frame; }
    /// The palette of commands.
    CommandPalette& commands() { return m_commands; }
    /// Adds the figures of the last step and frame to the profiler.
    void sample(double uiMs) { m_profiler.sample(m_session, m_viewport, uiMs); }

private:
    void drawView(double share);
    void drawImage(double share);
    void drawLevel(Viewport& shown, double share);
    void drawRight();
    void drawBottom();
    void moveCamera(bool isHovered);
    void useMouse(Wires& wires, bool isFree);
    void useBrush(Wires& wires, const std::optional<Hover>& hover, bool isFree);
    void click(const Hover& hover);
    void describe(const std::optional<Hover>& hover);

    Session& m_session;
    Viewport& m_viewport;
    std::unique_ptr<Viewport> m_replay;
    ViewFrame m_frame;
    TreePanel m_tree;
    ProfilerPanel m_profiler;
    CommandPalette m_commands;
    Gizmo m_gizmo;
    JointHandles m_jointHandles;
    OverlayMarks m_marks;
    std::optional<Stroke> m_stroke;  ///< while the button is down
    bool m_isCameraHeld = false;
};

}  // namespace editor
