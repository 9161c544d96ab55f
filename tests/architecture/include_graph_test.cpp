#include "tests/architecture/include_graph.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "generated/paths.h"
#include "tests/support/temp_folder.h"

namespace rubble::architecture {
namespace {

namespace fs = std::filesystem;

std::string listed(const std::vector<Violation>& violations) {
    std::string text;
    for (const Violation& violation : violations)
        text += violation.file + ":" + std::to_string(violation.line) + ": " + violation.text + "\n";
    return text;
}

TEST(Architecture, IncludesFollowTheTableInArchitectureMd) {
    const std::vector<Include> includes = readIncludes(RUBBLE_SOURCE_DIR);
    const std::vector<Module> modules = readModules(RUBBLE_SOURCE_DIR);
    EXPECT_GT(includes.size(), 100u) << "the tree was not read";
    EXPECT_GT(modules.size(), 20u) << "the table of folders was not read";
    EXPECT_EQ(listed(checkModules(includes, modules)), "");
}

TEST(Architecture, NoTwoFoldersNeedEachOther) {
    EXPECT_EQ(listed(checkFolderCycles(readIncludes(RUBBLE_SOURCE_DIR))), "");
}

TEST(Architecture, TheRendererNeverSeesTheWorld) {
    const std::vector<Include> includes = readIncludes(RUBBLE_SOURCE_DIR);
    EXPECT_EQ(listed(checkNeverReaches(includes, "render/", "runtime/world/world.h")), "");
    EXPECT_EQ(listed(checkNeverReaches(includes, "physics/", "render/renderer.h")), "");
}

TEST(Architecture, SourcesIncludeTheirOwnHeaderFirst) {
    EXPECT_EQ(listed(checkOwnHeaderFirst(RUBBLE_SOURCE_DIR, readIncludes(RUBBLE_SOURCE_DIR))), "");
}

TEST(Architecture, NamesSayWhatIsInside) {
    EXPECT_EQ(listed(checkNames(RUBBLE_SOURCE_DIR)), "");
}

/// A small source tree in a temporary folder, in which bad lines are planted.
class PlantedTree : public testing::Test {
protected:
    void SetUp() override {
        write(
            "ARCHITECTURE.md",
            "| folder | may include | what |\n| --- | --- | --- |\n| `runtime/core/` | | words |\n"
            "| `runtime/voxel/` | `runtime/core/` | grids |\n| `runtime/world/` | `runtime/core/`, `runtime/voxel/` | "
            "bodies |\n"
            "| `runtime/world/edits/` | `runtime/world/` | edits |\n| `runtime/frame/` | `runtime/world/` | frames |\n"
            "| `runtime/assets/` | | files |\n| `physics/` | `runtime/world/` | bodies |\n"
            "| `render/` | `runtime/frame/frame_snapshot.h` | GL |\n| `samples/` | `runtime/` | hosts |\n"
            "| `samples/hello/` | `rubble/rubble.h` | a host |\n");
        write("runtime/voxel/brick.h", "#pragma once\n#include \"runtime/core/hash.h\"\n");
        write("runtime/world/world.h", "#pragma once\n#include \"runtime/voxel/brick.h\"\n");
        write("render/renderer.h", "#pragma once\n#include \"runtime/frame/frame_snapshot.h\"\n");
        write("runtime/frame/frame_snapshot.h", "#pragma once\n");
        ASSERT_EQ(listed(violations()), "");
    }

    void write(const std::string& file, const std::string& text) {
        fs::create_directories((m_root / file).parent_path());
        std::ofstream(m_root / file) << text;
    }
    std::vector<Violation> violations() const {
        const std::vector<Include> includes = readIncludes(m_root);
        std::vector<Violation> found = checkModules(includes, readModules(m_root));
        for (const auto& more : {checkNeverReaches(includes, "render/", "runtime/world/world.h"),
                                 checkOwnHeaderFirst(m_root, includes), checkNames(m_root)})
            found.insert(found.end(), more.begin(), more.end());
        return found;
    }
    /// Plants a file and expects exactly one violation, at that file and line.
    void expectCaught(const std::string& file, int line, const std::string& text) {
        write(file, text);
        const std::vector<Violation> found = violations();
        ASSERT_EQ(found.size(), 1u) << file << "\n" << listed(found);
        EXPECT_EQ(found[0].file, file);
        EXPECT_EQ(found[0].line, line);
        fs::remove(m_root / file);
    }
    TempFolder m_folder;
    const fs::path& m_root = m_folder.path();
};

TEST_F(PlantedTree, AnIncludeAgainstTheTableIsCaught) {
    expectCaught("runtime/voxel/bad.cpp", 2, "#include <vector>\n#include \"runtime/world/world.h\"\n");
    expectCaught("physics/bad.cpp", 1, "#include \"render/renderer.h\"\n");
    expectCaught("samples/hello/bad.c", 1, "#include \"runtime/voxel/brick.h\"\n");
    expectCaught("physics/bad.cpp", 1, "#include <render/renderer.h>\n");
    expectCaught("runtime/voxel/bad.cpp", 1, "#include \"runtime/voxel/../world/world.h\"\n");
    expectCaught("runtime/voxel/bad.inl", 1, "#include \"runtime/world/world.h\"\n");
}

TEST_F(PlantedTree, AnInnerFolderHasItsOwnRow) {
    write("runtime/world/edits/carve.h", "#pragma once\n#include \"runtime/world/world.h\"\n");
    EXPECT_EQ(listed(violations()), "");
    expectCaught("runtime/world/edits/bad.h", 2, "#pragma once\n#include \"runtime/voxel/brick.h\"\n");
}

TEST_F(PlantedTree, AFolderWithoutARowIsCaught) {
    expectCaught("editor/bad.cpp", 1, "#include <vector>\n");
}

TEST_F(PlantedTree, FoldersThatNeedEachOtherAreCaught) {
    EXPECT_EQ(listed(checkFolderCycles(readIncludes(m_root))), "");
    write("runtime/core/bad.h", "#pragma once\n#include \"runtime/world/world.h\"\n");
    write("runtime/core/hash.h", "#pragma once\n");
    const std::vector<Violation> found = checkFolderCycles(readIncludes(m_root));
    ASSERT_EQ(found.size(), 1u) << listed(found);
    EXPECT_NE(found[0].text.find("cycle of folders"), std::string::npos) << found[0].text;
}

TEST_F(PlantedTree, ALibraryOutsideItsFoldersIsCaught) {
    expectCaught("runtime/world/bad.cpp", 1, "#include <btBulletDynamicsCommon.h>\n");
    expectCaught("runtime/assets/bad.cpp", 3, "\n\n  #  include <openvdb/openvdb.h>\n");
    expectCaught("samples/sandbox/bad.cpp", 1, "#include <glad/gl.h>\n");
    expectCaught("render/bad.cpp", 1, "#include <EGL/egl.h>\n");
}

TEST_F(PlantedTree, AnIndirectIncludeOfTheWorldIsCaught) {
    write("runtime/frame/frame_snapshot.h", "#pragma once\n#include \"runtime/world/world.h\"\n");
    const std::vector<Violation> found = violations();
    ASSERT_EQ(found.size(), 1u) << listed(found);
    EXPECT_EQ(found[0].file, "render/renderer.h");
    EXPECT_NE(found[0].text.find("runtime/frame/frame_snapshot.h > runtime/world/world.h"), std::string::npos)
        << found[0].text;
}

TEST_F(PlantedTree, BadNamesAreCaught) {
    expectCaught("runtime/world/utils/bad.h", 0, "#pragma once\n");
    fs::remove(m_root / "runtime/world/utils");
    expectCaught("runtime/world/bad.h", 2, "#pragma once\nclass BodyManager {};\n");
    write("runtime/voxel/brick.cpp", "");
    expectCaught("runtime/voxel/brick.cpp", 1, "#include <vector>\n#include \"runtime/voxel/brick.h\"\n");
    fs::create_directory(m_root / "extras");
    EXPECT_EQ(violations().size(), 1u);
}

}  // namespace
}  // namespace rubble::architecture
