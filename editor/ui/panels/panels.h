#pragma once
#include <string>
#include <vector>

#include "editor/ui/state/session.h"
#include "editor/ui/view/viewport.h"

namespace editor {

/// The row of tools at the top: files, history, modes, brush, play.
void drawToolbar(Session& session);
/// The row at the bottom: what the mouse points at, and the level.
void drawStatus(Session& session, const Viewport& viewport);
/// The steps that were done and undone; a click goes there.
void drawHistory(Session& session);
/// What commands said, and a line to type them.
void drawMessages(Session& session);
/// The steps of the last play; a drag shows any of them.
void drawReplay(Session& session);
/// All values of what is selected.
void drawProperties(Session& session);
/// Asks what becomes of changes that an editor left that ended early; nothing where there are none.
void drawRecovery(Session& session);
/// How many steps the tour has.
inline constexpr int kTourSteps = 5;
/// A step of the tour that the first start shows, over the view.
void drawTour(Session& session, const ViewFrame& view);
/// The entries of the palette of the shape that is selected.
void drawPalette(Session& session);
/// Time of day, fog, gravity and what else is of the whole level.
void drawEnvironment(Session& session);
/// What is drawn over the view, and which image of the renderer.
void drawViewSettings(Session& session, const Viewport& viewport);

/// All objects of the level, with a search.
class TreePanel {
public:
    /// Draws it.
    void draw(Session& session);

private:
    struct Row {
        uint64_t handle;
        uint32_t kind;
        int depth;
        std::string name;
    };
    void gather(Session& session);
    void drawRow(Session& session, const Row& row);

    std::vector<Row> m_rows, m_shown;
    std::string m_search, m_searched;
    uint64_t m_version = 0;
};

/// Times of the stages of a step and of a frame, over the last seconds.
class ProfilerPanel {
public:
    /// Adds the figures of the step and of the frame that were last.
    void sample(Session& session, const Viewport& viewport, double uiMs);
    /// Draws it.
    void draw(Session& session) const;

    static constexpr int kRows = 9, kSamples = 240;

private:
    void drawGraph() const;

    double m_ms[kRows][kSamples] = {};
    int m_next = 0, m_count = 0;
    rubble_step_stats m_step{};
    rubble_draw_stats m_draw{};
};

/// Finds commands by words, and runs them by a form.
class CommandPalette {
public:
    /// Draws it while it is open. It opens when session.wantsCommands is set.
    void draw(Session& session);
    /// The commands that it lists for a search, the best first.
    static std::vector<const Command*> find(const std::string& words);
    /// Whether it is open.
    bool isOpen() const { return m_isOpen; }
    /// Closes it.
    void close() { m_isOpen = false; }
    /// What is searched.
    std::string search;

private:
    void drawList(Session& session);
    void drawForm(Session& session);
    void choose(const Command& command);

    const Command* m_chosen = nullptr;
    std::vector<std::string> m_values;  ///< of the form, as they are typed; empty: left out
    std::string m_error;
    int m_marked = 0;
    bool m_isOpen = false, m_mustFocus = false;
};

}  // namespace editor
