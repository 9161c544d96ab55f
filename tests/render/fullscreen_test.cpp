// What a full-screen draw leaves in its targets, by fragments and by compute.
#include "render/passes/fullscreen.h"

#include <filesystem>
#include <fstream>

#include "render/shader_library/fullscreen_choice.h"
#include "tests/render/gbuffer_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(5, 3);
constexpr glm::vec4 kOld(0.5f, 0.25f, 0.125f, 0.75f), kNew(1.0f, 2.0f, 3.0f, 0.5f);

class FullscreenDrawTest : public GBufferTest, public ::testing::WithParamInterface<FullscreenMethod> {
protected:
    void SetUp() override {
        GBufferTest::SetUp();
        if (GetParam() == FullscreenMethod::Compute && !hasCompute()) GTEST_SKIP() << "no GL 4.3";
        std::filesystem::create_directories(folder.path() / "lib");
        std::filesystem::copy_file(shaderFolder() + "/lib/fullscreen_far.vert",
                                   folder.path() / "lib/fullscreen_far.vert");
        targets.beginFrame(kSize, kSize, false);
    }
    FullscreenProgram& load(const std::string& file, const std::string& text, const FullscreenKind& kind) {
        std::ofstream(folder.path() / file) << text;
        FullscreenProgram& program = library.loadFullscreen(file, kind);
        EXPECT_TRUE(program) << library.errors().at(0);
        return program;
    }
    void draw(FullscreenProgram& program, const FullscreenTargets& into) {
        FrameContext frame = context(scene);
        frame.choice = &choice;
        drawFullscreen(frame, program, into, [](const Program&) {});
        EXPECT_EQ(choice.hasDrawnByCompute(), GetParam() == FullscreenMethod::Compute);
    }
    Scene scene;
    TempFolder folder;
    ShaderLibrary library{folder.path(), GetParam() == FullscreenMethod::Compute ? ShaderLibrary::Fullscreen::Compute
                                                                                 : ShaderLibrary::Fullscreen::Fragment};
    FullscreenChoice choice{GetParam()};
};

TEST_P(FullscreenDrawTest, EachMergeModeBlendsAsDeclared) {
    const std::pair<Merge, glm::vec4> expected[] = {{Merge::Replace, kNew},
                                                    {Merge::Color, {1.0f, 2.0f, 3.0f, 0.75f}},
                                                    {Merge::Alpha, {0.5f, 0.25f, 0.125f, 0.5f}},
                                                    {Merge::Add, kNew + kOld},
                                                    {Merge::Over, kNew + 0.5f * kOld}};
    const Texture target(GL_RGBA16F, kSize);
    for (const auto& [merge, result] : expected) {
        const std::string number = std::to_string(int(merge));
        FullscreenProgram& program =
            load("merge" + number + ".frag", "out vec4 color;\nvoid main() { color = vec4(1.0, 2.0, 3.0, 0.5); }\n",
                 {.merge = {merge}});
        draw(program, {{&target}, nullptr, {kOld}});
        for (const glm::vec4& pixel : read(target)) EXPECT_EQ(pixel, result) << "merge " << number;
    }
}

TEST_P(FullscreenDrawTest, OutputsMatchLocationsAndDiscardKeepsPixels) {
    const Texture first(GL_RGBA32F, kSize), second(GL_RG8, kSize);
    FullscreenProgram& program =
        load("two.frag",
             "layout(location = 1) out vec4 second;\nlayout(location = 0) out vec4 first;\nin vec2 uv;\n"
             "void main() {\n    if (gl_FragCoord.x > 3.0) discard;\n    second = vec4(1.0);\n"
             "    first = vec4(uv, gl_FragCoord.xy);\n}\n",
             {});
    draw(program, {{&first, &second}, nullptr, {kOld, glm::vec4(0.0f)}});
    const std::vector<glm::vec4> place = read(first), flag = read(second);
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
        const glm::vec2 middle(float(i % kSize.x) + 0.5f, float(i / kSize.x) + 0.5f);
        const bool isDrawn = middle.x < 3.0f;
        EXPECT_EQ(flag[size_t(i)].r, isDrawn ? 1.0f : 0.0f) << i;
        const glm::vec4 now(middle * (1.0f / glm::vec2(kSize)), middle);
        EXPECT_EQ(place[size_t(i)], isDrawn ? now : kOld) << i;
    }
}

TEST_P(FullscreenDrawTest, LimitedProgramsDrawOnlyOnSurfaces) {
    const Texture target(GL_RGBA16F, kSize), depth(GL_DEPTH_COMPONENT32F, kSize);
    targets.framebuffer({}, &depth).begin();
    const float farthest = 1.0f, surface = 0.999f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_SCISSOR_TEST);
    glScissor(2, 1, 1, 2);
    glClearBufferfv(GL_DEPTH, 0, &surface);
    glDisable(GL_SCISSOR_TEST);
    FullscreenProgram& program = load(
        "limited.frag", "out vec4 color;\nvoid main() { color = vec4(1.0, 2.0, 3.0, 0.5); }\n", {.surfacesOnly = true});
    draw(program, {{&target}, &depth, {kOld}});
    const std::vector<glm::vec4> pixels = read(target);
    for (int i = 0; i < kSize.x * kSize.y; ++i)
        EXPECT_EQ(pixels[size_t(i)], i % kSize.x == 2 && i / kSize.x >= 1 ? kNew : kOld) << i;
}

INSTANTIATE_TEST_SUITE_P(By, FullscreenDrawTest,
                         ::testing::Values(FullscreenMethod::Fragment, FullscreenMethod::Compute),
                         [](const auto& test) {
                             return test.param == FullscreenMethod::Compute ? "Compute" : "Fragment";
                         });

}  // namespace
}  // namespace rubble
