// rubble-vdb: converts .vdb files to baked .rubble levels and back. The runtime starts it as a child process,
// because OpenVDB may crash on a damaged file.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <new>

#include "runtime/assets/assets.h"
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

/// Whether an output has the ending of its format, so that it cannot replace the input; else says so.
bool hasEnding(const std::string& path, const std::string& ending) {
    const std::string found = std::filesystem::path(path).extension().string();
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

int toRubble(const std::string& in, const std::string& out) {
    if (!hasEnding(out, ".rubble")) return 1;
    std::vector<std::string> notes;
    const Result<Level> level = readVdbFile(in, notes);
    for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", note.c_str());
    if (!level) return fail(level.error());
    const Result<Done> done = writeRubble(out, *level);
    return done ? 0 : fail(done.error());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Converts OpenVDB files to baked Rubble levels and back");
    std::string in, out;
    uint64_t memoryMib = 4096, seconds = 120;
    app.add_option("--memory-mib", memoryMib, "Address space it may use")->capture_default_str();
    app.add_option("--seconds", seconds, "Processor time it may use")->capture_default_str();
    app.require_subcommand(1);
    CLI::App* toVdbCommand = app.add_subcommand("to-vdb", "IN.rubble -> OUT.vdb");
    CLI::App* toRubbleCommand = app.add_subcommand("to-rubble", "IN.vdb -> OUT.rubble");
    for (CLI::App* command : {toVdbCommand, toRubbleCommand}) {
        command->add_option("in", in, "File to read")->required();
        command->add_option("out", out, "File to write")->required();
    }
    CLI11_PARSE(app, argc, argv);
    limitProcess(memoryMib, seconds);
    try {
        return *toVdbCommand ? toVdb(in, out) : toRubble(in, out);
    } catch (const std::bad_alloc&) {
        return fail(in + ": not enough memory for what it describes (--memory-mib raises the limit)");
    }
}
