#pragma once
#include <memory>
#include <optional>
#include <string>

#include "editor/ui/gl/gl_surface.h"
#include "editor/ui/gl/gui_painter.h"
#include "editor/ui/ui.h"

namespace editor {

/// What a host of the interface says of itself.
struct StageSettings {
    std::string vdbTool;           ///< the program rubble-vdb
    std::string journals;          ///< see EditorSettings
    std::string preset = "draft";  ///< of the renderer, see rubble_renderer_settings
    std::string programCache;      ///< a folder for compiled programs; empty: none
    float scale = 1.0f;            ///< pixels of the display by those of a plain one
    bool isForced = false;         ///< see EditorSettings
};

/// The editor with its interface, over a GL that the host has made current: all but windows and events.
class Stage {
public:
    /// loader: finds GL functions by name. Throws std::runtime_error and rubble::Error.
    Stage(const StageSettings& settings, GlLoader loader);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Makes a frame of the interface, after ImGui's NewFrame() of the host, and draws it into a framebuffer. share:
    /// see Viewport::draw(); 0: it is made, but not drawn.
    void draw(double share, uint32_t framebuffer);
    /// The editor.
    Editor& editor() { return *m_editor; }
    /// What is shown of it.
    Session& session() { return *m_session; }
    /// Its panels.
    Ui& ui() { return *m_ui; }
    /// The image of the level.
    Viewport& viewport() { return *m_viewport; }

private:
    struct Context;
    std::unique_ptr<Context> m_context;
    std::optional<Editor> m_editor;
    std::optional<GuiPainter> m_painter;
    std::optional<Viewport> m_viewport;
    std::optional<Session> m_session;
    std::optional<Ui> m_ui;
    double m_uiMs = 0.0;
};

}  // namespace editor
