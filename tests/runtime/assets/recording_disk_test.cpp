#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <map>

#include "runtime/assets/file_hooks.h"
#include "runtime/assets/recording_file.h"
#include "runtime/core/random.h"
#include "tests/runtime/assets/broken_world.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using namespace test;

SavedGame gameWithoutEdits(const World& world) {
    return {world.state(), {}};
}

TEST(RecordingFile, OnADiskThatFillsTheStepsBeforeAreKeptAndTheFirstReasonIsReported) {
    const TempFolder folder;
    const World world = brokenWorld();
    const std::string path = folder / "full.rubblelog";
    Result<RecordingWriter> writer = RecordingWriter::open(path, gameWithoutEdits(world));
    ASSERT_TRUE(writer);
    writer->add({.step = world.step() + 1, .delta = std::vector<uint8_t>(100, 7)});
    const Result<Done> closed = [&] {
        const FileSizeLimit limit(std::filesystem::file_size(path + ".part") + 10);
        std::vector<uint8_t> noise(100'000);
        Random random(3);
        for (uint8_t& byte : noise) byte = uint8_t(random.below(256));
        for (uint64_t i = 2; i < 5; ++i) writer->add({.step = world.step() + i, .delta = noise});
        return writer->close();
    }();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().find("cannot write: File too large; the recording ends"), std::string::npos)
        << closed.error();
    const Result<Recording> kept = readRecording(path, 1);
    ASSERT_TRUE(kept) << kept.error();
    EXPECT_EQ(kept->steps.size(), 1u);
}

TEST(RecordingFile, AFullDiskIsKnownAtOnce) {
    const TempFolder folder;
    const World world = brokenWorld();
    const Result<RecordingWriter> writer = [&] {
        const FileSizeLimit limit(1000);
        return RecordingWriter::open(folder / "full.rubblelog", gameWithoutEdits(world));
    }();
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().find("full.rubblelog: cannot write: File too large"), std::string::npos) << writer.error();
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// The file of a recording is its own: what else would be written there would be lost when the recording ends.
TEST(RecordingFile, NothingElseIsWrittenToItsFile) {
    const TempFolder folder;
    const World world = brokenWorld();
    std::filesystem::create_directory(folder.path() / "folder");
    const std::vector<uint8_t> bytes = {1, 2, 3};
    const auto check = [&](const std::string& path, const std::string& same) {
        Result<RecordingWriter> writer = RecordingWriter::open(path, gameWithoutEdits(world));
        ASSERT_TRUE(writer) << writer.error();
        for (const std::string& name : {path, same}) {
            const Result<Done> saved = writeFileAtomically(name, bytes, 100);
            const auto other = RecordingWriter::open(name, gameWithoutEdits(world));
            ASSERT_FALSE(saved || other) << name;
            EXPECT_NE(saved.error().find("found one that a recording is being written to"), std::string::npos);
            EXPECT_EQ(saved.error(), other.error());
        }
        ASSERT_TRUE(writer->close());
        EXPECT_TRUE(readRecording(path, 1));
        EXPECT_TRUE(writeFileAtomically(same, bytes, 100)) << "afterwards it is a file like others";
    };
    check(folder / "a", folder / "folder/../a");
    static std::map<std::string, std::vector<uint8_t>> hosted;
    hosted.clear();
    FileHooks hooks;
    hooks.size = [](void*, const char* path) {
        return hosted.contains(path) ? hosted[path].size() : FileHooks::kOnDisk;
    };
    hooks.read = [](void*, const char* path, void* out, uint64_t size) {
        std::memcpy(out, hosted[path].data(), size);
        return 1;
    };
    hooks.write = [](void*, const char* path, const void* from, uint64_t size) {
        const auto* first = static_cast<const uint8_t*>(from);
        hosted[path].assign(first, first + size);
        return 1;
    };
    setFileHooks(hooks);
    check("in the host", "in the host");
    setFileHooks({});
}

TEST(FileBytes, ANameMayBeAsLongAsTheDiskAllows) {
    const TempFolder folder;
    const std::string longest(255, 'n');
    EXPECT_TRUE(writeFileAtomically(folder / longest, std::vector<uint8_t>{1}, 10));
    EXPECT_FALSE(writeFileAtomically(folder / (longest + "n"), std::vector<uint8_t>{1}, 10));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace rubble
