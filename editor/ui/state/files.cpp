#include "editor/ui/state/files.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "editor/ui/state/text.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxEntries = 2000;

bool hasOneOf(const std::string& name, std::string_view endings) {
    std::istringstream words{std::string(endings)};
    for (std::string ending; words >> ending;)
        if (lower(name).ends_with(ending)) return true;
    return false;
}

}  // namespace

std::string folderOf(const std::string& path, const std::string& otherwise) {
    const size_t slash = path.rfind('/');
    return slash == path.npos ? otherwise : path.substr(0, slash + 1);
}

std::vector<FileEntry> listFiles(const std::string& folder, std::string_view endings, const std::string& path) {
    std::vector<FileEntry> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        std::error_code ignored;
        const bool isFolder = at->is_directory(ignored);
        if (name.starts_with('.') || (!isFolder && !hasOneOf(name, endings))) continue;
        const uint64_t bytes = isFolder ? 0 : at->file_size(ignored);
        entries.push_back({name, isFolder, ignored ? 0 : bytes});
    }
    const std::string typed = lower(path.substr(path.rfind('/') + 1));
    const auto hasTyped = [&](const FileEntry& entry) { return lower(entry.name).find(typed) != std::string::npos; };
    if (std::any_of(entries.begin(), entries.end(), hasTyped))
        std::erase_if(entries, [&](const FileEntry& entry) { return !hasTyped(entry); });
    std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
        return a.isFolder != b.isFolder ? a.isFolder : lower(a.name) < lower(b.name);
    });
    if (entries.size() > kMaxEntries) entries.resize(kMaxEntries);
    return entries;
}

}  // namespace editor
