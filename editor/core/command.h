#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "editor/core/arguments.h"

namespace editor {

class Editor;

/// What is drawn where no entry of the palette is said: 5, wood.
inline constexpr std::string_view kDefaultEntry = "5";

/// When a command may run, and what becomes of it.
enum class Kind : uint8_t {
    Edit,    ///< changes the level: a step of the history; refused during play
    Tool,    ///< breaks or drives things: during play in its next step, else as Edit
    View,    ///< changes the level nothing: what is selected, which files there are
    Session  ///< undo, play, files: no step of its own
};

/// A command: the one description that the command line, Lua, the palette of commands, tooltips and tests read.
struct Command {
    std::string_view name;     ///< as it is typed
    std::string_view subject;  ///< under which it is listed
    Kind kind;
    std::string_view help;  ///< one line
    std::vector<Parameter> parameters;
    /// Does it. Throws Refused and rubble::Error.
    void (*run)(Editor& editor, const Arguments& arguments);
    /// A call that works in a level as tests make it: see makeTestLevel() of tests/editor.
    std::string_view example = {};
};

/// All commands, by subject.
std::span<const Command> allCommands();
/// The command of a name; null: there is none.
const Command* findCommand(std::string_view name);
/// A name that is much like one of a command, for messages; empty: there is none.
std::string_view similarCommand(std::string_view name);

/// The commands of each subject, in a file of their own in editor/core/commands.
std::vector<Command> voxelCommands();
/// Hollow, trim, resize and what else works on all voxels of a shape.
std::vector<Command> shapeCommands();
/// What a shape is beside its voxels: strength, anchors, parts.
std::vector<Command> shapePropertyCommands();
/// What is selected: objects and cells.
std::vector<Command> selectionCommands();
/// Cells that are selected: copy, cut, paste.
std::vector<Command> clipboardCommands();
/// Bodies: make, duplicate, delete.
std::vector<Command> bodyCommands();
/// Where bodies are and how they move.
std::vector<Command> placementCommands();
/// Entries of palettes, and materials.
std::vector<Command> paletteCommands();
/// What works on whole palettes.
std::vector<Command> paletteToolCommands();
/// What images become.
std::vector<Command> imageCommands();
/// Lights and light groups.
std::vector<Command> lightCommands();
/// Joints and ropes.
std::vector<Command> jointCommands();
/// Shapes that are linked to files.
std::vector<Command> modelCommands();
/// Sky, sun, fog, gravity.
std::vector<Command> environmentCommands();
/// Water and triggers.
std::vector<Command> regionCommands();
/// Names and tags.
std::vector<Command> nameCommands();
/// Scripts that the level names.
std::vector<Command> scriptCommands();
/// What breaks things.
std::vector<Command> toolCommands();
/// What the view shows.
std::vector<Command> viewCommands();
/// Files, undo and redo, play and stop.
std::vector<Command> sessionCommands();
/// What is written for other programs.
std::vector<Command> fileCommands();

}  // namespace editor
