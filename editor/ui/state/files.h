#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

/// A file or a folder of a list.
struct FileEntry {
    std::string name;
    bool isFolder;
    uint64_t bytes;  ///< of a file
};

/// The folder that a path leads into as it is typed: all up to its last slash; without one `otherwise`.
std::string folderOf(const std::string& path, const std::string& otherwise);

/// What a folder holds: its folders, then its files with one of some endings (".vox .vdb", with a blank between), each
/// by name, without those that begin with a dot. Of both those whose names hold what is typed behind the last slash of
/// a path, where any does. At most 2,000; none of a folder that cannot be read.
std::vector<FileEntry> listFiles(const std::string& folder, std::string_view endings, const std::string& path);

}  // namespace editor
