#include "runtime/assets/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace rubble {
namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

Error systemError(const std::string& path, const char* what) {
    return {fmt::format("{}: {}: {}", path, what, std::strerror(errno))};
}

}  // namespace

Result<std::vector<uint8_t>> readFileBytes(const std::string& path, uint64_t limit) {
    const File file(std::fopen(path.c_str(), "rb"));
    struct stat status {};
    if (!file || fstat(fileno(file.get()), &status) != 0) return systemError(path, "cannot open");
    if (!S_ISREG(status.st_mode)) return Error{path + ": expected a file, found something else"};
    if (uint64_t(status.st_size) > limit)
        return Error{fmt::format("{}: expected at most {} bytes, found {}", path, limit, status.st_size)};
    std::vector<uint8_t> bytes(size_t(status.st_size));
    if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) return systemError(path, "cannot read");
    return bytes;
}

Result<Done> writeFileAtomically(const std::string& path, std::span<const uint8_t> bytes) {
    static std::atomic<unsigned> calls{0};  // worlds of other threads may write the same file
    const std::string temporaryPath = fmt::format("{}.{}.{}.part", path, getpid(), ++calls);
    File file(std::fopen(temporaryPath.c_str(), "wb"));
    if (!file) return systemError(temporaryPath, "cannot write");
    bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    good = good && std::fflush(file.get()) == 0 && fsync(fileno(file.get())) == 0;
    good = good && std::rename(temporaryPath.c_str(), path.c_str()) == 0;
    if (good) return Done{};
    const Error error = systemError(path, "cannot write");
    std::remove(temporaryPath.c_str());
    return error;
}

}  // namespace rubble
