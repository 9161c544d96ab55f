#pragma once
#include <map>
#include <optional>
#include <string>

#include "editor/ui/state/session.h"

namespace editor {

/// Looks at the files to which shapes of the level are linked, and reads those again that have changed: each change as
/// one command, once the file stands still. What cannot be read is told once, and changes nothing.
class ModelWatch {
public:
    /// Looks at them, at most three times a second, and not in play. seconds: of a clock that runs on. True: it has
    /// done or said something.
    bool poll(Session& session, double seconds);
    /// Whether there is something to look at.
    bool isWatching() const { return !m_files.empty(); }

private:
    struct Seen {
        std::optional<FileState> settled, last;  ///< what was dealt with, and what the last look has found
    };
    void findFiles(Session& session);

    std::map<std::string, Seen> m_files;
    std::string m_level;  ///< whose they are
    uint64_t m_version = 0;
    double m_next = 0.0;
};

}  // namespace editor
