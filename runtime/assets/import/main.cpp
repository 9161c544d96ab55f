// rubble-import: converts a model to the formats of Rubble and reports what became what.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "runtime/assets/assets.h"

namespace {

using namespace rubble;
namespace fs = std::filesystem;

/// The path of rubble-vdb, which is installed beside this program.
std::string vdbToolPath() {
    std::error_code code;
    return (fs::read_symlink("/proc/self/exe", code).parent_path() / "rubble-vdb").string();
}

/// Writes a line with name and time of each stage to stderr.
class Progress {
public:
    void begin(const std::string& what) {
        end();
        m_start = std::chrono::steady_clock::now();
        m_open = true;
        fmt::print(stderr, "{} ... ", what);
        std::fflush(stderr);
    }
    void end() {
        if (m_open)
            fmt::print(stderr, "{:.2f} s\n",
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count());
        m_open = false;
    }

private:
    std::chrono::steady_clock::time_point m_start;
    bool m_open = false;
};

Result<Done> write(const std::string& path, const Level& level) {
    const std::string ending = endingOf(path);
    if (ending == ".rubble") return writeRubble(path, level);
    if (ending == ".vdb") return writeVdb(path, level, vdbToolPath());
    return Error{path + ": expected a name ending in .vdb or .rubble, found '" + ending + "'"};
}

int fail(const std::string& text) {
    fmt::print(stderr, "\nerror: {}\n", text);
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Converts a .vox, .vdb or .rubble file and reports what became what", "rubble import");
    std::string in, out;
    VoxImportSettings settings;
    bool quiet = false;
    app.add_option("in", in, "File to read: .vox, .vdb or .rubble")->required();
    app.add_option("out", out, "File to write: .vdb or .rubble")->required();
    app.add_flag("--teardown", settings.teardownPalette,
                 ".vox: take materials from the rows of the palette, as Teardown does");
    app.add_flag("--one-body", settings.oneBody, ".vox: put all objects on one static body");
    app.add_option("--voxel-size", settings.voxelSize, ".vox: size of a voxel in metres")->capture_default_str();
    app.add_flag("--quiet", quiet, "Print the totals only");
    CLI11_PARSE(app, argc, argv);

    Progress progress;
    ImportReport report;
    progress.begin("reading " + in);
    const Result<Level> level =
        endingOf(in) == ".vox" ? importVox(in, settings, &report) : readLevel(in, vdbToolPath(), &report);
    if (!level) return fail(level.error());
    progress.begin("writing " + out);
    const Result<Done> done = write(out, *level);
    if (!done) return fail(done.error());
    progress.end();
    if (!quiet)
        for (const std::string& line : report.lines) fmt::print("  {}\n", line);
    fmt::print("{}: {} models -> {} shapes on {} bodies, {} voxels, {} lights; hash {:016x}\n", out, report.models,
               report.shapes, level->bodies.size(), report.voxels, level->lights.size(), hashLevel(*level));
    return 0;
}
