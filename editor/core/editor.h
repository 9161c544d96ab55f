#pragma once
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/command.h"
#include "editor/core/document.h"
#include "editor/core/selection.h"
#include "editor/core/view_state.h"

namespace editor {

struct EditorSettings {
    uint32_t worldFlags = RUBBLE_WORLD_NO_RENDERER;  ///< RUBBLE_WORLD_...
    std::string vdbTool;                             ///< the program rubble-vdb, for .vdb files
    std::string journals;                            ///< where journals of open levels are kept; empty: none are
    StepWatcher watcher;                             ///< of the steps of play
    /// Writes what the view shows as PNG; an error, or empty. None: there is no view.
    std::function<std::string(const std::string& path)> writeView;
    /// The same of the times of its last frames, as a trace in JSON.
    std::function<std::string(const std::string& path)> writeTrace;
    bool isForced = false;  ///< each save overwrites what another program has written
};

/// What a command came to.
struct Outcome {
    bool isDone = true;
    std::string text;  ///< what it has to say; else what is wrong
};

/// A level, what of it is selected, and commands that work on both: all that the editor does, without its windows.
class Editor {
public:
    /// Begins with an empty level.
    explicit Editor(EditorSettings settings = {});

    /// Runs a line: a command with its values, see readLine(). An empty line and a comment, which begins with '--', do
    /// nothing. What is wrong is told and has changed nothing.
    Outcome run(const std::string& line);
    /// The same of a line that is taken apart.
    Outcome run(const Line& line);
    /// Runs a file: lines of commands, or Lua if its name ends in .lua. It ends at the first line that fails. The
    /// outcome is all that its lines had to say, and last what is wrong, with the line's number.
    Outcome runFile(const std::string& path);
    /// Runs a script in Lua, as one or more steps of the history: Command("name", {parameter = value, ...}), and all
    /// functions of docs/scripting.
    Outcome runLua(const std::string& name, const std::string& text);

    /// The level.
    Document& document() { return m_document; }
    /// Its world.
    rubble::World& world() { return m_document.world(); }
    /// What is selected.
    Selection& selection() { return m_selection; }
    /// What the view shows.
    ViewState& view() { return m_view; }
    /// The same, to read.
    const ViewState& view() const { return m_view; }
    /// Another level has come: forgets what was selected and hidden.
    void forgetObjects();
    /// Cells that were copied.
    Clipboard& clipboard() { return m_clipboard; }
    /// As they were given.
    const EditorSettings& settings() const { return m_settings; }
    /// Adds a line to what the command that runs has to say.
    void say(const std::string& line);
    /// Gives an object the name that the parameter "name" says, if it says one. Throws Refused of one by which commands
    /// could not find it.
    void giveName(const Arguments& arguments, uint64_t object);
    /// Forgets what is gone of what is selected or hidden; in play only of the former, because stop brings it back.
    void dropStale();

    /// The objects that a parameter of Type::Objects names, of these kinds (RUBBLE_KIND_...): a body stands for its
    /// shapes, and a shape for its body, where only the other kind is wanted. Throws Refused where there are none.
    std::vector<uint64_t> objects(const Arguments& arguments, std::string_view parameter,
                                  std::initializer_list<uint32_t> kinds) const;
    /// The same where one is wanted: throws Refused of several.
    uint64_t object(const Arguments& arguments, std::string_view parameter,
                    std::initializer_list<uint32_t> kinds) const;

private:
    void runCommand(const Command& command, const Line& line);
    Outcome runLines(const std::string& path);
    /// What a part of a value names that a command does not take.
    std::string foundInstead(const std::string& part) const;
    std::string partAt(const std::string& text, size_t begin, std::initializer_list<uint32_t> kinds) const;
    std::vector<uint64_t> objectsOf(const std::string& part, std::initializer_list<uint32_t> kinds) const;

    EditorSettings m_settings;
    Document m_document;
    Selection m_selection;
    ViewState m_view;
    Clipboard m_clipboard;
    std::string m_said;
    int m_openFiles = 0;  ///< of scripts that run, each within the one before
};

/// The tag of objects that edits leave alone, but for unlock.
inline constexpr const char* kLockedTag = "locked";

/// The tag whose value is the layer of an object.
inline constexpr const char* kLayerTag = "layer";

/// Whether edits leave an object alone: it, or the body of a shape, is locked.
bool isLocked(const rubble::World& world, uint64_t object);
/// The kind of a living object, RUBBLE_KIND_...; -1: the handle names nothing.
int kindOf(const rubble::World& world, uint64_t handle);
/// The name of a kind, for people.
const char* nameOfKind(uint32_t kind);
/// The name of an object; empty: it has none.
std::string nameOf(const rubble::World& world, uint64_t handle);
/// How messages name an object: a shape without a name by that of its body, else #HANDLE, as commands take it.
std::string shownName(const rubble::World& world, uint64_t object);

}  // namespace editor
