#include "editor/core/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "editor/core/arguments.h"

extern char** environ;

namespace editor {
namespace {

using Clock = std::chrono::steady_clock;
constexpr size_t kMaxOutput = 1 << 20;

/// Its process id; or -errno. What it prints goes into a pipe.
pid_t spawn(const std::vector<std::string>& command, int writeEnd) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, writeEnd, 1);
    posix_spawn_file_actions_adddup2(&actions, writeEnd, 2);
    pid_t child = 0;
    const int code = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return code ? -code : child;
}

/// Reads until the other end closes; false: time ran out.
bool readAll(int readEnd, Clock::time_point end, std::string& output) {
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        pollfd waiting{readEnd, POLLIN, 0};
        if (poll(&waiting, 1, int(std::min<int64_t>(left, 1000))) <= 0) continue;
        char buffer[4096];
        const ssize_t got = read(readEnd, buffer, sizeof buffer);
        if (got == 0 || (got < 0 && errno != EINTR)) return true;
        if (got > 0 && output.size() < kMaxOutput) output.append(buffer, size_t(got));
    }
}

}  // namespace

ChildResult runChild(const std::vector<std::string>& command, int seconds) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {false, "", fmt::format("no pipe for it: {}", std::strerror(errno))};
    const pid_t child = spawn(command, ends[1]);
    close(ends[1]);
    ChildResult result;
    const bool isInTime = child > 0 && readAll(ends[0], Clock::now() + std::chrono::seconds(seconds), result.output);
    close(ends[0]);
    if (child < 0) return {false, "", fmt::format("cannot start it: {}", std::strerror(-child))};
    if (!isInTime) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    result.isDone = isInTime && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!isInTime)
        result.end = fmt::format("stopped after {} s", seconds);
    else if (WIFSIGNALED(status))
        result.end = fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
    else if (!result.isDone)
        result.end = fmt::format("ended with code {}", WEXITSTATUS(status));
    return result;
}

ScratchFolder::ScratchFolder() {
    const char* chosen = std::getenv("TMPDIR");
    std::string pattern = fmt::format("{}/rubble-editor-XXXXXX", chosen && *chosen ? chosen : "/tmp");
    if (!mkdtemp(pattern.data()))
        throw Refused(fmt::format("{}: no temporary folder (TMPDIR says where): {}", pattern, std::strerror(errno)));
    m_path = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code code;
    std::filesystem::remove_all(m_path, code);
}

}  // namespace editor
