#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rubble {

/// A line that a host writes for an image: what it had seen until then.
struct HostImage {
    std::string path;
    uint64_t pieces = 0, removed = 0;            ///< since the start
    uint64_t ownPixels = 0, ownPixelsAlone = 0;  ///< that show the host's own meshes, with the world and without it
    uint64_t changedState = 0;                   ///< values of the GL's state that differ after a draw
};

/// What a host's script came to.
struct HostRun {
    int exitCode = -1;
    std::string output;
    std::vector<HostImage> images;
    std::vector<uint64_t> memory;  ///< KiB, after each cycle of the script
};

/// Why a host cannot run here, such as a package that is missing; empty if it can. With CI in the environment that is
/// a fault of the test.
std::string missingFor(const std::string& file, const std::string& package);
/// An empty folder for a host's images.
std::filesystem::path hostFolder(const std::string& name);
/// Runs a host and reads its lines.
HostRun runHost(const std::string& command);
/// Expects that a run came out: its images have a hole and pieces, hide some of the host's meshes but not all, and no
/// draw has changed the state; the memory of the last two cycles differs by less than a twentieth.
void expectGoodRun(const HostRun& run, size_t images);
/// Expects that two images of a run differ in at least a share of their pixels.
void expectDifferent(const HostImage& first, const HostImage& second, double share);

}  // namespace rubble
