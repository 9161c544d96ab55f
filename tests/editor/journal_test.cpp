// What a crash leaves: the journal brings it back, whatever was going on.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/editor/editor_level.h"
#include "tests/editor/random_commands.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

/// An editor with its journal, whose process is gone without a word: what it left on the disk is copied.
class Crashed {
public:
    Crashed() : m_editor({.journals = m_folder / "journals"}) {}
    Editor& editor() { return m_editor; }
    /// The folder of journals as it is now.
    std::string copy() {
        const std::string to = m_folder / fmt::format("copy-{}", ++m_copies);
        fs::copy(m_folder / "journals", to, fs::copy_options::recursive);
        return to;
    }
    std::string file(const char* name) const { return m_folder / name; }

private:
    rubble::TempFolder m_folder;
    Editor m_editor;
    int m_copies = 0;
};

TEST(Journal, BringsBackWhatWasNotSaved) {
    Crashed crashed;
    makeTestLevel(crashed.editor());
    runAll(crashed.editor(), {"move 0,1,0 crate", "undo", "sphere 20,12,1 5 erase shape=wall"});
    const uint64_t hash = crashed.editor().document().hash();
    Editor again({.journals = crashed.copy()});
    ASSERT_TRUE(again.document().recovery());
    EXPECT_NE(again.document().hash(), hash);
    const Outcome refused = again.run(std::string("create 4,4,4"));
    EXPECT_FALSE(refused.isDone);
    EXPECT_NE(refused.text.find("expected recover or discard first"), refused.text.npos) << refused.text;
    runAll(again, {"recover"});
    EXPECT_EQ(again.document().hash(), hash);
    EXPECT_TRUE(again.document().isChanged());
    EXPECT_FALSE(again.document().recovery());
    runAll(again, {"create 4,4,4", "undo"});
    EXPECT_EQ(again.document().hash(), hash);
}

TEST(Journal, ComesBackToBeforeAPlayThatHadNotEndedAndKeepsOneThatHad) {
    Crashed crashed;
    makeTestLevel(crashed.editor());
    const uint64_t before = crashed.editor().document().hash();
    runAll(crashed.editor(), {"play", "explode 0,1,2 2", "step 20"});
    Editor first({.journals = crashed.copy()});
    runAll(first, {"recover"});
    EXPECT_EQ(first.document().hash(), before);
    runAll(crashed.editor(), {"stop", "move 0,1,0 crate", "play", "explode 0,1,2 2", "step 20", "keep"});
    const uint64_t ruin = crashed.editor().document().hash();
    Editor second({.journals = crashed.copy()});
    runAll(second, {"recover"});
    EXPECT_EQ(second.document().hash(), ruin);
}

TEST(Journal, CountsWhatComesBack) {
    Crashed crashed;
    const auto changes = [&] {
        return Editor({.journals = crashed.copy()}).document().recovery().value_or(Recovery{}).changes;
    };
    runAll(crashed.editor(), {"play", "step 3", "stop"});
    EXPECT_EQ(changes(), 0u);
    runAll(crashed.editor(), {"create 4,4,4 0,2,0 name=crate", "play", "step 30"});
    EXPECT_EQ(changes(), 1u) << "a play that has not ended is left out";
    runAll(crashed.editor(), {"stop"});
    EXPECT_EQ(changes(), 1u);
    runAll(crashed.editor(), {"play", "step 30", "keep", "move 1,0,0 crate"});
    EXPECT_EQ(changes(), 3u) << "one that was kept is a step of the history";
}

TEST(Journal, BelongsToALevelAndBeginsAgainWhenItIsSaved) {
    Crashed crashed;
    const std::string file = crashed.file("level.rubble");
    runAll(crashed.editor(), {"create 8,8,8 name=crate", ("save " + file).c_str()});
    EXPECT_FALSE(Editor({.journals = crashed.copy()}).document().recovery()) << "all is saved";
    runAll(crashed.editor(), {"move 0,1,0 crate"});
    const uint64_t hash = crashed.editor().document().hash();
    const std::string copy = crashed.copy();
    Editor again({.journals = copy});
    EXPECT_FALSE(again.document().recovery()) << "that is another level";
    const Outcome opened = again.run("open " + file);
    EXPECT_NE(opened.text.find("left 1 change of " + file), opened.text.npos) << opened.text;
    runAll(again, {"recover"});
    EXPECT_EQ(again.document().hash(), hash);
    EXPECT_EQ(again.document().path(), file);
    EXPECT_FALSE(again.document().hasFileChanged());
    runAll(again, {"save"});
    EXPECT_FALSE(again.document().isChanged());
}

TEST(Journal, IsGoneAfterACleanEndAndADiscard) {
    rubble::TempFolder folder;
    const std::string journals = folder / "journals";
    {
        Editor editor({.journals = journals});
        runAll(editor, {"create 4,4,4"});
        EXPECT_FALSE(fs::is_empty(journals));
    }
    EXPECT_TRUE(fs::is_empty(journals));
    Crashed crashed;
    runAll(crashed.editor(), {"create 4,4,4"});
    const std::string copy = crashed.copy();
    {
        Editor again({.journals = copy});
        runAll(again, {"discard", "create 3,3,3"});
    }
    EXPECT_TRUE(fs::is_empty(copy));
}

TEST(Journal, IsKeptUntilItsChangesAreSavedOrDiscarded) {
    Crashed crashed;
    const std::string file = crashed.file("level.rubble");
    runAll(crashed.editor(), {"create 4,4,4 name=crate", ("save " + file).c_str(), "move 0,1,0 crate"});
    const uint64_t hash = crashed.editor().document().hash();
    const std::string copy = crashed.copy();
    {
        Editor again({.journals = copy});
        const Outcome opened = again.run("open " + file), saved = again.run(std::string("save"));
        EXPECT_NE(opened.text.find("left 1 change of"), opened.text.npos) << opened.text;
        EXPECT_FALSE(saved.isDone);
        EXPECT_NE(saved.text.find("save: expected recover or discard first"), saved.text.npos) << saved.text;
    }
    {
        Editor again({.journals = copy});
        runAll(again, {("open " + file).c_str(), "recover"});
        EXPECT_FALSE(again.run(std::string("undo")).isDone);
    }
    Editor again({.journals = copy});
    runAll(again, {("open " + file).c_str(), "recover"});
    EXPECT_EQ(again.document().hash(), hash);
    runAll(again, {"save"});
    EXPECT_FALSE(again.document().recovery());
}

TEST(Journal, OfALevelWithoutAFileIsSettledByASaveToOne) {
    Crashed crashed;
    runAll(crashed.editor(), {"create 4,4,4 name=crate"});
    const std::string copy = crashed.copy(), file = crashed.file("level.rubble");
    {
        Editor again({.journals = copy});
        runAll(again, {"recover", ("save " + file).c_str()});
    }
    EXPECT_FALSE(Editor({.journals = copy}).document().recovery());
    EXPECT_TRUE(fs::is_empty(copy));
}

TEST(Journal, BringsALevelBackWhoseFileIsGoneOrBroken) {
    for (const bool isGone : {true, false}) {
        Crashed crashed;
        const std::string file = crashed.file("level.rubble"), open = "open " + file;
        runAll(crashed.editor(), {"create 4,4,4 name=crate", ("save " + file).c_str(), "move 0,1,0 crate"});
        const uint64_t hash = crashed.editor().document().hash();
        const std::string copy = crashed.copy(), other = crashed.copy();
        isGone ? void(fs::remove(file)) : fs::resize_file(file, 20);
        EXPECT_FALSE(Editor().run(open).isDone);
        Editor again({.journals = copy}), discarding({.journals = other});
        const Outcome opened = again.run(open);
        ASSERT_TRUE(opened.isDone) << opened.text;
        EXPECT_NE(opened.text.find("the level is empty until it is recovered"), opened.text.npos) << opened.text;
        EXPECT_NE(opened.text.find("left 1 change of " + file), opened.text.npos) << opened.text;
        EXPECT_FALSE(again.run(std::string("create 4,4,4")).isDone);
        runAll(again, {"recover"});
        EXPECT_EQ(again.document().hash(), hash);
        runAll(again, {"save force=yes"});
        EXPECT_EQ(again.document().path(), file);
        isGone ? void(fs::remove(file)) : fs::resize_file(file, 20);
        runAll(discarding, {open.c_str(), "discard"});
        EXPECT_EQ(discarding.document().path(), "") << "an empty level takes the place of none";
        EXPECT_FALSE(discarding.run(open).isDone);
    }
}

TEST(Journal, OfAnotherLevelIsNotSettledUnaskedByASaveInItsPlace) {
    Crashed crashed;
    const std::string file = crashed.file("level.rubble"), save = "save " + file;
    runAll(crashed.editor(), {"create 4,4,4 name=crate", save.c_str(), "move 0,1,0 crate"});
    Editor other({.journals = crashed.copy()});
    runAll(other, {"create 9,9,9"});
    const Outcome refused = other.run(save);
    EXPECT_FALSE(refused.isDone);
    EXPECT_NE(refused.text.find("left changes that were not saved"), refused.text.npos) << refused.text;
    const Outcome forced = other.run(save + " force=yes");
    EXPECT_TRUE(forced.isDone);
    EXPECT_EQ(forced.text, "saved " + file);
    EXPECT_FALSE(other.document().recovery());
}

TEST(Journal, RemembersTheFileThatItsChangesAreOf) {
    Crashed crashed;
    const std::string file = crashed.file("level.rubble");
    runAll(crashed.editor(), {"create 4,4,4 name=crate", ("save " + file).c_str(), "move 0,1,0 crate"});
    const std::string copy = crashed.copy();
    Editor other, again({.journals = copy});
    runAll(other, {"create 9,9,9", ("save " + file).c_str()});
    runAll(again, {("open " + file).c_str(), "recover"});
    EXPECT_TRUE(again.document().hasFileChanged());
    EXPECT_FALSE(again.run(std::string("save")).isDone);
    runAll(again, {"save force=yes"});
}

TEST(Journal, SaysThatItCannotBeRead) {
    Crashed crashed;
    runAll(crashed.editor(), {"create 4,4,4 name=crate", "move 0,1,0 crate"});
    const std::string copy = crashed.copy(), changes = copy + "/untitled/changes-1";
    std::ofstream(changes, std::ios::binary) << std::string(300, 'x');
    Editor again({.journals = copy});
    ASSERT_TRUE(again.document().recovery());
    EXPECT_TRUE(again.document().recovery()->isTailLost);
    EXPECT_EQ(again.document().recovery()->changes, 0u);
    EXPECT_FALSE(again.run(std::string("create 3,3,3")).isDone);
    runAll(again, {"recover"});
    EXPECT_TRUE(again.world().get_objects(RUBBLE_KIND_SHAPE).empty()) << "the game that it began with";
}

TEST(Journal, LeavesADamagedEndOut) {
    Crashed crashed;
    runAll(crashed.editor(), {"create 4,4,4 name=crate"});
    const uint64_t hash = crashed.editor().document().hash();
    runAll(crashed.editor(), {"move 0,1,0 crate"});
    const std::string copy = crashed.copy(), changes = copy + "/untitled/changes-1";
    fs::resize_file(changes, fs::file_size(changes) - 3);
    Editor again({.journals = copy});
    ASSERT_TRUE(again.document().recovery());
    const Outcome outcome = again.run(std::string("recover"));
    ASSERT_TRUE(outcome.isDone) << outcome.text;
    EXPECT_NE(outcome.text.find("the end of the journal is damaged"), outcome.text.npos) << outcome.text;
    EXPECT_EQ(again.document().hash(), hash);
}

TEST(Journal, AnotherEditorOfTheSameLevelHasNone) {
    Crashed crashed;
    const std::string file = crashed.file("level.rubble"), journals = crashed.file("journals");
    runAll(crashed.editor(), {"create 4,4,4 name=crate", ("save " + file).c_str()});
    Editor other({.journals = journals});
    const Outcome opened = other.run("open " + file);
    EXPECT_TRUE(opened.isDone);
    EXPECT_NE(opened.text.find("another editor has this level open"), opened.text.npos) << opened.text;
    runAll(other, {"move 0,1,0 crate"});
}

TEST(Journal, OfTooManyNewLevelsSaysWhatIsLost) {
    rubble::TempFolder folder;
    const std::string journals = folder / "journals";
    std::vector<std::unique_ptr<Editor>> editors;
    for (int i = 0; i < 8; ++i) editors.push_back(std::make_unique<Editor>(EditorSettings{.journals = journals}));
    Editor last({.journals = journals});
    const Outcome outcome = last.run(std::string("create 4,4,4"));
    EXPECT_NE(outcome.text.find("a crash would lose this new level until it is saved"), outcome.text.npos)
        << outcome.text;
}

TEST(Journal, AFileThatAnotherProgramHasWrittenIsNotOverwrittenUnasked) {
    rubble::TempFolder folder;
    const std::string file = folder / "level.rubble";
    Editor editor, other;
    runAll(editor, {"create 4,4,4 name=crate", ("save " + file).c_str()});
    EXPECT_FALSE(editor.document().hasFileChanged());
    runAll(other, {("open " + file).c_str(), "create 9,9,9 3,0,0", "save"});
    EXPECT_TRUE(editor.document().hasFileChanged());
    runAll(editor, {"move 0,1,0 crate"});
    const Outcome outcome = editor.run(std::string("save"));
    EXPECT_FALSE(outcome.isDone);
    EXPECT_NE(outcome.text.find("has been written by another program"), outcome.text.npos) << outcome.text;
    runAll(editor, {"save force=yes", "save"});
    Editor forced({.isForced = true});
    runAll(forced, {("open " + file).c_str(), "create 4,4,4"});
    runAll(other, {"create 3,3,3 6,0,0", "save force=yes"});
    runAll(forced, {"save"});
}

/// The program, fed with lines; what it says comes back.
class Program {
public:
    explicit Program(const std::string& journals) {
        int to[2], from[2];
        if (pipe2(to, O_CLOEXEC) != 0 || pipe2(from, O_CLOEXEC) != 0) std::abort();
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, to[0], 0);
        posix_spawn_file_actions_adddup2(&actions, from[1], 1);
        std::string program = RUBBLE_EDITOR_PROGRAM, option = "--journal", folder = journals, script = "--script=-";
        char* arguments[] = {program.data(), option.data(), folder.data(), script.data(), nullptr};
        if (posix_spawn(&m_process, program.c_str(), &actions, nullptr, arguments, environ) != 0) std::abort();
        posix_spawn_file_actions_destroy(&actions);
        close(to[0]);
        close(from[1]);
        m_to = to[1], m_from = from[0];
    }
    ~Program() {
        close(m_to);
        close(m_from);
    }
    /// Sends lines, waits until so many hashes were told, and kills it. Returns how many were told in all.
    size_t runAndKill(const std::string& lines, size_t hashes) {
        if (write(m_to, lines.data(), lines.size()) != ssize_t(lines.size())) std::abort();
        while (countHashes() < hashes && readMore()) {
        }
        ::kill(m_process, SIGKILL);
        waitpid(m_process, nullptr, 0);
        while (readMore()) {
        }
        return countHashes();
    }

private:
    bool readMore() {
        char part[4096];
        const ssize_t size = read(m_from, part, sizeof part);
        if (size > 0) m_said.append(part, size_t(size));
        return size > 0;
    }
    size_t countHashes() const {
        size_t count = 0;
        std::istringstream words(m_said);
        for (std::string word; words >> word;)
            count += word.size() == 16 && word.find_first_not_of("0123456789abcdef") == word.npos;
        return count;
    }

    std::string m_said;
    pid_t m_process = 0;
    int m_to = -1, m_from = -1;
};

/// Lines, each of which works, with what the level's hash is after each; of a play the hash before it.
struct Session {
    std::vector<std::string> lines;
    std::vector<uint64_t> hashes;
};

Session makeSession(uint32_t seed) {
    Session out;
    RandomCommands commands(seed);
    Editor editor;
    const auto add = [&](const std::string& line) {
        if (!editor.run(line).isDone) return;
        out.lines.push_back(line);
        const bool isPlaying = editor.document().isPlaying();
        out.hashes.push_back(isPlaying && !out.hashes.empty() ? out.hashes.back() : editor.document().hash());
    };
    for (const std::string& line : RandomCommands::first()) add(line);
    for (int i = 0; i < 60; ++i) {
        if (i % 20 == 10) {
            for (const char* line : {"play", "explode 0,0.5,0 1", "step 3", "stop"}) add(line);
        } else if (i % 7 == 3) {
            add("undo");
        } else {
            add(commands.next());
        }
    }
    return out;
}

/// kill -9 at random places: no change is lost that the editor had told of, because it is with the system before.
TEST(Journal, WhatIsKilledAtARandomPlaceComesBack) {
    const int kills = std::getenv("RUBBLE_LONG") ? 200 : 3;
    std::mt19937 random(9);
    Session session;
    int recovered = 0;
    for (int i = 0; i < kills; ++i) {
        if (i % 20 == 0) session = makeSession(uint32_t(random()));
        rubble::TempFolder folder;
        const std::string journals = folder / "journals";
        std::string all;
        for (const std::string& line : session.lines) all += line + "\nhash\n";
        std::vector<uint64_t> states{Editor().document().hash()};
        states.insert(states.end(), session.hashes.begin(), session.hashes.end());
        const size_t told = Program(journals).runAndKill(all, random() % states.size());
        if (!fs::exists(journals)) continue;  // killed before it began
        Editor again({.journals = journals});
        if (again.document().recovery()) {
            const Outcome outcome = again.run(std::string("recover"));
            ASSERT_TRUE(outcome.isDone) << outcome.text;
            ++recovered;
        }
        const uint64_t found = again.document().hash();
        const bool isIn = found == states.at(told) || (told + 1 < states.size() && found == states[told + 1]);
        ASSERT_TRUE(isIn) << "kill " << i << " after " << told
                          << " lines: " << (told ? session.lines[told - 1] : "none");
    }
    EXPECT_GT(recovered, kills / 4);
}

}  // namespace
}  // namespace editor
