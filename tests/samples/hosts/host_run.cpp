#include "tests/samples/hosts/host_run.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "samples/support/image.h"
#include "tests/abi/run_command.h"

namespace rubble {

std::string missingFor(const std::string& file, const std::string& package) {
    if (std::filesystem::exists(file)) return "";
    const std::string text = file + " is missing: install " + package + " and configure again";
    if (std::getenv("CI")) ADD_FAILURE() << text;
    return text;
}

std::filesystem::path hostFolder(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("rubble_host_test_" + name);
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

HostRun runHost(const std::string& command) {
    HostRun run;
    run.output = runCommand("env -u DISPLAY -u WAYLAND_DISPLAY " + command, run.exitCode);
    std::istringstream lines(run.output);
    for (std::string line; std::getline(lines, line);) {
        HostImage image;
        char path[512];
        uint64_t kib = 0;
        const int read = std::sscanf(line.c_str(),
                                     "%511[^:]: pieces %" SCNu64 ", removed voxels %" SCNu64 ", own pixels %" SCNu64
                                     " of %" SCNu64 ", changed GL state %" SCNu64,
                                     path, &image.pieces, &image.removed, &image.ownPixels, &image.ownPixelsAlone,
                                     &image.changedState);
        image.path = path;
        if (read == 6) run.images.push_back(image);
        if (std::sscanf(line.c_str(), "memory after %*u steps: %" SCNu64, &kib) == 1) run.memory.push_back(kib);
    }
    return run;
}

void expectGoodRun(const HostRun& run, size_t images) {
    ASSERT_EQ(run.exitCode, 0) << run.output;
    ASSERT_EQ(run.images.size(), images) << run.output;
    for (const HostImage& image : run.images) {
        EXPECT_EQ(image.changedState, 0u) << image.path << "\n" << run.output;
        EXPECT_GT(image.ownPixels, 0u) << image.path << ": the world hides all of the host's meshes";
        EXPECT_LT(image.ownPixels, image.ownPixelsAlone) << image.path << ": the world hides none of the host's meshes";
    }
    EXPECT_EQ(run.images.front().pieces, 0u);
    EXPECT_GT(run.images.back().pieces, 50u) << run.output;
    EXPECT_GT(run.images.back().removed, 500u) << run.output;
    ASSERT_GE(run.memory.size(), 2u) << run.output;
    const uint64_t last = run.memory.back(), before = run.memory[run.memory.size() - 2];
    EXPECT_LT(last, before + before / 20) << "KiB after a cycle and after the next one, which did the same";
}

void expectDifferent(const HostImage& first, const HostImage& second, double share) {
    const Result<Image> a = readPng(first.path), b = readPng(second.path);
    ASSERT_TRUE(a && b) << first.path << ", " << second.path;
    ASSERT_EQ(a->rgb.size(), b->rgb.size());
    size_t different = 0;
    for (size_t i = 0; i < a->rgb.size(); i += 3)
        different += std::abs(a->rgb[i] - b->rgb[i]) + std::abs(a->rgb[i + 1] - b->rgb[i + 1]) +
                         std::abs(a->rgb[i + 2] - b->rgb[i + 2]) >
                     48;
    EXPECT_GT(double(different), share * double(a->rgb.size() / 3)) << first.path << " and " << second.path;
}

}  // namespace rubble
