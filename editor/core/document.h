#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <rubble/rubble.hpp>
#include <string>
#include <vector>

#include "editor/core/journal.h"

namespace editor {

/// Gets the deltas of a step.
using StepWatcher = std::function<void(const std::vector<uint8_t>& deltas)>;

/// A level that is being edited: a world in which no time passes but in play, its file, and its history.
///
/// Each edit is one mark of the world's own undo: bricks are shared, so that a step of the history costs what it has
/// changed. Play is a step as well: stop() takes it back, to the bit, and redo() after it brings the ruin again.
class Document {
public:
    /// What the world is made with; see rubble_world_settings.
    /// journals: a folder in which journals of levels are kept while they are open; empty: none are.
    /// watcher: gets the deltas of each step of play; see rubble_api::take_deltas().
    explicit Document(uint32_t worldFlags, std::string journals = {}, StepWatcher watcher = {});
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    /// Replaces the level by an empty one without a file.
    void clear();
    /// Replaces the level by that of a file: .rubble, .vox or .vdb. vdbTool: the program rubble-vdb. Throws
    /// rubble::Error, and the level stays; but where its journal can bring it back, it is empty until that is settled.
    void load(const std::string& path, const std::string& vdbTool);
    /// Writes the level as it is, whole or not at all, and takes the path as the level's own. Throws rubble::Error, and
    /// Refused where hasFileChanged(), or another level of that path waits for its recovery, unless it is forced.
    void save(const std::string& path, const std::string& vdbTool, bool isForced = false);
    /// Whether another program has written the level's file since it was loaded or saved.
    bool hasFileChanged() const;
    /// The file of the level; empty: it has none yet.
    const std::string& path() const { return m_path; }
    /// Whether something has changed since it was loaded or saved.
    bool isChanged() const { return m_savedSteps != m_done.size(); }

    /// What the journal holds of this level from an editor that has ended early; none: nothing. Edits are refused until
    /// it is settled.
    std::optional<Recovery> recovery() const;
    /// Makes that the level, without its history, or forgets it. Throws Refused where there is nothing.
    void settleRecovery(bool isWanted);

    /// Its world, to queue edits in work() and to read.
    rubble::World& world() { return m_world; }
    /// The same, to read.
    const rubble::World& world() const { return m_world; }
    /// Equal levels have equal hashes, also after saving and opening. Costs all objects.
    uint64_t hash() const { return m_world.get_level_hash(); }

    /// Runs work(), which queues edits, and carries them out as one step of the history. One that changes nothing is
    /// none. What work() throws, and edits that the world refuses, leave the level as it was; redo ends either way,
    /// because the mark of the step has ended it.
    void edit(const std::string& name, const std::function<void()>& work);
    /// Carries out what is queued, within work(), for those that go on with what it has made.
    /// False: the world has refused some of it, of which no message stays. Throws Refused then, unless it may fail.
    bool applyNow(bool mayFail = false);
    /// Carries out what was queued outside of edit(), as by a script, as one step of the history.
    void carryOut(const std::string& name);
    /// Takes the last step back; throws Refused where there is none.
    void undo();
    /// Takes an undo back; throws Refused where there is none.
    void redo();
    /// The steps that were done, the first one first.
    const std::vector<std::string>& done() const { return m_done; }
    /// Those that were taken back, the last one of the history first.
    const std::vector<std::string>& undone() const { return m_undone; }

    /// Whether time passes.
    bool isPlaying() const { return m_isPlaying; }
    /// Steps that were played since play().
    uint64_t playedSteps() const { return m_playedSteps; }
    /// Begins to play from here. wakes: free bodies wake, so that what hangs in the air falls; else they sleep until
    /// something wakes them, as in a game that has loaded the level.
    void play(bool wakes);
    /// Advances by a step of 1/60 s, with the edits that wait. take() takes the step; without it the world does.
    void step(const std::function<void()>& take = {});
    /// Goes back in play by at least so many steps, to one of the marks that step() sets each half second, and on from
    /// there; all, if there are not so many.
    void rewind(uint64_t steps);
    /// Ends play: the level is as before it, and redo() brings the ruin. keeps: what became of the level stays, as a
    /// step of the history. What was queued in play goes with it.
    void stop(bool keeps = false);

    /// What the world has said since the last call: warnings and errors, a line each.
    std::vector<std::string> takeMessages();

private:
    void makeEmpty();
    void begin(const std::string& path);
    bool hasRecovery(const std::string& path) const;
    void beginHistory();
    void makeStep(const std::string& name, const std::function<void()>& work);
    void endPlay(bool isKept);
    void openJournal(bool isSaved = false);
    void beginJournal(size_t recovered = 0);
    void keepInJournal(const std::function<void(Journal&)>& write);
    void keepChanges(bool isStep = false);
    bool needsDeltas() const;
    void keepDeltas();
    void recover(const Recovery& found);
    void requireDecision(const char* what) const;
    void requireEditing(const char* what) const;
    void requirePlaying(const char* what) const;
    void takeBack(size_t marks = 1);
    void moveStep(bool isUndone);
    void forgetUndone();
    void requireNoRefusals() const;
    void wakeAll();

    std::vector<std::string> m_messages;
    rubble::World m_world;
    rubble_settings m_hostSettings;  ///< of the world as it begins, which no level holds
    std::string m_path, m_journals;
    std::optional<FileState> m_fileState;  ///< as it was loaded or saved
    bool m_isUnread = false;               ///< the file cannot be read: the journal alone has the level
    std::unique_ptr<Journal> m_journal;    ///< null: there is none
    std::vector<std::string> m_done, m_undone;
    std::vector<size_t> m_doneMarks, m_undoneMarks;  ///< how many of the world's marks each of them has
    std::optional<size_t> m_savedSteps = 0;          ///< with how many steps done it is as in its file; none: no longer
    StepWatcher m_watcher;
    bool m_isPlaying = false;
    uint64_t m_playedSteps = 0;
    std::vector<uint64_t> m_playMarks;  ///< the steps of play at which the world has marks, its beginning first
};

}  // namespace editor
