// Files, the history, play.
#include <fmt/format.h>

#include "editor/core/editor.h"
#include "editor/core/models.h"
#include "editor/core/vdb_tool.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

void clear(Editor& editor, const Arguments&) {
    editor.document().clear();
    editor.forgetObjects();
}

/// Says which linked files are not as they were read.
void tellOfModels(Editor& editor) {
    const auto [changed, unreadable] = changedFiles(editor.document());
    if (!changed.empty())
        editor.say(fmt::format("{} read, which reload_models brings in: {}",
                               rubble::counted(changed.size(), "linked file has changed since it was",
                                               "linked files have changed since they were"),
                               listOf(changed)));
    if (!unreadable.empty())
        editor.say(fmt::format("{} be read, so that what came from there stays as it is: {}",
                               rubble::counted(unreadable.size(), "linked file cannot", "linked files cannot"),
                               listOf(unreadable)));
}

void open(Editor& editor, const Arguments& arguments) {
    requireVdbTool(arguments.text("file"), editor.settings().vdbTool);
    editor.document().load(arguments.text("file"), editor.settings().vdbTool);
    editor.forgetObjects();
    tellOfModels(editor);
}

void save(Editor& editor, const Arguments& arguments) {
    const std::string path = arguments.has("file") ? arguments.text("file") : editor.document().path();
    if (path.empty())
        arguments.refuse("file",
                         arguments.has("file") ? "a path, found ''" : "a path, found none: the level has no file yet");
    requireVdbTool(path, editor.settings().vdbTool);
    const bool isForced = arguments.flag("force") || editor.settings().isForced;
    const bool hasMoved = moveLinks(editor.document(), path);
    try {
        editor.document().save(path, editor.settings().vdbTool, isForced);
    } catch (...) {
        if (hasMoved) editor.document().undo();
        throw;
    }
    editor.say("saved " + path);
}

void recover(Editor& editor, const Arguments&) {
    editor.document().settleRecovery(true);
    editor.forgetObjects();
    tellOfModels(editor);
}

void discard(Editor& editor, const Arguments&) {
    editor.document().settleRecovery(false);
}

void runScript(Editor& editor, const Arguments& arguments) {
    const Outcome outcome = editor.runFile(arguments.text("file"));
    if (!outcome.isDone) throw Refused(outcome.text);
    editor.say(outcome.text.substr(0, outcome.text.find_last_not_of('\n') + 1));
}

/// How often something is to be done of which there are so many; one is refused by what does it.
int timesOf(const Arguments& arguments, size_t steps) {
    const int times = arguments.whole("times");
    if (times > 1 && size_t(times) > steps)
        arguments.refuse("times", fmt::format("at most {}, found {}", steps, times));
    return times;
}

void undo(Editor& editor, const Arguments& arguments) {
    const int times = timesOf(arguments, editor.document().done().size());
    for (int i = 0; i < times; ++i) editor.document().undo();
}

void redo(Editor& editor, const Arguments& arguments) {
    const int times = timesOf(arguments, editor.document().undone().size());
    for (int i = 0; i < times; ++i) editor.document().redo();
}

void history(Editor& editor, const Arguments&) {
    size_t number = 0;
    for (const std::string& name : editor.document().done()) editor.say(fmt::format("{:4} {}", ++number, name));
    const std::vector<std::string>& undone = editor.document().undone();
    for (auto name = undone.rbegin(); name != undone.rend(); ++name)
        editor.say(fmt::format("{:4} {} (undone)", ++number, *name));
}

void play(Editor& editor, const Arguments& arguments) {
    editor.document().play(arguments.flag("wake"));
}

void step(Editor& editor, const Arguments& arguments) {
    for (int i = 0; i < arguments.whole("count"); ++i) editor.document().step();
}

void rewind(Editor& editor, const Arguments& arguments) {
    editor.document().rewind(uint64_t(arguments.whole("steps")));
}

void stop(Editor& editor, const Arguments&) {
    editor.document().stop();
}

void keep(Editor& editor, const Arguments&) {
    editor.document().stop(true);
}

void printHash(Editor& editor, const Arguments&) {
    editor.say(fmt::format("{:016x}", editor.document().hash()));
}

}  // namespace

std::vector<Command> sessionCommands() {
    const Parameter times{"times", Type::Whole, "how many steps of the history", "1", 1, 1e6};
    return {
        {"new", "session", Kind::Session, "Begins an empty level.", {}, clear, "new"},
        {"open",
         "session",
         Kind::Session,
         "Opens a level: .rubble, .vox or .vdb.",
         {{"file", Type::Text, "its path", kRequired, 0, 0, ".rubble .vox .vdb"}},
         open,
         "open model.rubble"},
        {"save",
         "session",
         Kind::Session,
         "Writes the level: .rubble, .vdb or .vox.",
         {{"file", Type::Text, "its path; else that of the level", kOptional, 0, 0, ".rubble .vox .vdb"},
          {"force", Type::Flag, "also over a file that another program has written meanwhile", "no"}},
         save,
         "save saved.rubble"},
        {"recover",
         "session",
         Kind::Session,
         "Brings back what was not saved when an editor of this level ended early.",
         {},
         recover,
         "recover"},
        {"discard",
         "session",
         Kind::Session,
         "Forgets what was not saved when an editor of this level ended early.",
         {},
         discard,
         "discard"},
        {"script",
         "session",
         Kind::Session,
         "Runs a file now: lines of commands, or Lua if its name ends in .lua.",
         {{"file", Type::Text, "its path", kRequired, 0, 0, ".txt .lua"}},
         runScript,
         "script commands.txt"},
        {"undo", "session", Kind::Session, "Takes back what was done last.", {times}, undo, "undo"},
        {"redo", "session", Kind::Session, "Takes an undo back.", {times}, redo, "redo"},
        {"history", "session", Kind::View, "Lists what was done.", {}, history, "history"},
        {"play",
         "session",
         Kind::Session,
         "Begins to play from here.",
         {{"wake", Type::Flag, "whether free bodies wake: what hangs in the air falls", "yes"}},
         play,
         "play"},
        {"step",
         "session",
         Kind::Session,
         "Plays steps of 1/60 s.",
         {{"count", Type::Whole, "how many", "1", 1, 1e6}},
         step,
         "step 60"},
        {"rewind",
         "session",
         Kind::Session,
         "Goes back in play, to a half second of it, and on from there.",
         {{"steps", Type::Whole, "by how many of 1/60 s at least", "30", 1, 1e6}},
         rewind,
         "rewind 30"},
        {"stop", "session", Kind::Session, "Ends play: the level is as it was before.", {}, stop, "stop"},
        {"keep", "session", Kind::Session, "Ends play and keeps what became of the level.", {}, keep, "keep"},
        {"hash",
         "session",
         Kind::View,
         "Tells the hash of the level, to which undo, redo and stop return, and which saving and opening keep.",
         {},
         printHash,
         "hash"},
    };
}

}  // namespace editor
