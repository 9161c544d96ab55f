#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "editor/ui/state/files.h"

namespace editor {

/// The folders and files where a path leads that is typed above it.
class FileList {
public:
    /// Draws it into what is left of the window. A click on a folder or a file becomes the path. `otherwise`: the
    /// folder of a path without one. True: a file was clicked twice.
    bool draw(std::string& path, std::string_view endings, const std::string& otherwise);

private:
    std::string m_path = "\n";  ///< for which the entries are: at first no path
    std::string m_folder;
    std::vector<FileEntry> m_entries;
};

}  // namespace editor
