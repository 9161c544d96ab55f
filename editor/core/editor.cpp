#include "editor/core/editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "runtime/script/sandbox/script_name.h"

namespace editor {
Editor::Editor(EditorSettings settings)
    : m_settings(std::move(settings)), m_document(m_settings.worldFlags, m_settings.journals, m_settings.watcher) {}

Outcome Editor::run(const std::string& text) {
    try {
        const size_t begin = text.find_first_not_of(" \t\r\n");
        if (begin == text.npos || text.compare(begin, 2, "--") == 0) return {};
        return run(readLine(text));
    } catch (const std::exception& error) {
        return {false, error.what()};
    }
}

Outcome Editor::run(const Line& line) {
    const std::string outer = std::exchange(m_said, {});  // of a script that runs this line
    const Selection selected = m_selection;
    Outcome outcome;
    try {
        const Command* command = findCommand(line.command);
        if (!command) {
            const std::string_view like = similarCommand(line.command);
            throw Refused(fmt::format("expected a command, found '{}'{}", line.command,
                                      like.empty() ? "" : fmt::format("; did you mean {}?", like)));
        }
        runCommand(*command, line);
        outcome.text = m_said;
    } catch (const rubble::Error& error) {
        m_selection = selected;
        outcome = {false, line.command + ": " + error.what()};
    } catch (const std::exception& error) {
        m_selection = selected;
        const std::string what = error.what();
        outcome = {false, what.rfind(line.command, 0) == 0 ? what : line.command + ": " + what};
    }
    m_said = outer;
    return outcome;
}

void Editor::runCommand(const Command& command, const Line& line) {
    const Arguments arguments(command, line.given);
    const auto work = [&] { command.run(*this, arguments); };
    const bool isEdit = command.kind == Kind::Edit || (command.kind == Kind::Tool && !m_document.isPlaying());
    if (isEdit)
        m_document.edit(textOf(line), work);
    else
        work();
    dropStale();
    for (const std::string& message : m_document.takeMessages()) say(message);
}

Outcome Editor::runFile(const std::string& path) {
    constexpr int kMaxOpenFiles = 16;
    if (m_openFiles >= kMaxOpenFiles)
        return {false, fmt::format("{}: expected at most {} scripts within each other", path, kMaxOpenFiles)};
    ++m_openFiles;
    const Outcome outcome = runLines(path);
    --m_openFiles;
    return outcome;
}

Outcome Editor::runLines(const std::string& path) {
    std::error_code none;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, none))
        return {false, fmt::format("{}: the file cannot be read", path)};
    std::ostringstream text;
    text << file.rdbuf();
    if (text.view().starts_with("\xef\xbb\xbf")) text.str(text.str().substr(3));  // a byte order mark
    if (rubble::script::hasEnding(path, ".lua")) return runLua(path, text.str());
    std::istringstream lines(text.str());
    std::string all;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const Outcome outcome = run(line);
        if (!outcome.isDone) return {false, fmt::format("{}{}:{}: {}", all, path, number, outcome.text)};
        all += outcome.text + (outcome.text.empty() ? "" : "\n");
    }
    return {true, all};
}

void Editor::say(const std::string& line) {
    m_said += (m_said.empty() ? "" : "\n") + line;
}

void Editor::dropStale() {
    std::erase_if(m_selection.objects, [&](uint64_t each) { return kindOf(world(), each) < 0; });
    if (m_selection.cells.shape && kindOf(world(), m_selection.cells.shape) != RUBBLE_KIND_SHAPE)
        m_selection.cells = {};
    std::vector<rubble_shape>& hidden = m_view.hidden;
    if (hidden.empty() || m_document.isPlaying()) return;
    std::vector<rubble_shape> all = world().get_objects(RUBBLE_KIND_SHAPE);
    std::ranges::sort(all);
    std::erase_if(hidden, [&](rubble_shape each) { return !std::ranges::binary_search(all, each); });
}

void Editor::forgetObjects() {
    m_selection = {};
    m_view.hidden.clear();
}

}  // namespace editor
