#pragma once
#include <cstdint>

namespace rubble {

/// Files of a host in place of those on the disk: an archive, or memory. Called from any thread that reads or writes.
struct FileHooks {
    static constexpr uint64_t kOnDisk = ~uint64_t(0);
    void* user = nullptr;
    /// The bytes of a file; kOnDisk: the host does not have it. Null: it has none.
    uint64_t (*size)(void* user, const char* path) = nullptr;
    /// Reads a whole file that it has into `out`; 0: it cannot.
    int32_t (*read)(void* user, const char* path, void* out, uint64_t size) = nullptr;
    /// Writes a whole file; 0: it cannot, above 0: done, below 0: it belongs on the disk. Null: all do.
    int32_t (*write)(void* user, const char* path, const void* bytes, uint64_t size) = nullptr;
};

/// Sets what readFileBytes(), writeFileAtomically() and recordings ask first. Not while files are read or written.
void setFileHooks(const FileHooks& hooks);
/// What was set.
const FileHooks& fileHooks();

}  // namespace rubble
