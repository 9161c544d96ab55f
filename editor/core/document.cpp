#include "editor/core/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "editor/core/arguments.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

constexpr uint32_t kMarks = 1'000'000;  ///< of undo: bricks are shared, so that their number is no measure of memory
constexpr uint64_t kStepsOfMark = 30;   ///< of play, from mark to mark

rubble_world_settings worldSettings(uint32_t flags, std::vector<std::string>& messages) {
    rubble_world_settings settings{};
    settings.flags = flags;
    settings.user = &messages;
    settings.log = [](void* user, int32_t level, const char* message) {
        if (level != RUBBLE_LOG_INFO) static_cast<std::vector<std::string>*>(user)->emplace_back(message);
    };
    return settings;
}

/// The lines as one.
std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += (all.empty() ? "" : "; ") + line;
    return all;
}

/// For people.
std::string describe(const Recovery& found) {
    return fmt::format("an editor that has ended early left {} of {} that {} not saved: recover or discard{}",
                       rubble::counted(found.changes, "change"),
                       found.level.path.empty() ? "a level without a file" : found.level.path,
                       found.changes == 1 ? "was" : "were",
                       found.isTailLost ? "; its journal is damaged, and what came later is lost" : "");
}

}  // namespace

Document::Document(uint32_t worldFlags, std::string journals, StepWatcher watcher)
    : m_world(worldSettings(worldFlags, m_messages)),
      m_hostSettings(m_world.get_settings()),
      m_journals(std::move(journals)),
      m_watcher(std::move(watcher)) {
    begin("");
}

/// A world that has just been made or loaded.
void Document::begin(const std::string& path) {
    m_path = path;
    m_fileState = fileStateOf(path);
    m_isUnread = false;
    beginHistory();
    openJournal();
}

void Document::beginHistory() {
    m_done.clear(), m_doneMarks.clear();
    m_undone.clear(), m_undoneMarks.clear();
    m_isPlaying = false;
    m_world.set_undo_limit(kMarks);
    m_world.apply_edits();
    m_savedSteps = 0;
}

void Document::makeEmpty() {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World empty(settings);
    const std::vector<uint8_t> game = empty.save_game_data();
    m_world.load_game_data(game.data(), game.size());
}

void Document::clear() {
    makeEmpty();
    begin("");
}

void Document::load(const std::string& path, const std::string& vdbTool) {
    bool isRead = true;
    try {
        m_world.load_level(path.c_str(), vdbTool.c_str());
        m_world.set_settings(m_hostSettings);
    } catch (const rubble::Error& error) {
        if (!hasRecovery(path)) throw;
        isRead = false;
        m_messages.push_back(fmt::format("{}: the level is empty until it is recovered", error.what()));
        makeEmpty();
    }
    begin(path);
    m_isUnread = !isRead;
}

/// Whether an editor that has ended early left a journal of a level.
bool Document::hasRecovery(const std::string& path) const {
    const std::string folder = m_journals.empty() ? "" : journalFolder(m_journals, path);
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none)) return false;
    try {
        return Journal(folder).found().has_value();
    } catch (const Refused&) {  // another editor has it
        return false;
    }
}

void Document::save(const std::string& path, const std::string& vdbTool, bool isForced) {
    requireEditing("save");
    requireDecision("save");
    if (path == m_path && !isForced && hasFileChanged())
        throw Refused(
            fmt::format("save: {} has been written by another program since it was opened or saved: expected "
                        "force=yes, or another path",
                        path));
    const bool isMoved = path != m_path;
    if (isMoved && !isForced && hasRecovery(path))
        throw Refused(
            fmt::format("save: an editor of {} that has ended early left changes that were not saved: expected "
                        "another path, or force=yes, which discards them",
                        path));
    m_world.save_level(path.c_str(), vdbTool.c_str());
    m_path = path;
    m_fileState = fileStateOf(path);
    m_savedSteps = m_done.size();
    if (!isMoved) return m_journal ? beginJournal() : void();
    if (m_journal) m_journal->discard();  // what it has kept is saved
    openJournal(true);
}

bool Document::hasFileChanged() const {
    const std::optional<FileState> now = fileStateOf(m_path);
    return now && now != m_fileState;
}

void Document::edit(const std::string& name, const std::function<void()>& work) {
    requireEditing("an edit");
    requireDecision("an edit");
    makeStep(name, work);
    keepChanges();
}

void Document::makeStep(const std::string& name, const std::function<void()>& work) {
    const size_t messages = m_messages.size();
    m_world.add_undo_mark();
    try {
        work();
        applyNow();
    } catch (...) {
        m_world.apply_edits();
        takeBack();
        forgetUndone();
        m_messages.resize(messages);  // of what is not there
        throw;
    }
    forgetUndone();
    if (m_world.has_changed()) return m_done.push_back(name), m_doneMarks.push_back(1);
    takeBack();
    if (m_messages.size() == messages) return;
    const std::vector<std::string> reasons(m_messages.begin() + ptrdiff_t(messages), m_messages.end());
    m_messages.resize(messages);
    throw Refused(joined(reasons));
}

bool Document::applyNow(bool mayFail) {
    const size_t messages = m_messages.size();
    m_world.apply_edits();
    if (!mayFail) requireNoRefusals();
    if (m_world.get_refusals().empty()) return true;
    m_messages.resize(messages);
    return false;
}

/// Throws Refused with the reasons of what the world did not make.
void Document::requireNoRefusals() const {
    std::vector<std::string> reasons;
    for (const rubble_refusal& each : m_world.get_refusals()) reasons.emplace_back(each.reason);
    if (!reasons.empty()) throw Refused(joined(reasons));
}

/// After an undo the world is at a mark, which stays that of what comes next: so redo lasts where nothing was queued.
void Document::carryOut(const std::string& name) {
    if (m_undone.empty()) return edit(name, [] {});
    requireEditing("an edit");
    requireDecision("an edit");
    const size_t messages = m_messages.size();
    m_world.apply_edits();
    if (!m_world.has_changed()) return requireNoRefusals();
    forgetUndone();
    try {
        requireNoRefusals();
    } catch (...) {
        takeBack();
        m_messages.resize(messages);
        throw;
    }
    m_done.push_back(name), m_doneMarks.push_back(1);
    keepChanges();
}

/// What is done next has no redo.
void Document::forgetUndone() {
    m_undone.clear(), m_undoneMarks.clear();
    if (m_savedSteps > m_done.size()) m_savedSteps.reset();
}

/// To the last mark, or one of those before it.
void Document::takeBack(size_t marks) {
    for (; marks > 0; --marks) {
        m_world.undo();
        m_world.apply_edits();
    }
}

/// The last one of a list of steps becomes the last one of the other.
void Document::moveStep(bool isUndone) {
    auto &from = isUndone ? m_done : m_undone, &to = isUndone ? m_undone : m_done;
    auto &fromMarks = isUndone ? m_doneMarks : m_undoneMarks, &toMarks = isUndone ? m_undoneMarks : m_doneMarks;
    to.push_back(std::move(from.back())), from.pop_back();
    toMarks.push_back(fromMarks.back()), fromMarks.pop_back();
}

void Document::undo() {
    requireEditing("undo");
    if (m_done.empty()) throw Refused("undo: there is no step to take back");
    takeBack(m_doneMarks.back());
    moveStep(true);
    keepChanges();
}

void Document::redo() {
    requireEditing("redo");
    if (m_undone.empty()) throw Refused("redo: there is no undo to take back");
    for (size_t marks = m_undoneMarks.back(); marks > 0; --marks) {
        m_world.redo();
        m_world.apply_edits();
    }
    moveStep(false);
    keepChanges();
}

void Document::play(bool wakes) {
    requireEditing("play");
    requireDecision("play");
    m_world.add_undo_mark();
    if (wakes) wakeAll();
    m_world.apply_edits();
    forgetUndone();
    keepInJournal([](Journal& journal) { journal.beginPlay(); });
    keepChanges();
    m_isPlaying = true;
    m_playedSteps = 0;
    m_playMarks = {0};
    keepDeltas();
}

void Document::wakeAll() {
    for (const rubble_body_state& body : m_world.get_body_states()) {
        if (body.flags & RUBBLE_BODY_STATIC) continue;
        rubble_body_change change{};
        change.body = body.body;
        change.fields = RUBBLE_SET_AWAKE;
        m_world.set_body(change);
    }
}

void Document::step(const std::function<void()>& take) {
    requirePlaying("step");
    take ? take() : m_world.step();
    ++m_playedSteps;
    keepChanges(true);
    if (m_playedSteps % kStepsOfMark != 0 || !m_world.has_changed()) return;
    m_world.add_undo_mark();
    m_playMarks.push_back(m_playedSteps);
}

void Document::rewind(uint64_t steps) {
    requirePlaying("rewind");
    const uint64_t to = m_playedSteps - std::min(steps, m_playedSteps);
    const auto kept = std::upper_bound(m_playMarks.begin(), m_playMarks.end(), to) - m_playMarks.begin();
    m_world.apply_edits();  // an undo would come before them
    takeBack(m_playMarks.size() - size_t(kept) + 1);
    m_world.add_undo_mark();  // so that stop() finds it, also where all that comes is motion
    m_world.apply_edits();
    m_playMarks.resize(size_t(kept));
    m_playedSteps = m_playMarks.back();
    keepChanges();
    keepDeltas();
}

void Document::endPlay(bool isKept) {
    m_isPlaying = false;
    keepChanges();
    keepInJournal([=](Journal& journal) { journal.endPlay(isKept); });
    keepDeltas();
}

void Document::stop(bool keeps) {
    requirePlaying(keeps ? "keep" : "stop");
    m_world.apply_edits();  // an undo would come before them
    if (!keeps) takeBack(m_playMarks.size());
    if (keeps && !m_world.has_changed()) {  // the mark of what comes next would take the place of the last one
        takeBack();
        m_playMarks.pop_back();
    }
    endPlay(keeps && !m_playMarks.empty());
    if (m_playMarks.empty()) return;
    (keeps ? m_done : m_undone).push_back(fmt::format("play {} steps", m_playedSteps));
    (keeps ? m_doneMarks : m_undoneMarks).push_back(m_playMarks.size());
}

/// That of the level's file; of a level without one the first that no other editor has. isSaved: the file is the level
/// as it is, so that what is there from before is settled.
void Document::openJournal(bool isSaved) {
    m_journal.reset();
    if (m_journals.empty()) return;
    constexpr int kUntitled = 8;
    const std::string folder = journalFolder(m_journals, m_path);
    for (int i = 1; !m_journal && i <= (m_path.empty() ? kUntitled : 1); ++i) try {
            m_journal = std::make_unique<Journal>(i == 1 ? folder : fmt::format("{}-{}", folder, i));
        } catch (const Refused& error) {
            if (!m_path.empty())
                m_messages.emplace_back(error.what());
            else if (i == kUntitled)
                m_messages.push_back(
                    fmt::format("a crash would lose this new level until it is saved: all {} folders for journals of "
                                "levels without a file are taken; the last says: {}",
                                kUntitled, error.what()));
        }
    if (!m_journal) return keepDeltas();
    const std::optional<Recovery> found = m_journal->found();
    if (isSaved || !found) return beginJournal();
    m_messages.push_back(describe(*found));
}

void Document::beginJournal(size_t recovered) {
    keepDeltas();
    keepInJournal([&](Journal& journal) { journal.begin(m_world, {m_path, m_fileState}, recovered); });
}

/// Goes on without a journal where it cannot be written.
void Document::keepInJournal(const std::function<void(Journal&)>& write) {
    if (!m_journal) return;
    try {
        write(*m_journal);
    } catch (const std::exception& error) {
        m_messages.push_back(fmt::format("{}; from now on a crash loses what is not saved", error.what()));
        m_journal.reset();
        keepDeltas();
    }
}

/// Hands on what the world has done since the last call: to the journal, and a step of play to who watches.
void Document::keepChanges(bool isStep) {
    if (!needsDeltas()) return;
    const std::vector<uint8_t> deltas = m_world.take_deltas();
    if (m_watcher && isStep) m_watcher(deltas);
    keepInJournal([&](Journal& journal) { journal.add(deltas); });
}

bool Document::needsDeltas() const {
    return m_journal || (m_watcher && m_isPlaying);
}

/// The world keeps deltas while somebody takes them; where nobody ever does, they are the host's own.
void Document::keepDeltas() {
    if (m_journals.empty() && !m_watcher) return;
    m_world.keep_deltas(needsDeltas() ? RUBBLE_DELTAS_ALL : RUBBLE_DELTAS_NONE);
}

std::optional<Recovery> Document::recovery() const {
    return m_journal ? m_journal->found() : std::nullopt;
}

void Document::settleRecovery(bool isWanted) {
    const std::optional<Recovery> found = recovery();
    if (!found) throw Refused("expected changes of this level that were not saved, found none");
    if (isWanted) return recover(*found);
    m_journal->discard();
    if (m_isUnread) return clear();
    beginJournal();
}

void Document::recover(const Recovery& found) {
    m_journal->recover(m_world);
    if (!found.level.path.empty()) m_path = found.level.path, m_fileState = found.level.file;
    beginHistory();
    m_savedSteps.reset();
    m_isUnread = false;
    beginJournal(std::max<size_t>(found.changes, 1));
    if (found.isTailLost) m_messages.emplace_back("the end of the journal is damaged: what came later is lost");
}

/// Refuses while it is open what becomes of changes from before a crash.
void Document::requireDecision(const char* what) const {
    if (const std::optional<Recovery> found = recovery())
        throw Refused(fmt::format("{}: expected recover or discard first: {}", what, describe(*found)));
}

std::vector<std::string> Document::takeMessages() {
    return std::exchange(m_messages, {});
}

void Document::requireEditing(const char* what) const {
    if (m_isPlaying)
        throw Refused(fmt::format("{}: expected no play, found one that runs: stop or keep it first", what));
}

void Document::requirePlaying(const char* what) const {
    if (!m_isPlaying) throw Refused(fmt::format("{}: expected play, found none: play first", what));
}

}  // namespace editor
