// rubble-vdb: converts .vdb files to baked .rubble levels and back, and meshes to levels. Hosts start it as a child
// process, because OpenVDB and Assimp may crash on a damaged file.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <new>

#include "runtime/assets/assets.h"
#include "runtime/assets/vdb/mesh_file.h"
#include "runtime/assets/vdb/mesh_voxels.h"
#include "runtime/assets/vdb/vdb_file.h"

namespace {

using namespace rubble;

void limitProcess(uint64_t memoryMib, uint64_t seconds) {
    const auto limit = [](auto resource, uint64_t value) {
        const struct rlimit both { value, value };
        setrlimit(resource, &both);
    };
#ifndef RUBBLE_IS_SANITIZED  // sanitizers reserve terabytes
    limit(RLIMIT_AS, memoryMib << 20);
#else
    (void)memoryMib;
#endif
    limit(RLIMIT_CPU, seconds);
    limit(RLIMIT_CORE, 0);
}

int fail(const std::string& text) {
    std::fprintf(stderr, "error: %s\n", text.c_str());
    return 1;
}

/// NaN is within every range of CLI11.
std::string numberError(const std::string& text) {
    double value = 0.0;
    return CLI::detail::lexical_cast(text, value) && value == value ? "" : "expected a number, found " + text;
}

/// Whether an output has the ending of its format, so that it cannot replace the input; else says so.
bool hasEnding(const std::string& path, const std::string& ending) {
    const std::string found = endingOf(path);
    if (found == ending) return true;
    fail(path + ": expected a name ending in " + ending + " to write to, found '" + found + "'");
    return false;
}

int toVdb(const std::string& in, const std::string& out) {
    if (!hasEnding(out, ".vdb")) return 1;
    const Result<Level> level = readRubble(in);
    if (!level) return fail(level.error());
    const Result<Done> done = writeVdbFile(out, *level);
    return done ? 0 : fail(done.error());
}

void printNotes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", note.c_str());
}

int toRubble(const std::string& in, const std::string& out) {
    if (!hasEnding(out, ".rubble")) return 1;
    std::vector<std::string> notes;
    const Result<Level> level = readVdbFile(in, notes);
    printNotes(notes);
    if (!level) return fail(level.error());
    const Result<Done> done = writeRubble(out, *level);
    return done ? 0 : fail(done.error());
}

int meshToRubble(const std::string& in, const std::string& out, const MeshSettings& settings) {
    if (!hasEnding(out, ".rubble")) return 1;
#ifdef RUBBLE_WITHOUT_MESHES
    const Result<Mesh> mesh =
        Error{in + ": this rubble-vdb reads no meshes: it was built without Assimp (libassimp-dev)"};
#else
    const Result<Mesh> mesh = readMesh(in);
#endif
    if (!mesh) return fail(mesh.error());
    std::vector<std::string> notes = mesh->notes;
    const Result<Level> level = voxelise(*mesh, std::filesystem::path(in).stem().string(), settings, notes);
    if (!level) return fail(in + ": " + level.error());
    printNotes(notes);
    const Result<Done> done = writeRubble(out, *level);
    return done ? 0 : fail(done.error());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Converts OpenVDB files to baked Rubble levels and back, and meshes to such levels");
    std::string in, out;
    uint64_t memoryMib = 4096, seconds = 120;
    app.add_option("--memory-mib", memoryMib, "Address space it may use")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--seconds", seconds, "Processor time it may use")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000));
    app.require_subcommand(1);
    CLI::App* toVdbCommand = app.add_subcommand("to-vdb", "IN.rubble -> OUT.vdb");
    CLI::App* toRubbleCommand = app.add_subcommand("to-rubble", "IN.vdb -> OUT.rubble");
    CLI::App* meshCommand = app.add_subcommand("mesh-to-rubble", "IN.obj, IN.ply or IN.glb -> OUT.rubble");
    MeshSettings mesh;
    meshCommand->add_option("--voxels", mesh.voxels, "along its longest side; 0: as long as the file says")
        ->check(CLI::Range(0, kMaxGridSize))
        ->capture_default_str();
    meshCommand->add_option("--voxel", mesh.voxelSize, "metres along an edge of a voxel")
        ->check(CLI::Range(0.001, 10.0) & CLI::Validator(numberError, ""))
        ->capture_default_str();
    meshCommand->add_option("--shell", mesh.shell, "voxels that walls are thick; 0: solid")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    meshCommand->add_flag("--z-up", mesh.isZUp, "z is up in the file, not y");
    meshCommand->add_flag("--smooth", mesh.isSmooth, "reads textures bilinear, not by the nearest pixel");
    for (CLI::App* command : {toVdbCommand, toRubbleCommand, meshCommand}) {
        command->add_option("in", in, "File to read")->required();
        command->add_option("out", out, "File to write")->required();
    }
    CLI11_PARSE(app, argc, argv);
    limitProcess(memoryMib, seconds);
    try {
        if (*meshCommand) return meshToRubble(in, out, mesh);
        return *toVdbCommand ? toVdb(in, out) : toRubble(in, out);
    } catch (const std::bad_alloc&) {
        return fail(in + ": not enough memory for what it describes (--memory-mib raises the limit)");
    } catch (const std::exception& error) {
        return fail(in + ": " + error.what());
    }
}
