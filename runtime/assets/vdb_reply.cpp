#include "runtime/assets/vdb_reply.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstring>

#include "runtime/assets/names.h"

namespace rubble {
namespace {

// Bytes of the output that are kept at least.
constexpr size_t kMaxFirst = 48 << 10, kMaxLast = 16 << 10;

}  // namespace

void VdbReply::append(std::string_view bytes) {
    const size_t first = std::min(bytes.size(), kMaxFirst - m_first.size());
    m_first.append(bytes.substr(0, first));
    m_last.append(bytes.substr(first));
    if (m_last.size() <= 2 * kMaxLast) return;
    m_last.erase(0, m_last.size() - kMaxLast);
    m_isCut = true;
}

std::string VdbReply::output() const {
    std::string out = m_isCut ? m_first + "\nnote: further notes are left out\n" + m_last : m_first + m_last;
    while (!out.empty() && out.back() == '\n') out.pop_back();
    return out;
}

std::string VdbReply::describeEnd() const {
    if (m_wasStopped) return fmt::format("stopped after {} s (RUBBLE_VDB_SECONDS raises the limit)", m_seconds);
    if (WIFSIGNALED(m_status))
        return fmt::format(
            "killed by signal {} ({}): OpenVDB does not survive this file, which is damaged or hostile; it runs in a "
            "process of its own, so that nothing else is harmed",
            WTERMSIG(m_status), strsignal(WTERMSIG(m_status)));
    return fmt::format("ended with code {}", WEXITSTATUS(m_status));
}

Result<std::string> VdbReply::result(const std::string& tool) const {
    std::string text = output();
    const bool hasEnded = !m_wasStopped && WIFEXITED(m_status);
    if (hasEnded && WEXITSTATUS(m_status) == 0) return text;
    const size_t error = ("\n" + text).rfind("\nerror: ");
    if (hasEnded && error != std::string::npos && error + 7 < text.size())
        return Error{printableText(text.substr(error + 7))};
    return Error{fmt::format("{}: {}{}{}", tool, describeEnd(), text.empty() ? "" : ": ", printableText(text))};
}

std::vector<std::string> notesOf(std::string_view output) {
    constexpr std::string_view kNote = "note: ";
    std::vector<std::string> notes;
    while (!output.empty()) {
        const std::string_view line = output.substr(0, output.find('\n'));
        if (line.starts_with(kNote)) notes.push_back(printableText(line.substr(kNote.size())));
        output.remove_prefix(std::min(output.size(), line.size() + 1));
    }
    return notes;
}

}  // namespace rubble
