#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/assets/assets.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// A program that stands for rubble-vdb.
std::string script(const TempFolder& folder, const std::string& text) {
    const std::string path = folder / "tool";
    std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

TEST(VdbTool, ManyNotesDoNotHideTheError) {
    const TempFolder folder;
    const std::string tool =
        script(folder,
               "yes 'note: a grid of an unknown type with a long name was left out' | head -n 5000\n"
               "echo 'error: the reason'\n"
               "exit 1");
    const Result<Level> level = readVdb("some.vdb", tool);
    ASSERT_FALSE(level);
    EXPECT_EQ(level.error(), "some.vdb: the reason");
}

TEST(VdbTool, LeftOutNotesAreSaid) {
    const TempFolder folder;
    const std::string tool = script(folder, "yes 'note: n' | head -n 50000");
    ImportReport report;
    EXPECT_FALSE(readVdb("some.vdb", tool, &report));
    EXPECT_EQ(std::count(report.lines.begin(), report.lines.end(), "further notes are left out"), 1);
}

TEST(VdbTool, WhatItSaysIsPrintable) {
    const TempFolder folder;
    ImportReport report;
    EXPECT_FALSE(readVdb("some.vdb", script(folder, "printf 'note: \\033[2J\\377\\n'"), &report));
    EXPECT_EQ(report.lines, std::vector<std::string>{"?[2J?"});
    const Result<Level> level = readVdb("some.vdb", script(folder, "printf 'error: \\a\\n'; exit 1"));
    ASSERT_FALSE(level);
    EXPECT_EQ(level.error(), "some.vdb: ?");
}

TEST(VdbTool, AnErrorWithoutWordsSaysHowItEnded) {
    const TempFolder folder;
    const Result<Level> level = readVdb("some.vdb", script(folder, "echo 'error: '; exit 3"));
    ASSERT_FALSE(level);
    EXPECT_NE(level.error().find("ended with code 3"), std::string::npos) << level.error();
}

TEST(VdbTool, AChildThatAbortsIsSaidToHarmNothingElse) {
    const TempFolder folder;
    const Result<Level> level = readVdb("some.vdb", script(folder, "kill -ABRT $$"));
    ASSERT_FALSE(level);
    EXPECT_NE(level.error().find("it runs in a process of its own"), std::string::npos) << level.error();
}

TEST(VdbTool, WithoutATemporaryFolderNothingIsConverted) {
    const TempFolder folder;
    const std::string tool = script(folder, "touch " + (folder / "started"));
    const char* before = std::getenv("TMPDIR");
    const std::string old = before ? before : "";
    setenv("TMPDIR", "/proc/self", 1);
    const Result<Level> level = readVdb("some.vdb", tool);
    const Result<Done> written = writeVdb("some.vdb", Level{}, tool);
    setenv("TMPDIR", "", 1);
    const Result<Level> usual = readVdb("some.vdb", script(folder, "echo 'error: it ran'; exit 1"));
    before ? setenv("TMPDIR", old.c_str(), 1) : unsetenv("TMPDIR");
    ASSERT_FALSE(level);
    ASSERT_FALSE(written);
    EXPECT_NE(level.error().find("cannot make a temporary folder"), std::string::npos) << level.error();
    EXPECT_NE(level.error().find("/proc/self"), std::string::npos) << level.error();
    EXPECT_FALSE(std::filesystem::exists(folder / "started"));
    EXPECT_EQ(usual.error(), "some.vdb: it ran") << "an empty TMPDIR is as none";
}

TEST(VdbTool, AProgramThatWritesNothingHasNotSavedTheLevel) {
    const TempFolder folder;
    const std::string path = folder / "level.vdb", nothing = script(folder, "exit 0");
    const std::string expected = path + ": " + nothing + " wrote no level: is it the program rubble-vdb?";
    const Result<Done> written = writeVdb(path, Level{}, nothing);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error(), expected);
    EXPECT_TRUE(writeVdb(path, Level{}, script(folder, "echo level > \"$7\""))) << "it gets the path";
    const Result<Done> kept = writeVdb(path, Level{}, script(folder, "exit 0"));
    ASSERT_FALSE(kept) << "what is there is the old level";
    EXPECT_EQ(kept.error(), expected);
}

TEST(VdbTool, WithoutAProgramTheMessageNamesIt) {
    const Result<Done> written = writeVdb("some.vdb", Level{}, "");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error(), "some.vdb: expected the path of the program rubble-vdb to write it, found none");
}

}  // namespace
}  // namespace rubble
