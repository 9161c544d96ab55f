#include "render/shader_library/shader_library.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "generated/paths.h"
#include "render/frame/frame_context.h"
#include "render/shader_library/embedded_shaders.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

/// Two uses of one dimension would draw the same numbers for a pixel.
TEST(BlueNoiseDimensions, AreUsedOnceInAllPasses) {
    const std::regex use(R"(blueNoise\(\w+, (\d+))");
    std::map<std::string, std::string> users;
    for (const auto& file : std::filesystem::recursive_directory_iterator(RUBBLE_SOURCE_DIR "/shaders")) {
        if (!file.is_regular_file()) continue;
        std::ifstream stream(file.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (std::sregex_iterator found(text.begin(), text.end(), use), end; found != end; ++found) {
            const auto [before, isNew] = users.emplace((*found)[1], file.path().filename());
            EXPECT_TRUE(isNew) << file.path() << " uses dimension " << (*found)[1] << " like " << before->second;
        }
    }
    EXPECT_GT(users.size(), 10u);
}

class ShaderLibraryTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        std::filesystem::create_directories(folder / "lib");
        write("full.vert", "void main() { gl_Position = vec4(0.0); }\n");
    }
    void write(const std::string& file, const std::string& text) { std::ofstream(folder / file) << text; }
    TempFolder made;
    const std::filesystem::path& folder = made.path();
};

TEST_F(ShaderLibraryTest, ErrorsNameTheFileAndLineOfAnInclude) {
    write("lib/broken.glsl", "// one\n// two\nfloat three() { return nothing; }\n");
    write("a.frag", "// one\n#include \"lib/broken.glsl\"\nout vec4 color;\nvoid main() { color = vec4(three()); }\n");
    ShaderLibrary shaders(folder);
    EXPECT_FALSE(shaders.load("a.frag", "full.vert"));
    ASSERT_EQ(shaders.errors().size(), 1u);
    EXPECT_NE(shaders.errors()[0].find("lib/broken.glsl:3"), std::string::npos) << shaders.errors()[0];
}

TEST_F(ShaderLibraryTest, ErrorsAfterAnIncludeNameTheIncludingFile) {
    write("lib/fine.glsl", "float one() { return 1.0; }\n\n\n\n");
    write("a.frag",
          "#include \"lib/fine.glsl\"\n#include \"lib/fine.glsl\"\nout vec4 color;\nvoid main() { color = one; }\n");
    ShaderLibrary shaders(folder);
    EXPECT_FALSE(shaders.load("a.frag", "full.vert"));
    EXPECT_NE(shaders.errors().at(0).find("a.frag:4"), std::string::npos) << shaders.errors()[0];
}

TEST_F(ShaderLibraryTest, MissingFilesAreNamedWithWhoAskedForThem) {
    write("a.frag", "\n#include \"lib/none.glsl\"\nvoid main() {}\n");
    ShaderLibrary shaders(folder);
    EXPECT_FALSE(shaders.load("a.frag", "full.vert"));
    EXPECT_NE(shaders.errors().at(0).find("a.frag:2"), std::string::npos) << shaders.errors()[0];
    EXPECT_NE(shaders.errors().at(0).find("none.glsl"), std::string::npos);
}

TEST_F(ShaderLibraryTest, ReloadKeepsTheLastGoodProgram) {
    const auto touch = [&](int seconds) {
        std::filesystem::last_write_time(folder / "a.frag",
                                         std::filesystem::file_time_type::clock::now() + std::chrono::seconds(seconds));
    };
    write("a.frag", "out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
    ShaderLibrary shaders(folder);
    const Program& program = shaders.load("a.frag", "full.vert");
    ASSERT_TRUE(program);
    const GLuint first = program.name();
    EXPECT_FALSE(shaders.reloadChanged()) << "nothing changed";

    write("a.frag", "out vec4 color;\nvoid main() { color = oops; }\n");
    touch(10);
    EXPECT_FALSE(shaders.reloadChanged());
    EXPECT_EQ(program.name(), first);
    EXPECT_NE(shaders.errors().at(0).find("a.frag:2"), std::string::npos);

    write("a.frag", "out vec4 color;\nvoid main() { color = vec4(0.5); }\n");
    touch(20);
    EXPECT_TRUE(shaders.reloadChanged());
    EXPECT_TRUE(program);
    EXPECT_TRUE(shaders.errors().empty());
}

/// Both programs of a shader that covers its targets, each in a library of its own.
class FullscreenLibraryTest : public ShaderLibraryTest {
protected:
    void SetUp() override {
        ShaderLibraryTest::SetUp();
        if (!hasCompute()) GTEST_SKIP() << "no GL 4.3";
        write("lib/fullscreen_far.vert", "void main() { gl_Position = vec4(0.0); }\n");
    }
    static constexpr ShaderLibrary::Fullscreen kEach[] = {ShaderLibrary::Fullscreen::Fragment,
                                                          ShaderLibrary::Fullscreen::Compute};
};

TEST_F(FullscreenLibraryTest, ErrorsNameTheFileAndLineInBothPrograms) {
    write("lib/broken.glsl", "// one\n// two\nfloat three() { return nothing; }\n");
    write("a.frag",
          "#include \"lib/broken.glsl\"\nin vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(three()); }\n");
    write("b.frag",
          "in vec2 uv;\n  layout(location = 0)  out  vec4 color ;  // rgb\n\nvoid main() {\n    color = uv;\n}\n");
    for (const auto each : kEach) {
        ShaderLibrary shaders(folder, each);
        EXPECT_FALSE(shaders.loadFullscreen("a.frag"));
        EXPECT_FALSE(shaders.loadFullscreen("b.frag"));
        ASSERT_EQ(shaders.errors().size(), 2u);
        EXPECT_NE(shaders.errors()[0].find("lib/broken.glsl:3"), std::string::npos) << shaders.errors()[0];
        EXPECT_NE(shaders.errors()[1].find("b.frag:5"), std::string::npos) << shaders.errors()[1];
    }
}

TEST_F(FullscreenLibraryTest, BuildsOnlyTheRequestedMethods) {
    write("a.frag", "out vec4 color;\nvoid main() { if (gl_FragCoord.x < 3.0) discard; color = vec4(1.0); }\n");
    for (const auto each : kEach) {
        ShaderLibrary shaders(folder, each);
        const FullscreenProgram& program = shaders.loadFullscreen("a.frag");
        EXPECT_TRUE(shaders.errors().empty()) << shaders.errors()[0];
        const bool compute = each == ShaderLibrary::Fullscreen::Compute;
        EXPECT_EQ(program.has(FullscreenMethod::Fragment), !compute);
        EXPECT_EQ(program.has(FullscreenMethod::Compute), compute);
        EXPECT_EQ(shaders.computePrograms(), int(compute));
        EXPECT_EQ(&shaders.loadFullscreen("a.frag"), &program) << "built once";
    }
}

TEST_F(FullscreenLibraryTest, FallsBackToFragments) {
    write("a.frag", "in vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(dFdx(uv), uv); }\n");
    ShaderLibrary shaders(folder, ShaderLibrary::Fullscreen::Both);
    FullscreenProgram& program = shaders.loadFullscreen("a.frag");
    EXPECT_TRUE(program.has(FullscreenMethod::Fragment));
    EXPECT_FALSE(program.has(FullscreenMethod::Compute));
    EXPECT_TRUE(shaders.errors().empty()) << "there is something to draw with";
}

TEST_F(FullscreenLibraryTest, AReleasedProgramIsNotBuiltAgain) {
    write("a.frag", "out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
    ShaderLibrary shaders(folder, ShaderLibrary::Fullscreen::Both);
    FullscreenProgram& program = shaders.loadFullscreen("a.frag");
    EXPECT_EQ(shaders.computePrograms(), 1);
    program.release(FullscreenMethod::Compute);
    EXPECT_EQ(shaders.computePrograms(), 0);
    write("a.frag", "out vec4 color;\nvoid main() { color = vec4(0.5); }\n");
    std::filesystem::last_write_time(folder / "a.frag",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(10));
    EXPECT_TRUE(shaders.reloadChanged());
    EXPECT_EQ(shaders.computePrograms(), 0);
    EXPECT_TRUE(program.has(FullscreenMethod::Fragment));
}

TEST_F(ShaderLibraryTest, TheLibraryHoldsEveryShader) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shaderFolder())) {
        if (!entry.is_regular_file()) continue;
        const std::string file = entry.path().lexically_relative(shaderFolder()).generic_string();
        std::ifstream stream(entry.path());
        EXPECT_EQ(embeddedShader(file), std::string(std::istreambuf_iterator<char>(stream), {})) << file;
        ++count;
    }
    EXPECT_GT(count, 50);
    EXPECT_FALSE(embeddedShader("passes/missing.frag"));

    ShaderLibrary shaders("");
    EXPECT_TRUE(shaders.load("passes/gbuffer.frag", "passes/tiles.vert"));
    EXPECT_FALSE(shaders.reloadChanged());
    EXPECT_FALSE(shaders.load("passes/missing.frag"));
    ASSERT_EQ(shaders.errors().size(), 1u);
    EXPECT_NE(shaders.errors()[0].find("passes/missing.frag"), std::string::npos) << shaders.errors()[0];
}

TEST_F(ShaderLibraryTest, FrameBlockLayoutMatchesTheShader) {
    write("a.frag", "");
    ShaderLibrary shaders(shaderFolder());
    const Program& program = shaders.load("passes/gbuffer.frag", "passes/tiles.vert");
    ASSERT_TRUE(program);
    const GLuint block = glGetUniformBlockIndex(program.name(), "FrameBlock");
    ASSERT_NE(block, GL_INVALID_INDEX);
    GLint size = 0;
    glGetActiveUniformBlockiv(program.name(), block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    EXPECT_EQ(size_t(size), sizeof(FrameBlock));
    const std::pair<const char*, size_t> members[] = {
        {"FrameBlock.viewProjection", offsetof(FrameBlock, viewProjection)},
        {"FrameBlock.cameraForward", offsetof(FrameBlock, cameraForward)},
        {"FrameBlock.counters", offsetof(FrameBlock, counters)},
        {"FrameBlock.shadowPagedHigh", offsetof(FrameBlock, shadowPagedHigh)},
    };
    for (const auto& [name, offset] : members) {
        GLuint index = GL_INVALID_INDEX;
        GLint found = -1;
        glGetUniformIndices(program.name(), 1, &name, &index);
        ASSERT_NE(index, GL_INVALID_INDEX) << name;
        glGetActiveUniformsiv(program.name(), 1, &index, GL_UNIFORM_OFFSET, &found);
        EXPECT_EQ(size_t(found), offset) << name;
    }
}

}  // namespace
}  // namespace rubble
