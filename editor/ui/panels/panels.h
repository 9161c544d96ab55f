#pragma once
#include <string>
#include <vector>

#include "editor/ui/panels/file_list.h"
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

/// All layers and objects of the level, with a search. An eye hides and shows what has shapes.
class TreePanel {
public:
    /// Draws it.
    void draw(Session& session);

private:
    enum class Eye : uint8_t { None, Open, Closed };
    struct Row {
        uint64_t handle;  ///< 0: a layer
        uint32_t kind;
        int depth;
        std::string name, what;  ///< the latter for commands
        Eye eye;
    };
    void gather(Session& session);
    void gatherLayers(Session& session);
    void addBody(Session& session, rubble_body body);
    void addRow(Session& session, uint64_t handle, uint32_t kind, int depth);
    void drawRow(Session& session, const Row& row);
    void drawEye(Session& session, const Row& row);

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
    /// Writes the samples as a trace that Perfetto and chrome://tracing open; an error, or empty.
    std::string writeTrace(const std::string& path) const;

    static constexpr int kRows = 9, kStepRows = 6, kSamples = 240;  ///< the first rows are those of a step

private:
    struct Sample {
        double seconds = 0.0;  ///< of a clock, at its end
        double ms[kRows] = {};
        rubble_step_stats step{};
        rubble_draw_stats draw{};
    };
    /// The n-th of the newest ones.
    const Sample& newest(int n) const { return m_samples[(m_next - 1 - n + 2 * kSamples) % kSamples]; }
    void drawGraph() const;

    Sample m_samples[kSamples];
    int m_next = 0, m_count = 0;
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
    bool drawFiles(Session& session);
    void choose(const Command& command);

    const Command* m_chosen = nullptr;
    std::vector<std::string> m_values;  ///< of the form, as they are typed; empty: left out
    std::string m_error;
    FileList m_files;
    int m_marked = 0;
    bool m_isOpen = false, m_mustFocus = false;
};

}  // namespace editor
