#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// What became what in an import: one line each, ready to print.
struct ImportReport {
    std::vector<std::string> lines;
    uint64_t voxels = 0;
    int models = 0, shapes = 0;
};

struct VoxImportSettings {
    bool teardownPalette = false;  ///< palette rows name materials, as in the reference game
    double voxelSize = 0.1;        ///< metres
    bool oneBody = false;          ///< all objects on one static body instead of a body each
};

/// Reads a MagicaVoxel file (every chunk of versions 150 and 200). Y is up in the result.
Result<Level> importVox(const std::string& path, const VoxImportSettings& settings, ImportReport* report = nullptr);

/// Baked levels: versioned, chunked, checksummed, written atomically (to a neighbour, then renamed).
Result<Level> readRubble(const std::string& path);
Result<Done> writeRubble(const std::string& path, const Level& level);

/// Through the child process rubble-vdb (`vdbTool`: its path), under limits of memory and time.
Result<Level> readVdb(const std::string& path, const std::string& vdbTool);
Result<Done> writeVdb(const std::string& path, const Level& level, const std::string& vdbTool);

/// By the name's ending: .rubble, .vdb or .vox.
Result<Level> readLevel(const std::string& path, const std::string& vdbTool, ImportReport* report = nullptr);

/// Hash of everything in a level: files are equal when this is.
uint64_t hashLevel(const Level& level);

}  // namespace rubble
