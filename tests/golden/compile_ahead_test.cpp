// What the driver does for programs, and when: a game must not stop where something is first seen.
#include <filesystem>
#include <fstream>

#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"
#include "tests/golden/llvm_modules.h"
#include "tests/render/gl_calls.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(160, 90);  ///< no side, halved as often as bloom does, is a power of two

FrameSnapshot dryStreet() {
    FrameSnapshot snapshot = streetScene().snapshot();
    snapshot.lights.clear();
    return snapshot;
}

struct Feature {
    const char* name;
    void (*add)(FrameSnapshot&);
    const char* pass;
};
const Feature kFeatures[] = {
    {"the first explosion",
     [](FrameSnapshot& s) {
         s.particlesChanged = true;
         for (const ParticleKind kind : {ParticleKind::Dust, ParticleKind::Spark, ParticleKind::Crumb})
             s.particles.push_back({kind, {0, 1, 0}, glm::vec3(0.0f), glm::vec3(0.6f), 0.3f, 0.9f, 0.3f, 1});
         s.lightsChanged = true;
         s.lights.push_back({LightKind::Sphere, {0, 2, 0}, {0, -1, 0}, glm::vec3(90.0f), 0.1f, 20.0f, 0.3f, 0.5f});
         s.lights.back().fleeting = true;
     },
     "particles"},
    {"fog",
     [](FrameSnapshot& s) {
         s.environmentChanged = true;
         s.environment.fogDensity = 0.05f;
     },
     "fog"},
    {"rain",
     [](FrameSnapshot& s) {
         s.environmentChanged = true;
         s.environment.wetness = 1.0f;
     },
     "wetness"},
    {"a light",
     [](FrameSnapshot& s) {
         s.lightsChanged = true;
         s.lights.push_back({LightKind::Sphere, {0, 2, 0}, {0, -1, 0}, glm::vec3(9.0f), 0.1f, 20.0f, 0.3f, 0.5f});
     },
     "local lights"},
    {"water",
     [](FrameSnapshot& s) {
         Water water;
         water.outline = {{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
         water.surface = 0.3;
         s.watersChanged = true;
         s.waters.push_back(water);
     },
     "water"},
    {"a rope",
     [](FrameSnapshot& s) {
         s.ropesChanged = true;
         s.ropes.push_back(
             {JointHandle::make(1, 1, 0), {{-1, 1, 0}, {1, 1, 0}}, {{-1, 1, 0}, {1, 1, 0}}, 0.02f, glm::vec3(0.5f)});
     },
     "ropes"},
    {"glass",
     [](FrameSnapshot& s) {
         auto palette = std::make_shared<Palette>(*streetPalette());
         for (PaletteEntry& entry : *palette) entry.opacity = 90;
         s.palettes.push_back({ShapeHandle::make(1, 1, 0), palette, nullptr});
     },
     "glass"},
    {"a piece that flies off",
     [](FrameSnapshot& s) {
         ShadowWords cells{};
         cells.fill(1);
         s.shadow.push_back({{4000, 0, 0}, makeShadowBrick(cells)});
     },
     "sun"},
};

/// Programs that are compiled or linked while it lives.
struct Builds {
    GlCalls<&glad_glCompileShader> compiled;
    GlCalls<&glad_glLinkProgram> linked;
    int count() const { return compiled.count() + linked.count(); }
};

class CompileAheadTest : public Drawing {
protected:
    void begin(bool ahead) {
        RenderSettings settings;
        settings.compileAhead = ahead;
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        target = std::make_unique<Offscreen>(kSize);
    }
    bool ran(const char* pass) const {
        const auto& passes = renderer->stats().passes;
        return std::find(passes.begin(), passes.end(), std::string_view(pass)) != passes.end();
    }
};

TEST_F(CompileAheadTest, NoFeatureBuildsProgramsWhenItIsFirstSeen) {
    begin(true);
    const Builds builds;
    renderer->apply(dryStreet());
    draw(streetCamera(0));
    EXPECT_EQ(builds.count(), 0) << "the first frame";
    FrameSnapshot all = dryStreet();
    all.replacesAll = false;
    all.created.clear();
    for (const Feature& feature : kFeatures) {
        feature.add(all);
        FrameSnapshot step = all;
        step.version = ++all.version;
        renderer->apply(std::move(step));
        draw(streetCamera(0));
        EXPECT_TRUE(ran(feature.pass)) << feature.name;
        EXPECT_EQ(builds.count(), 0) << feature.name << " compiles or links";
    }
}

/// A driver builds its programs with the first draw, and again for other kinds of targets, textures and blending.
TEST_F(CompileAheadTest, NoFeatureMakesTheDriverBuildProgramsWhenItIsFirstSeen) {
    const int before = llvmModules();
    begin(true);
    if (llvmModules() == before) {
        const bool isLlvmpipe =
            std::string_view(reinterpret_cast<const char*>(glGetString(GL_RENDERER))).starts_with("llvmpipe");
        EXPECT_FALSE(isLlvmpipe && std::getenv("CI")) << "llvmpipe's builds are not counted";
        GTEST_SKIP() << "builds of this driver cannot be counted";
    }
    int built = llvmModules();
    const auto expectNoBuild = [&](const char* what) {
        for (int i = 0; i < 3; ++i) draw(streetCamera(0));
        EXPECT_EQ(llvmModules(), built) << what << ": the driver builds programs";
        built = llvmModules();
    };
    renderer->apply(dryStreet());
    expectNoBuild("the first frame");
    FrameSnapshot all = dryStreet();
    all.replacesAll = false;
    all.created.clear();
    for (const Feature& feature : kFeatures) {
        feature.add(all);
        FrameSnapshot step = all;
        step.version = ++all.version;
        renderer->apply(std::move(step));
        expectNoBuild(feature.name);
    }
    renderer->apply(dryStreet());
    expectNoBuild("the same level again");
}

TEST_F(CompileAheadTest, LeavesNoTraceInTheFirstImage) {
    begin(false);
    renderer->apply(dryStreet());
    const Image late = draw(streetCamera(0), 3);
    const uint64_t bytes = renderer->stats().textureBytes;
    begin(true);
    renderer->apply(dryStreet());
    const Image ahead = draw(streetCamera(0), 3);
    EXPECT_EQ(late.rgb, ahead.rgb);
    EXPECT_EQ(bytes, renderer->stats().textureBytes) << "what the scene does not use still costs memory";
}

class ProgramCacheTest : public CompileAheadTest {
protected:
    void begin() {
        RenderSettings settings;
        settings.programCache = folder();
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        target = std::make_unique<Offscreen>(kSize);
        renderer->apply(dryStreet());
    }
    std::string folder() const { return m_folder / "programs"; }
    /// Programs that the renderer compiled. create() loads the GL's functions again, so files tell instead of calls.
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> all;
        if (!std::filesystem::exists(folder())) return all;
        for (const auto& entry : std::filesystem::directory_iterator(folder())) all.push_back(entry.path());
        return all;
    }
    void SetUp() override {
        CompileAheadTest::SetUp();
        GLint formats = 0;
        glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
        if (formats == 0) GTEST_SKIP() << "this driver gives no binaries";
    }
    const TempFolder m_folder;
};

TEST_F(ProgramCacheTest, ALaterRunTakesItsProgramsFromTheFolder) {
    begin();
    const Image first = draw(streetCamera(0));
    const auto written = files();
    EXPECT_GT(written.size(), 10u);
    const auto longAgo = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1000);
    for (const auto& file : written) std::filesystem::last_write_time(file, longAgo);
    begin();
    EXPECT_EQ(draw(streetCamera(0)).rgb, first.rgb);
    for (const auto& file : files())
        EXPECT_LT(std::filesystem::last_write_time(file), longAgo + std::chrono::hours(1))
            << file << " was compiled again";
}

TEST_F(ProgramCacheTest, DamagedFilesAreReplaced) {
    begin();
    const Image first = draw(streetCamera(0));
    const auto written = files();
    for (size_t i = 0; i < written.size(); ++i) {
        if (i % 3 == 0) std::filesystem::resize_file(written[i], i);
        if (i % 3 == 1) {
            std::fstream file(written[i], std::ios::in | std::ios::out | std::ios::binary);
            file.seekp(100);
            file.write("damage", 6);
        }
    }
    begin();
    EXPECT_EQ(draw(streetCamera(0)).rgb, first.rgb);
    for (const auto& file : files()) EXPECT_GT(std::filesystem::file_size(file), 100u) << "is not written again";
}

TEST_F(ProgramCacheTest, WithoutAFolderNothingIsWritten) {
    CompileAheadTest::begin(false);
    EXPECT_TRUE(files().empty());
}

TEST_F(ProgramCacheTest, AFolderThatCannotBeMadeIsNotUsed) {
    std::ofstream(folder()) << "a file";
    begin();
    EXPECT_EQ(renderer->lastError(), "");
    draw(streetCamera(0));
}

}  // namespace
}  // namespace rubble
