#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// What the program rubble-vdb printed, and how it ended. None of it is trusted: the program may have crashed, or be
/// another one.
class VdbReply {
public:
    /// Takes over the next bytes that it printed. Of many the first and the last are kept, where its error is.
    void append(std::string_view bytes);
    /// It ended with a status as waitpid() gives it. Without one, as a host gets that ignores SIGCHLD, the file that
    /// the program should have written decides.
    void end(int status) { m_status = status; }
    /// It was stopped after so many seconds.
    void stop(uint64_t seconds) { m_seconds = seconds, m_wasStopped = true; }

    /// What it printed; or as an error the message that it printed, or how it ended. Where the middle of the output is
    /// missing, there is a line that says so. `tool`: its name, for messages.
    Result<std::string> result(const std::string& tool) const;

private:
    std::string output() const;
    std::string describeEnd() const;

    std::string m_first, m_last;
    bool m_isCut = false, m_wasStopped = false;
    int m_status = 0;
    uint64_t m_seconds = 0;
};

/// The lines "note: ..." of its output, in UTF-8 without control characters.
std::vector<std::string> notesOf(std::string_view output);

}  // namespace rubble
