#include "samples/support/out_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace rubble {

namespace fs = std::filesystem;

std::string makeOutFolder(const std::string& folder) {
    if (folder.empty()) return "expected a folder, found nothing";
    std::error_code wrong;
    fs::create_directories(folder, wrong);
    if (!wrong && !fs::is_directory(folder, wrong) && !wrong) wrong = std::make_error_code(std::errc::not_a_directory);
    if (wrong) return "expected a folder that can be made, found " + folder + ": " + wrong.message();
    std::string probe = (fs::path(folder) / ".rubble-XXXXXX").string();
    const int file = mkstemp(probe.data());
    if (file < 0) return "expected a folder that can be written to, found " + folder + ": " + std::strerror(errno);
    close(file);
    unlink(probe.c_str());
    return "";
}

std::string makeFolderOf(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    return makeOutFolder(folder.empty() ? "." : folder.string());
}

}  // namespace rubble
