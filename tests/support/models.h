#pragma once
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "generated/paths.h"

namespace rubble {

/// The path of a MagicaVoxel model of the tests. The models lie beside the project, not in it.
inline std::filesystem::path modelPath(const std::string& file) {
    return std::filesystem::path(RUBBLE_SOURCE_DIR) / "../shared/models" / file;
}

/// All models in the order of their names; none if the folder is missing.
inline std::vector<std::filesystem::path> modelPaths() {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(modelPath(""))) return files;
    for (const auto& entry : std::filesystem::directory_iterator(modelPath("")))
        if (entry.path().extension() == ".vox") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace rubble

/// Ends the calling test if a file or folder of models is missing: skipped with the reason, or failed in CI (where the
/// environment variable CI is set), so that CI cannot pass without the models.
#define RUBBLE_REQUIRE_MODELS(path)                                                          \
    if (!std::filesystem::exists(path)) {                                                    \
        if (std::getenv("CI")) FAIL() << (path) << " is missing: put the test models there"; \
        GTEST_SKIP() << (path) << " is missing";                                             \
    }                                                                                        \
    static_assert(true, "a semicolon follows")
