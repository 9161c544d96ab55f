// Runs the program rubble-vdb as a child process: OpenVDB trusts what it reads, and a damaged file may crash it.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "runtime/assets/assets.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/vdb_reply.h"
#include "runtime/core/log.h"

extern char** environ;

namespace rubble {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A positive number from the environment, or the default.
uint64_t environmentLimit(const char* name, uint64_t fallback) {
    const char* text = std::getenv(name);
    const uint64_t value = text ? std::strtoull(text, nullptr, 10) : 0;
    return value ? value : fallback;
}

/// A new folder that is removed with everything in it when the object is destroyed.
class TemporaryFolder {
public:
    TemporaryFolder() {
        const char* chosen = std::getenv("TMPDIR");
        const fs::path parent = chosen && *chosen ? chosen : "/tmp";
        std::string pattern = (parent / "rubble-XXXXXX").string();
        if (mkdtemp(pattern.data()))
            m_path = pattern;
        else
            m_error = fileError(parent.string(), "cannot make a temporary folder (TMPDIR says where)", errno).text;
    }
    ~TemporaryFolder() {
        std::error_code code;
        if (!m_path.empty()) fs::remove_all(m_path, code);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    /// Without a slash at its end; empty if it could not be made.
    const std::string& path() const { return m_path; }
    /// Why it could not be made.
    const std::string& error() const { return m_error; }

private:
    std::string m_path, m_error;
};

/// Starts a program with its stdout and stderr in a pipe; the process id, or -errno.
pid_t spawnTool(const std::vector<std::string>& command, int writeEnd) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, writeEnd, 1);
    posix_spawn_file_actions_adddup2(&actions, writeEnd, 2);
    pid_t child = 0;
    const int code = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return code ? -code : child;
}

/// Collects output until the other end closes it; false when time runs out first.
bool readUntil(int readEnd, Clock::time_point deadline, VdbReply& reply) {
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        pollfd wait{readEnd, POLLIN, 0};
        const int ready = poll(&wait, 1, int(std::min<int64_t>(left, 1000)));
        if (ready < 0 && errno != EINTR) return true;
        if (ready <= 0) continue;
        char buffer[4096];
        const ssize_t got = read(readEnd, buffer, sizeof buffer);
        if (got == 0 || (got < 0 && errno != EINTR)) return true;
        if (got > 0) reply.append({buffer, size_t(got)});
    }
}

/// Waits for the child and releases it. False if the host ignores SIGCHLD: then there is no status.
bool waitForExit(pid_t child, int& status) {
    pid_t waited;
    do {
        waited = waitpid(child, &status, 0);
    } while (waited < 0 && errno == EINTR);
    return waited >= 0;
}

/// Runs rubble-vdb under limits of memory (environment variable RUBBLE_VDB_MEMORY_MIB, 4096) and time
/// (RUBBLE_VDB_SECONDS, 120). Returns what it printed, or as an error the message that it printed or how it ended.
Result<std::string> runVdbTool(const std::string& tool, const std::vector<std::string>& arguments) {
    const uint64_t seconds = environmentLimit("RUBBLE_VDB_SECONDS", 120);
    std::vector<std::string> command{tool, "--memory-mib",
                                     std::to_string(environmentLimit("RUBBLE_VDB_MEMORY_MIB", 4096)), "--seconds",
                                     std::to_string(seconds)};
    command.insert(command.end(), arguments.begin(), arguments.end());
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return Error{fmt::format("{}: cannot make a pipe for it: {}", tool, std::strerror(errno))};
    const pid_t child = spawnTool(command, ends[1]);
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return Error{fmt::format("{}: cannot start it: {}", tool, std::strerror(-child))};
    }
    VdbReply reply;
    const bool inTime = readUntil(ends[0], Clock::now() + std::chrono::seconds(seconds), reply);
    close(ends[0]);
    if (!inTime) kill(child, SIGKILL);
    int status = 0;
    const bool hasStatus = waitForExit(child, status);
    if (!inTime)
        reply.stop(seconds);
    else if (hasStatus)
        reply.end(status);
    return reply.result(fs::path(tool).filename().string());
}

/// A path that the tool cannot take for an option.
std::string argumentPath(const std::string& path) {
    return path.starts_with('-') ? "./" + path : path;
}

/// Hands on what the tool noted: to the report, or to the log.
void reportNotes(const std::string& output, const std::string& path, ImportReport* report) {
    for (std::string& note : notesOf(output)) {
        if (report)
            report->lines.push_back(std::move(note));
        else
            logWarning(path + ": " + note);
    }
}

/// What differs when another file has come to a path, or the one there was written again; of none all are 0.
std::array<int64_t, 5> fileIdentity(const std::string& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return {};
    return {int64_t(found.st_ino), int64_t(found.st_size), int64_t(found.st_mtim.tv_sec),
            int64_t(found.st_mtim.tv_nsec), int64_t(found.st_dev)};
}

}  // namespace

Result<Level> readVdb(const std::string& path, const std::string& vdbTool, ImportReport* report) {
    if (vdbTool.empty()) return Error{path + ": expected the path of the program rubble-vdb to read it, found none"};
    const TemporaryFolder folder;
    if (folder.path().empty()) return Error{path + ": " + folder.error()};
    const std::string baked = folder.path() + "/level.rubble";
    const Result<std::string> output = runVdbTool(vdbTool, {"to-rubble", argumentPath(path), baked});
    if (!output)
        return Error{output.error().find(path) == std::string::npos ? path + ": " + output.error() : output.error()};
    reportNotes(*output, path, report);
    if (!std::filesystem::exists(baked))
        return Error{fmt::format("{}: {} wrote no level: is it the program rubble-vdb?", path, vdbTool)};
    Result<Level> level = readRubble(baked);
    if (level && report) report->count(*level);
    return level;
}

Result<Done> writeVdb(const std::string& path, const Level& level, const std::string& vdbTool) {
    if (vdbTool.empty()) return Error{path + ": expected the path of the program rubble-vdb to write it, found none"};
    const TemporaryFolder folder;
    if (folder.path().empty()) return Error{path + ": " + folder.error()};
    const std::string baked = folder.path() + "/level.rubble";
    const std::array<int64_t, 5> before = fileIdentity(path);
    if (const Result<Done> done = writeRubble(baked, level); !done) return done;
    const Result<std::string> output = runVdbTool(vdbTool, {"to-vdb", baked, argumentPath(path)});
    if (!output) return Error{output.error()};
    if (fileIdentity(path) == before)
        return Error{fmt::format("{}: {} wrote no level: is it the program rubble-vdb?", path, vdbTool)};
    return Done{};
}

}  // namespace rubble
