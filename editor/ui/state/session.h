#pragma once
#include <deque>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/editor.h"
#include "editor/ui/state/camera.h"
#include "editor/ui/state/replay.h"

namespace editor {

/// What the mouse does in the view.
enum class Mode : uint8_t { Select, Move, Rotate, Scale, Brush, Break };

/// Forms of brushes, as their commands are called.
inline constexpr const char* kForms[] = {"voxel", "box", "sphere", "line", "face", "flood"};
/// The indices of kForms.
enum class Form : uint8_t { Voxel, Box, Sphere, Line, Face, Flood };
inline constexpr const char* kOperations[] = {"add", "erase", "paint", "replace"};
inline constexpr const char* kMirrors[] = {"none", "x", "y", "z", "xy", "xz", "yz", "xyz"};
/// Commands that break things where one clicks.
inline constexpr const char* kBreakers[] = {"explode", "carve", "shatter", "spray"};

/// The brush that is in hand.
struct Brush {
    Form form = Form::Voxel;
    int operation = 0;  ///< of kOperations
    int size = 3;       ///< cells: radius of balls and lines, depth of faces
    int index = 5;      ///< entry of the palette
    int mirror = 0;     ///< of kMirrors
};

/// Which of the panels with tabs is in front.
struct Tabs {
    std::string right = "Properties", bottom = "History";
    bool isAsked = true;  ///< whether they were chosen other than by a click on them
};

/// A line of the panel of messages.
struct Message {
    enum class Kind : uint8_t { Call, Answer, Error } kind;
    std::string text;
};

/// The editor as the window sees it: the level with its commands, and what is shown of it and how. All that changes the
/// level goes through run().
class Session {
public:
    /// The editor outlives it.
    explicit Session(Editor& editor) : m_editor(editor) {}

    /// Runs a command, and keeps what it said as messages. False: it was refused.
    bool run(const Line& line);
    /// The same of a line that is typed.
    bool run(const std::string& text);
    /// The same, with values by their names.
    bool run(std::string_view command, std::initializer_list<Given> given);
    /// Runs a command while a value is dragged: it takes the place of the one before of the same drag in the history.
    void preview(const Line& line);
    /// Ends such a drag.
    void endPreview() { m_isPreviewing = false; }

    /// Selects an object, or adds it to what is selected.
    void select(uint64_t handle, bool adds);
    /// The shape that is selected, or the first one of the body that is; 0: none.
    rubble_shape selectedShape() const;
    /// Moves the camera to all that is selected, else to all that is not hidden.
    void frameSelection();
    /// What the view of the level, or of the replay, leaves out.
    std::vector<rubble_shape> hiddenShapes(bool isReplay);

    /// Begins to play, or goes on after a pause, or pauses.
    void togglePlay();
    /// Plays one step, and pauses.
    void stepOnce();
    /// Lets seconds pass on the clock; plays the steps that are due. True: something has moved.
    bool advance(double seconds);

    /// Whether the window may close: nothing is lost, or this was asked before and nothing was done since. Else it says
    /// what would be lost.
    bool mayClose();

    /// Grows with everything that may have changed the level or what is selected.
    uint64_t version() const { return m_version; }
    /// The editor.
    Editor& editor() { return m_editor; }
    /// The same, to read.
    const Editor& editor() const { return m_editor; }
    /// Its world.
    rubble::World& world() { return m_editor.world(); }
    /// What commands said, the last one last.
    const std::deque<Message>& messages() const { return m_messages; }
    /// Adds one. An error brings the page of messages to the front.
    void say(Message::Kind kind, const std::string& text);

    Camera camera;
    Mode mode = Mode::Select;
    Brush brush;
    int breaker = 0;         ///< of kBreakers
    double breakSize = 1.0;  ///< metres
    double snap = 0.1;       ///< metres of moves; 0: none
    double snapAngle = 15;   ///< degrees
    Tabs tabs;
    std::string pass = "final";  ///< which image of the renderer is shown
    bool isPaused = false;
    double speed = 1.0;               ///< of play, in multiples of the clock's
    bool wantsCommands = false;       ///< the palette of commands shall open
    std::string wantedCommand;        ///< with the form of this one
    std::vector<Given> wantedValues;  ///< and these values in it
    Replay replay;                    ///< of the last play
    bool showsReplay = false;         ///< the view shows it in place of the level
    std::string status;               ///< what the mouse points at
    int tour = 0;                     ///< which step of the tour is shown; 0: none

private:
    void keep(const Line& line, const Outcome& outcome);
    void follow(const Line& line);

    Editor& m_editor;
    std::deque<Message> m_messages;
    uint64_t m_version = 1;
    uint64_t m_warnedVersion = 0;  ///< for which mayClose() has said what would be lost
    double m_due = 0.0;
    bool m_isPreviewing = false;
};

/// How commands name a body or a shape: by its name, or its body's, where that is one object's alone; else by its
/// handle.
std::string referenceTo(const rubble::World& world, uint64_t handle);
/// A handle as commands take it.
std::string handleText(uint64_t handle);
/// Numbers as commands take them: "x,y,z", rounded to a ten-thousandth.
std::string pointText(glm::dvec3 point);
/// The same of one number.
std::string numberText(double number);
/// A cell as commands take it.
std::string cellText(glm::ivec3 cell);

}  // namespace editor
