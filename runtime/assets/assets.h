#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

// Levels from files and to files. Every error names the file, the place in it, what was expected and what was found.
namespace rubble {

/// The ending of a path in small letters, with its dot: it says which format a file has.
std::string endingOf(const std::string& path);

/// What an import made of a file, one line for each finding, ready to print.
struct ImportReport {
    std::vector<std::string> lines;
    uint64_t voxels = 0;
    int models = 0, shapes = 0;

    /// Adds the shapes and voxels of a level; each shape counts as a model.
    void count(const Level& level);
};

struct VoxImportSettings {
    bool teardownPalette = false;  ///< the rows of the palette name materials, as in Teardown
    double voxelSize = 0.1;        ///< metres
    bool oneBody = false;          ///< all objects on one static body instead of a body for each
};

/// Reads a MagicaVoxel file (versions 150 to 299, all documented chunks). Its z is up, the level's y.
Result<Level> importVox(const std::string& path, const VoxImportSettings& settings, ImportReport* report = nullptr);

/// Reads a baked level (.rubble); see rubble_file.h for the format.
Result<Level> readRubble(const std::string& path);
/// Writes a baked level, whole or not at all.
Result<Done> writeRubble(const std::string& path, const Level& level);

/// Reads an OpenVDB file. The program rubble-vdb (`vdbTool`: its path) does it in a child process with limits of memory
/// and time, so that a damaged file cannot crash the caller. Notes of the import go into the report, or into the log.
Result<Level> readVdb(const std::string& path, const std::string& vdbTool, ImportReport* report = nullptr);
/// Writes a level as an OpenVDB file, by the same program.
Result<Done> writeVdb(const std::string& path, const Level& level, const std::string& vdbTool);

/// Reads a file of the format that its name's ending says: .rubble, .vdb or .vox.
Result<Level> readLevel(const std::string& path, const std::string& vdbTool, ImportReport* report = nullptr);

/// Writes a level, whole or not at all, in the format that the name's ending says: .rubble, .vdb or .vox, which
/// holds less: what it leaves out is logged.
Result<Done> writeLevel(const std::string& path, const Level& level, const std::string& vdbTool);

/// Reads a .rubble or .vox file in memory, told apart by its first bytes. `name`: of the file, for messages.
Result<Level> levelFromBytes(std::span<const uint8_t> bytes, const std::string& name);

/// Hash of everything in a level: two levels with equal hashes give equal files.
uint64_t hashLevel(const Level& level);

}  // namespace rubble
