#include "editor/ui/state/model_watch.h"

#include <algorithm>
#include <vector>

#include "editor/core/models.h"

namespace editor {
namespace {

constexpr double kBetweenLooks = 0.35;  ///< seconds

}  // namespace

/// A file counts as known in the state in which it is found first.
void ModelWatch::findFiles(Session& session) {
    if (session.version() == m_version) return;
    const Document& document = session.editor().document();
    m_version = session.version();
    if (document.path() != m_level) m_files.clear();
    m_level = document.path();
    const std::vector<std::string> files = linkedFiles(document.world());
    std::erase_if(m_files, [&](const auto& each) { return std::ranges::find(files, each.first) == files.end(); });
    for (const std::string& file : files)
        if (const auto [at, isNew] = m_files.try_emplace(file); isNew)
            at->second.settled = at->second.last = fileStateOf(modelPath(document, file));
}

bool ModelWatch::poll(Session& session, double seconds) {
    const Document& document = session.editor().document();
    if (seconds < m_next || document.isPlaying()) return false;
    m_next = seconds + kBetweenLooks;
    findFiles(session);
    bool hasDone = false;
    for (auto& [file, seen] : m_files) {
        const std::optional<FileState> now = fileStateOf(modelPath(document, file));
        const bool standsStill = now == seen.last;
        seen.last = now;
        if (!standsStill || now == seen.settled) continue;
        seen.settled = now;
        hasDone = true;
        if (now)
            session.run("reload_models", {{"file", file}});
        else
            session.say(Message::Kind::Error, file + " is gone: what came from it stays as it is");
    }
    return hasDone;
}

}  // namespace editor
