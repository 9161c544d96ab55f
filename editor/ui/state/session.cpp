#include "editor/ui/state/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "editor/core/rotation.h"

namespace editor {
namespace {

constexpr size_t kMaxMessages = 500;
constexpr int kMaxSteps = 4;  ///< of play in one frame

}  // namespace

std::string numberText(double number) {
    const double rounded = std::round(number * 1e4) / 1e4;
    return fmt::format("{}", rounded + 0.0);
}

std::string pointText(glm::dvec3 point) {
    return numberText(point.x) + "," + numberText(point.y) + "," + numberText(point.z);
}

std::string cellText(glm::ivec3 cell) {
    return fmt::format("{},{},{}", cell.x, cell.y, cell.z);
}

std::string referenceTo(const rubble::World& world, uint64_t handle) {
    const auto isPlain = [](const std::string& name) {
        return !name.empty() && name.find_first_of("#,:=\" ") == name.npos && name != "all" && name != "selected" &&
               name != "world";
    };
    const int kind = kindOf(world, handle);
    if (kind != RUBBLE_KIND_BODY && kind != RUBBLE_KIND_SHAPE) return handleText(handle);
    const std::string own = nameOf(world, handle);
    if (isPlain(own) && world.find_by_name(uint32_t(kind), own.c_str()).size() == 1) return own;
    if (kind == RUBBLE_KIND_BODY || !own.empty()) return handleText(handle);
    const rubble_body body = world.get_shape_state(handle).body;
    const std::string name = nameOf(world, body);
    const bool isAlone = isPlain(name) && world.find_by_name(RUBBLE_KIND_SHAPE, name.c_str()).empty() &&
                         world.find_by_name(RUBBLE_KIND_BODY, name.c_str()).size() == 1 &&
                         world.get_objects_of(body, RUBBLE_KIND_SHAPE).size() == 1;
    return isAlone ? name : handleText(handle);
}

std::string handleText(uint64_t handle) {
    return fmt::format("#{}", handle);
}

void Session::say(Message::Kind kind, const std::string& text) {
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        if (end > begin) m_messages.push_back({kind, text.substr(begin, end - begin)});
        begin = end + 1;
    }
    while (m_messages.size() > kMaxMessages) m_messages.pop_front();
    if (kind != Message::Kind::Error) return;
    tabs.bottom = "Messages";
    tabs.isAsked = true;
}

void Session::keep(const Line& line, const Outcome& outcome) {
    ++m_version;
    say(Message::Kind::Call, textOf(line));
    if (!outcome.text.empty()) say(outcome.isDone ? Message::Kind::Answer : Message::Kind::Error, outcome.text);
    if (outcome.isDone) follow(line);
}

/// The replay follows play.
void Session::follow(const Line& line) {
    if (line.command == "play") {
        isPaused = showsReplay = false;
        m_due = 0.0;
        replay.begin(world());
    } else if (line.command == "rewind") {
        showsReplay = false;
        replay.rewind(world(), m_editor.document().playedSteps());
    } else if (!m_editor.document().isPlaying()) {
        replay.end();
    }
}

bool Session::run(const Line& line) {
    m_isPreviewing = false;
    const Outcome outcome = m_editor.run(line);
    keep(line, outcome);
    return outcome.isDone;
}

bool Session::run(const std::string& text) {
    try {
        return run(readLine(text));
    } catch (const std::exception& error) {
        say(Message::Kind::Error, error.what());
        return false;
    }
}

bool Session::run(std::string_view command, std::initializer_list<Given> given) {
    return run(Line{std::string(command), given});
}

void Session::preview(const Line& line) {
    if (m_isPreviewing) m_editor.run(Line{"undo", {}});
    const size_t before = m_editor.document().done().size();
    const Outcome outcome = m_editor.run(line);
    m_isPreviewing = m_editor.document().done().size() > before;
    if (!outcome.isDone) say(Message::Kind::Error, outcome.text);
    ++m_version;
}

void Session::select(uint64_t handle, bool adds) {
    run("select", {{"what", handleText(handle)}, {"more", adds ? "yes" : "no"}});
}

rubble_shape Session::selectedShape() const {
    const rubble::World& all = m_editor.document().world();
    for (const uint64_t each : m_editor.selection().objects) {
        const int kind = kindOf(all, each);
        if (kind == RUBBLE_KIND_SHAPE) return each;
        if (kind != RUBBLE_KIND_BODY) continue;
        const std::vector<uint64_t> shapes = all.get_objects_of(each, RUBBLE_KIND_SHAPE);
        if (!shapes.empty()) return shapes.front();
    }
    return 0;
}

void Session::frameSelection() {
    glm::dvec3 low(1e30), high(-1e30);
    const auto add = [&](const rubble_shape_state& shape) {
        const glm::dquat turn = quaternionOf(shape.rotation);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 cell(corner & 1 ? shape.size[0] : 0, corner & 2 ? shape.size[1] : 0,
                                  corner & 4 ? shape.size[2] : 0);
            const glm::dvec3 at = vectorOf(shape.position) + turn * (cell * shape.voxel_size);
            low = glm::min(low, at), high = glm::max(high, at);
        }
    };
    for (const uint64_t each : m_editor.selection().objects) {
        const int kind = kindOf(world(), each);
        if (kind == RUBBLE_KIND_SHAPE) add(world().get_shape_state(each));
        if (kind == RUBBLE_KIND_BODY)
            for (const rubble_shape_state& shape : world().get_shape_states(each)) add(shape);
    }
    if (low.x > high.x)
        for (const rubble_shape_state& shape : world().get_shape_states(0))
            if (!m_editor.view().hides(shape.shape)) add(shape);
    if (low.x <= high.x) camera.frame((low + high) * 0.5, glm::length(high - low) * 0.5);
}

std::vector<rubble_shape> Session::hiddenShapes(bool isReplay) {
    const std::vector<rubble_shape>& hidden = m_editor.view().hidden;
    if (!isReplay || !replay.world()) return hidden;
    std::vector<rubble_shape> there;
    for (const rubble_shape each : hidden) {
        try {
            there.push_back(replay.world()->translate_handle(each));
        } catch (const rubble::Error&) {  // it is not in this step
        }
    }
    return there;
}

bool Session::mayClose() {
    const Document& document = m_editor.document();
    const bool isUntouched = document.done().empty() && document.undone().empty();  // what was recovered is kept
    if (isUntouched || m_warnedVersion == m_version) return true;
    if (!document.isChanged() && !(document.isPlaying() && !document.done().empty())) return true;
    m_warnedVersion = m_version;
    say(Message::Kind::Error, "The level has changes that are not saved. Close again to lose them, or Ctrl+S.");
    return false;
}

void Session::togglePlay() {
    if (!m_editor.document().isPlaying())
        run("play", {});
    else
        isPaused = !isPaused;
}

void Session::stepOnce() {
    if (!m_editor.document().isPlaying() && !run("play", {})) return;
    isPaused = true;
    const Line line{"step", {}};
    if (m_editor.run(line).isDone) follow(line);
    ++m_version;
}

bool Session::advance(double seconds) {
    if (!m_editor.document().isPlaying() || isPaused) return false;
    m_due = std::min(m_due + seconds * speed * 60.0, double(kMaxSteps));
    const int steps = int(m_due);
    if (steps == 0) return false;
    m_due -= steps;
    const Line line{"step", {}};
    Outcome outcome;
    for (int i = 0; i < steps && outcome.isDone; ++i) {
        outcome = m_editor.run(line);
        if (outcome.isDone) follow(line);
    }
    if (!outcome.text.empty()) say(outcome.isDone ? Message::Kind::Answer : Message::Kind::Error, outcome.text);
    isPaused = !outcome.isDone;
    ++m_version;
    return true;
}

}  // namespace editor
