#include "editor/core/document.h"

#include <fmt/format.h>

#include <utility>

#include "editor/core/arguments.h"

namespace editor {
namespace {

constexpr uint32_t kMarks = 1'000'000;  ///< of undo: bricks are shared, so that their number is no measure of memory

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

}  // namespace

Document::Document(uint32_t worldFlags) : m_world(worldSettings(worldFlags, m_messages)) {
    begin();
}

/// The history of a world that has just been made or loaded.
void Document::begin() {
    m_done.clear();
    m_undone.clear();
    m_isPlaying = false;
    m_world.set_undo_limit(kMarks);
    m_world.apply_edits();
    m_savedHash = hash();
}

void Document::clear() {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World empty(settings);
    const std::vector<uint8_t> game = empty.save_game_data();
    m_world.load_game_data(game.data(), game.size());
    m_path.clear();
    begin();
}

void Document::load(const std::string& path, const std::string& vdbTool) {
    m_world.load_level(path.c_str(), vdbTool.c_str());
    m_path = path;
    begin();
}

void Document::save(const std::string& path, const std::string& vdbTool) {
    requireEditing("save");
    m_world.save_level(path.c_str(), vdbTool.c_str());
    m_path = path;
    m_savedHash = hash();
}

void Document::edit(const std::string& name, const std::function<void()>& work) {
    requireEditing("an edit");
    const uint64_t before = hash();
    const size_t messages = m_messages.size();
    m_world.add_undo_mark();
    try {
        work();
        applyNow();
    } catch (...) {
        m_world.apply_edits();
        takeBack();
        m_undone.clear();
        throw;
    }
    if (hash() != before) {
        m_done.push_back(name);
        m_undone.clear();
        return;
    }
    takeBack();
    m_undone.clear();
    if (m_messages.size() == messages) return;
    const std::vector<std::string> reasons(m_messages.begin() + ptrdiff_t(messages), m_messages.end());
    m_messages.resize(messages);
    throw Refused(joined(reasons));
}

void Document::applyNow() {
    m_world.apply_edits();
    requireNoRefusals();
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
    const uint64_t before = hash();
    m_world.apply_edits();
    if (hash() == before) return requireNoRefusals();
    m_undone.clear();
    try {
        requireNoRefusals();
    } catch (...) {
        takeBack();
        throw;
    }
    m_done.push_back(name);
}

/// To the last mark.
void Document::takeBack() {
    m_world.undo();
    m_world.apply_edits();
}

void Document::undo() {
    requireEditing("undo");
    if (m_done.empty()) throw Refused("undo: there is no step to take back");
    takeBack();
    m_undone.push_back(std::move(m_done.back()));
    m_done.pop_back();
}

void Document::redo() {
    requireEditing("redo");
    if (m_undone.empty()) throw Refused("redo: there is no undo to take back");
    m_world.redo();
    m_world.apply_edits();
    m_done.push_back(std::move(m_undone.back()));
    m_undone.pop_back();
}

void Document::play(bool wakes) {
    requireEditing("play");
    m_hashBeforePlay = hash();
    m_world.add_undo_mark();
    if (wakes) wakeAll();
    m_world.apply_edits();
    m_undone.clear();
    m_isPlaying = true;
    m_playedSteps = 0;
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
}

void Document::stop() {
    requirePlaying("stop");
    m_world.apply_edits();  // an undo would come before them
    takeBack();
    m_isPlaying = false;
    m_undone = {fmt::format("play {} steps", m_playedSteps)};
}

void Document::keep() {
    requirePlaying("keep");
    m_world.apply_edits();
    m_isPlaying = false;
    if (hash() == m_hashBeforePlay) return takeBack();
    m_done.push_back(fmt::format("play {} steps", m_playedSteps));
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
