#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// Reads a whole file: of the host, if it has it (file_hooks.h). An error if it is no regular file, cannot be read, or
/// is larger than `limit` bytes. Never waits for a writer, as the other end of a pipe.
Result<std::vector<uint8_t>> readFileBytes(const std::string& path, uint64_t limit);
/// The file that writing to `path` replaces or makes: `path` itself, or where a symbolic link leads. An error if
/// something that is no regular file is there, such as a folder or a device.
Result<std::string> fileToWrite(const std::string& path);
/// A file that is kept for one writer for long, such as a recording. Meanwhile writeFileAtomically() to it and further
/// claims of it are refused. Empty after a move and after release().
class FileClaim {
public:
    FileClaim() = default;
    ~FileClaim() { release(); }
    /// Takes the claim over.
    FileClaim(FileClaim&& other) noexcept : m_file(std::exchange(other.m_file, {})) {}
    FileClaim& operator=(FileClaim&& other) noexcept {
        std::swap(m_file, other.m_file);
        return *this;
    }
    /// Claims fileToWrite(), or the file of the host that has this name. An error if it is claimed already.
    static Result<FileClaim> make(const std::string& path);
    /// Ends it.
    void release();

private:
    std::string m_file;
};

/// Writes a temporary file beside fileToWrite(), flushes it to the disk and renames it: readers see the old file or the
/// whole new one, even after a power failure. Or hands it to the host (file_hooks.h). An error if there are more than
/// `limit` bytes, or if the file is claimed.
Result<Done> writeFileAtomically(const std::string& path, std::span<const uint8_t> bytes, uint64_t limit);
/// Throws std::bad_alloc if an errno says that there was no memory.
void requireMemory(int code);
/// "PATH: WHAT: why errno says that it failed"; without a reason if it says none. `code`: the errno of the failure.
Error fileError(const std::string& path, const char* what, int code);

}  // namespace rubble
