#include "runtime/assets/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <set>
#include <utility>

#include "runtime/assets/file_hooks.h"

namespace rubble {
namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

FileHooks g_hooks;

Result<std::vector<uint8_t>> readHosted(const std::string& path, uint64_t size, uint64_t limit) {
    if (size > limit) return Error{fmt::format("{}: expected at most {} bytes, found {}", path, limit, size)};
    std::vector<uint8_t> bytes(static_cast<size_t>(size));
    if (!g_hooks.read(g_hooks.user, path.c_str(), bytes.data(), size))
        return Error{path + ": cannot read: the host's read_file() gave 0"};
    return bytes;
}

/// The files that are claimed, of all threads.
class ClaimedFiles {
public:
    bool add(const std::string& file) {
        const std::lock_guard lock(m_mutex);
        return m_files.insert(file).second;
    }
    void remove(const std::string& file) {
        const std::lock_guard lock(m_mutex);
        m_files.erase(file);
    }
    bool contains(const std::string& file) const {
        const std::lock_guard lock(m_mutex);
        return m_files.contains(file);
    }

private:
    mutable std::mutex m_mutex;
    std::set<std::string> m_files;  ///< with hosted ones as the host names them
};

ClaimedFiles& claimedFiles() {
    static ClaimedFiles files;
    return files;
}

constexpr const char* kIsClaimed = ": expected a file of its own, found one that a recording is being written to";

/// A new file beside `target`. Worlds of other threads may write the same target.
std::string temporaryFile(const std::string& target) {
    constexpr size_t kMaxStem = 200;  // of the 255 bytes that a name may have
    static std::atomic<unsigned> calls{0};
    const std::filesystem::path path = target;
    const std::string stem = path.filename().string().substr(0, kMaxStem);
    return (path.parent_path() / fmt::format("{}.{}.{}.part", stem, getpid(), ++calls)).string();
}

}  // namespace

Result<FileClaim> FileClaim::make(const std::string& path) {
    std::string file = path;
    if (!g_hooks.write) {
        const Result<std::string> target = fileToWrite(path);
        if (!target) return Error{target.error()};
        file = *target;
    }
    if (!claimedFiles().add(file)) return Error{path + kIsClaimed};
    FileClaim claim;
    claim.m_file = std::move(file);
    return claim;
}

void FileClaim::release() {
    if (!m_file.empty()) claimedFiles().remove(m_file);
    m_file.clear();
}

void setFileHooks(const FileHooks& hooks) {
    g_hooks = hooks;
}

const FileHooks& fileHooks() {
    return g_hooks;
}

void requireMemory(int code) {
    if (code == ENOMEM) throw std::bad_alloc();
}

Error fileError(const std::string& path, const char* what, int code) {
    return {path + ": " + what + (code ? std::string(": ") + std::strerror(code) : "")};
}

Result<std::vector<uint8_t>> readFileBytes(const std::string& path, uint64_t limit) {
    if (g_hooks.size)
        if (const uint64_t size = g_hooks.size(g_hooks.user, path.c_str()); size != FileHooks::kOnDisk)
            return readHosted(path, size, limit);
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const File file(descriptor < 0 ? nullptr : fdopen(descriptor, "rb"));
    struct stat status {};
    if (!file || fstat(descriptor, &status) != 0) {
        const int reason = errno;
        if (!file && descriptor >= 0) ::close(descriptor);
        requireMemory(reason);
        return fileError(path, "cannot open", reason);
    }
    if (!S_ISREG(status.st_mode)) return Error{path + ": expected a file, found something else"};
    if (uint64_t(status.st_size) > limit)
        return Error{fmt::format("{}: expected at most {} bytes, found {}", path, limit, status.st_size)};
    std::vector<uint8_t> bytes(size_t(status.st_size));
    errno = 0;
    const size_t got = std::fread(bytes.data(), 1, bytes.size(), file.get());
    if (got == bytes.size()) return bytes;
    if (std::ferror(file.get())) return fileError(path, "cannot read", errno);
    return Error{fmt::format("{}: expected {} bytes, found {}: it was changed meanwhile", path, bytes.size(), got)};
}

Result<std::string> fileToWrite(const std::string& path) {
    constexpr int kMaxLinks = 40;  // in a chain, as on Linux
    std::filesystem::path file = path;
    if (path.empty() || !file.has_filename()) return Error{fmt::format("\"{}\": expected the name of a file", path)};
    std::error_code ignored;
    auto kind = std::filesystem::symlink_status(file, ignored).type();
    for (int i = 0; kind == std::filesystem::file_type::symlink; ++i) {
        if (i == kMaxLinks) return fileError(path, "cannot write", ELOOP);
        file = file.parent_path() / std::filesystem::read_symlink(file, ignored);
        kind = std::filesystem::symlink_status(file, ignored).type();
    }
    const bool isFree = kind == std::filesystem::file_type::not_found || kind == std::filesystem::file_type::none;
    if (!isFree && kind != std::filesystem::file_type::regular)
        return Error{path + ": cannot write: expected a file, found something else"};
    std::error_code failure;
    const std::filesystem::path folder = std::filesystem::weakly_canonical(file.parent_path(), failure);
    requireMemory(failure.value());  // its path is empty then
    return (folder / file.filename()).string();
}

Result<Done> writeFileAtomically(const std::string& path, std::span<const uint8_t> bytes, uint64_t limit) {
    if (bytes.size() > limit)
        return Error{fmt::format("{}: expected at most {} bytes to write, found {}", path, limit, bytes.size())};
    if (claimedFiles().contains(path)) return Error{path + kIsClaimed};
    if (g_hooks.write)
        if (const int32_t done = g_hooks.write(g_hooks.user, path.c_str(), bytes.data(), bytes.size()); done >= 0)
            return done > 0 ? Result<Done>(Done{}) : Error{path + ": cannot write: the host's write_file() gave 0"};
    const Result<std::string> target = fileToWrite(path);
    if (!target) return Error{target.error()};
    if (claimedFiles().contains(*target)) return Error{path + kIsClaimed};
    const std::string temporaryPath = temporaryFile(*target);
    File file(std::fopen(temporaryPath.c_str(), "wb"));
    if (!file) {
        requireMemory(errno);
        return fileError(path, "cannot write", errno);
    }
    errno = 0;
    bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    good = good && std::fflush(file.get()) == 0 && fsync(fileno(file.get())) == 0;
    good = good && std::rename(temporaryPath.c_str(), target->c_str()) == 0;
    if (good) return Done{};
    const Error error = fileError(path, "cannot write", errno);
    std::remove(temporaryPath.c_str());
    return error;
}

}  // namespace rubble
