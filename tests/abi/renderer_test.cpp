#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/gl/offscreen.h"
#include "runtime/core/constants.h"
#include "tests/abi/test_level.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr int kImageWidth = 64, kImageHeight = 36;

template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

/// A host with a GL context that has no window.
class AbiRenderer : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        auto host = sized<rubble_host>();
        host.gl_get_proc_address = testContext().loader();
        ASSERT_EQ(m_api->set_host(&host), RUBBLE_OK);
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
        ASSERT_EQ(m_api->create_world(&settings, &m_world), RUBBLE_OK) << m_api->get_last_error();
    }
    void TearDown() override {
        m_api->destroy_world(m_world);
        m_api->set_host(nullptr);
        GlTest::TearDown();
    }
    rubble_renderer_settings settings() const {
        auto settings = sized<rubble_renderer_settings>();
        settings.preset = "fast";
        settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
        return settings;
    }
    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
};

TEST_F(AbiRenderer, DrawsTheLevel) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    std::filesystem::remove(level);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    const rubble_renderer_settings given = settings();
    rubble_renderer renderer = 0, second = 0;
    ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
    EXPECT_EQ(m_api->create_renderer(m_world, &given, &second), RUBBLE_ERROR_ARGUMENT);
    EXPECT_EQ(m_api->set_debug_view(renderer, "no such pass"), RUBBLE_ERROR_ARGUMENT);

    const Offscreen target({kImageWidth, kImageHeight});
    auto view = sized<rubble_view>();
    view.framebuffer = target.framebuffer();
    view.width = kImageWidth;
    view.position[0] = 0.85, view.position[1] = 1.0, view.position[2] = 4.0;
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_ARGUMENT) << "a height of 0 was drawn";
    view.height = kImageHeight;
    glViewport(1, 2, 3, 4);
    ASSERT_EQ(m_api->draw(renderer, &view), RUBBLE_OK) << m_api->get_last_error();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 3) << "the host's state is not restored";

    const std::vector<uint8_t> image = target.readRgb();
    std::set<uint8_t> reds;
    for (size_t i = 0; i < image.size(); i += 3) reds.insert(image[i]);
    EXPECT_GT(reds.size(), 8u) << "the image has one colour";
    auto figures = sized<rubble_draw_stats>();
    ASSERT_EQ(m_api->get_draw_stats(renderer, &figures), RUBBLE_OK);
    EXPECT_EQ(figures.shapes, 1u);
    EXPECT_GT(figures.draw_calls, 0u);

    ASSERT_EQ(m_api->destroy_world(m_world), RUBBLE_OK);
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_STALE) << "the world is destroyed";
    EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_STALE);
}

TEST_F(AbiRenderer, AnotherRendererShowsTheWholeWorldFromTheNextStepOn) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    std::filesystem::remove(level);
    const rubble_renderer_settings given = settings();
    const Offscreen target({kImageWidth, kImageHeight});
    auto view = sized<rubble_view>();
    view.framebuffer = target.framebuffer();
    view.width = kImageWidth, view.height = kImageHeight;
    view.position[0] = 0.85, view.position[1] = 1.0, view.position[2] = 4.0;
    std::vector<uint8_t> images[2];
    for (std::vector<uint8_t>& image : images) {
        rubble_renderer renderer = 0;
        ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
        ASSERT_EQ(m_api->set_debug_view(renderer, "albedo"), RUBBLE_OK);
        EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_OK) << "before the step";
        auto figures = sized<rubble_draw_stats>();
        ASSERT_EQ(m_api->get_draw_stats(renderer, &figures), RUBBLE_OK);
        EXPECT_EQ(figures.shapes, 0u);
        ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
        ASSERT_EQ(m_api->draw(renderer, &view), RUBBLE_OK) << m_api->get_last_error();
        ASSERT_EQ(m_api->get_draw_stats(renderer, &figures), RUBBLE_OK);
        EXPECT_EQ(figures.shapes, 1u);
        EXPECT_GT(figures.bricks, 0u);
        image = target.readRgb();
        EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
    }
    EXPECT_EQ(images[0], images[1]);
}

TEST_F(AbiRenderer, AViewLeavesOutTheShapesThatItHides) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    std::filesystem::remove(level);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    rubble_shape_state state{};
    uint32_t count = 0;
    ASSERT_EQ(m_api->get_shape_states(m_world, 0, &state, 1, &count), RUBBLE_OK) << m_api->get_last_error();
    const rubble_renderer_settings given = settings();
    rubble_renderer renderer = 0;
    ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
    ASSERT_EQ(m_api->set_debug_view(renderer, "albedo"), RUBBLE_OK);
    const Offscreen target({kImageWidth, kImageHeight});
    auto view = sized<rubble_view>();
    view.framebuffer = target.framebuffer();
    view.width = kImageWidth, view.height = kImageHeight;
    view.position[0] = 0.85, view.position[1] = 1.0, view.position[2] = 4.0;
    const auto drawn = [&](std::initializer_list<rubble_shape> hidden, uint32_t slot = 0) {
        view.hidden_shapes = hidden.begin(), view.hidden_shape_count = uint32_t(hidden.size()), view.slot = slot;
        EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_OK) << m_api->get_last_error();
        return target.readRgb();
    };
    const std::vector<uint8_t> whole = drawn({}), without = drawn({state.shape}), other = drawn({}, 1);
    const auto colors = [](const std::vector<uint8_t>& image) {
        std::set<std::array<uint8_t, 3>> all;
        for (size_t i = 0; i < image.size(); i += 3) all.insert({image[i], image[i + 1], image[i + 2]});
        return all.size();
    };
    EXPECT_GT(colors(whole), 1u);
    EXPECT_EQ(colors(without), 1u) << "nothing is left to be seen";
    EXPECT_EQ(other, whole) << "another view hides what it says itself";
    EXPECT_EQ(drawn({state.shape}), without);
    EXPECT_GT(colors(drawn({})), 1u) << "it is there again";
    EXPECT_EQ(drawn({state.shape + (1u << 24)}, 2), whole) << "a handle that names nothing does no harm";
    view.hidden_shapes = nullptr;
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_NULL);
    const rubble_shape body = state.body;
    view.hidden_shapes = &body;
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_STALE) << "it is no shape";
    EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
}

TEST_F(AbiRenderer, AnAddedLightShowsAndARemovedOneDoesNot) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    std::filesystem::remove(level);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    auto night = sized<rubble_environment>();
    night.sun_direction[1] = -1.0;
    night.fog_distance = night.fog_height = night.exposure = 1.0;
    ASSERT_EQ(m_api->set_environment(m_world, &night), RUBBLE_OK) << m_api->get_last_error();
    rubble_light light = 0;
    uint32_t count = 0;
    ASSERT_EQ(m_api->get_lights(m_world, &light, 1, &count), RUBBLE_OK);
    ASSERT_EQ(m_api->remove_light(m_world, light), RUBBLE_OK) << m_api->get_last_error();

    const rubble_renderer_settings given = settings();
    rubble_renderer renderer = 0;
    ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
    ASSERT_EQ(m_api->set_debug_view(renderer, "denoisedLight"), RUBBLE_OK);
    const Offscreen target({kImageWidth, kImageHeight});
    auto view = sized<rubble_view>();
    view.framebuffer = target.framebuffer();
    view.width = kImageWidth, view.height = kImageHeight;
    view.position[0] = view.position[2] = 0.85, view.position[1] = 3.0;
    view.rotation[0] = -std::sqrt(0.5), view.rotation[3] = std::sqrt(0.5);  // straight down
    /// Radiance in the middle of the image, as passes/show_data.frag maps it.
    const auto lightAfter = [&](int frames) {
        EXPECT_EQ(m_api->step(m_world), RUBBLE_OK);
        for (int i = 0; i < frames; ++i) EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_OK) << m_api->get_last_error();
        const std::vector<uint8_t> image = target.readRgb();
        double sum = 0.0;
        for (int y = 12; y < 24; ++y)
            for (int x = 26; x < 38; ++x) sum += image[size_t(3 * (x + y * kImageWidth))];
        const double mapped = std::pow(sum / (12 * 12 * 255), 2.2);
        return mapped / (1.0 - mapped);
    };
    EXPECT_LT(lightAfter(20), 1e-4) << "the table is in the dark";
    auto torch = sized<rubble_light_settings>();
    torch.flags = RUBBLE_LIGHT_ENABLED;
    torch.position[0] = torch.position[2] = 0.85, torch.position[1] = 2.0;
    torch.color[0] = torch.color[1] = torch.color[2] = 10.0;
    torch.radius = 0.02, torch.reach = 50.0;
    for (int times = 0; times < 2; ++times) {
        ASSERT_EQ(m_api->add_light(m_world, &torch), RUBBLE_OK) << m_api->get_last_error();
        const double first = lightAfter(1), settled = lightAfter(20);
        EXPECT_NEAR(settled, 10.0 / kPi, 0.5) << "radiance of a white diffuse surface at 1 m: intensity / pi";
        EXPECT_GT(first, 0.9 * settled) << "the first frame shows it";
        ASSERT_EQ(m_api->get_lights(m_world, &light, 1, &count), RUBBLE_OK);
        ASSERT_EQ(m_api->remove_light(m_world, light), RUBBLE_OK) << m_api->get_last_error();
        EXPECT_LT(lightAfter(1), 0.05 * settled);
        EXPECT_LT(lightAfter(1), 0.01 * settled) << "the second frame no longer shows it";
        EXPECT_LT(lightAfter(20), 1e-4 * settled);
    }
    EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
}

TEST_F(AbiRenderer, ViewsInTurnAreDrawnAndTheStateIsResetWhereTheHostWantsThat) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    std::filesystem::remove(level);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    const TempFolder folder;
    const std::string cache = folder / "programs";
    rubble_renderer_settings given = settings();
    given.flags |= RUBBLE_RENDERER_RESET_STATE;
    given.program_cache = cache.c_str();
    rubble_renderer renderer = 0;
    ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
    const Offscreen target({kImageWidth, kImageHeight});
    auto view = sized<rubble_view>();
    view.framebuffer = target.framebuffer();
    view.width = kImageWidth, view.height = kImageHeight;
    view.slot = 16;
    EXPECT_EQ(m_api->draw(renderer, &view), RUBBLE_ERROR_ARGUMENT);
    glEnable(GL_RASTERIZER_DISCARD);
    for (view.slot = 0; view.slot < 3; ++view.slot) ASSERT_EQ(m_api->draw(renderer, &view), RUBBLE_OK);
    EXPECT_FALSE(glIsEnabled(GL_RASTERIZER_DISCARD));
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    EXPECT_EQ(std::filesystem::exists(cache) && !std::filesystem::is_empty(cache), formats > 0);
    EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
}

TEST_F(AbiRenderer, SaysWhichShaderFolderIsMissing) {
    rubble_renderer_settings given = settings();
    given.shader_folder = "no/such/folder";
    rubble_renderer renderer = 1;
    EXPECT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_ERROR_GL);
    EXPECT_NE(std::string(m_api->get_last_error()).find("no/such/folder"), std::string::npos)
        << m_api->get_last_error();
    EXPECT_EQ(renderer, 0u);
}

/// A driver that knows its version and nothing else.
template <const char* kVersion>
void* functionOf(const char* name) {
    static constexpr auto getString = +[](unsigned) { return reinterpret_cast<const unsigned char*>(kVersion); };
    static constexpr auto getInteger = +[](unsigned, int* out) { *out = 1; };
    static constexpr auto getIndexed = +[](unsigned, unsigned) { return reinterpret_cast<const unsigned char*>(""); };
    const std::string_view wanted = name;
    if (wanted == "glGetString") return reinterpret_cast<void*>(getString);
    if (wanted == "glGetIntegerv") return reinterpret_cast<void*>(getInteger);
    return wanted == "glGetStringi" ? reinterpret_cast<void*>(getIndexed) : nullptr;
}
constexpr char kEmbedded[] = "OpenGL ES 3.2 Mesa", kOldEmbedded[] = "OpenGL ES 2.0 Mesa", kOld[] = "3.1 Mesa";

TEST_F(AbiRenderer, AContextOfTheWrongKindIsNamed) {
    const std::pair<void* (*)(const char*), const char*> wrong[] = {
        {functionOf<kEmbedded>, "expected the extension EXT_color_buffer_float, which OpenGL ES 3.2 Mesa lacks"},
        {functionOf<kOldEmbedded>, "OpenGL ES: expected 3.0 or newer, found OpenGL ES 2.0 Mesa"},
        {functionOf<kOld>, "expected 3.3 or newer, found 3.1 Mesa"}};
    for (const auto& [loader, text] : wrong) {
        auto host = sized<rubble_host>();
        host.gl_get_proc_address = loader;
        ASSERT_EQ(m_api->set_host(&host), RUBBLE_OK);
        rubble_renderer renderer = 0;
        const rubble_renderer_settings wanted = settings();
        EXPECT_EQ(m_api->create_renderer(m_world, &wanted, &renderer), RUBBLE_ERROR_GL);
        EXPECT_NE(std::string(m_api->get_last_error()).find(text), std::string::npos) << m_api->get_last_error();
    }
}

TEST_F(AbiRenderer, TakesSoManyImagesAndNoMore) {
    const std::string level = writeTestLevel();
    ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
    const auto given = settings();
    rubble_renderer renderer = 0;
    ASSERT_EQ(m_api->create_renderer(m_world, &given, &renderer), RUBBLE_OK) << m_api->get_last_error();
    const uint8_t white[4] = {255, 255, 255, 255};
    auto image = sized<rubble_overlay_image>();
    image.width = image.height = 1, image.pixels = white;
    const auto set = [&](const std::string& name) {
        image.name = name.c_str();
        return m_api->set_overlay_image(renderer, &image);
    };
    for (int i = 0; i < 4096; ++i) ASSERT_EQ(set(std::to_string(i)), RUBBLE_OK) << m_api->get_last_error();
    EXPECT_EQ(set("one more"), RUBBLE_ERROR_CAPACITY);
    EXPECT_STREQ(m_api->get_last_error(), "set_overlay_image: there are 4096 images already; take one away first");
    EXPECT_EQ(set("7"), RUBBLE_OK) << "it is replaced";
    image.pixels = nullptr;
    EXPECT_EQ(set("8"), RUBBLE_OK);
    image.pixels = white;
    EXPECT_EQ(set("one more"), RUBBLE_OK) << m_api->get_last_error();
    EXPECT_EQ(m_api->destroy_renderer(renderer), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
