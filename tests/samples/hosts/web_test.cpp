// The browser host plays its script in headless Chromium, and draws what the desktop draws.
#include <gtest/gtest.h>

#include <filesystem>

#include "generated/paths.h"
#include "render/gl/framebuffer.h"
#include "samples/hosts/support/own_meshes.h"
#include "samples/hosts/web/town.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "tests/abi/run_command.h"
#include "tests/reference/flip.h"
#include "tests/samples/hosts/host_run.h"

namespace rubble {
namespace {

const std::string kPage = RUBBLE_BINARY_DIR "/hosts/web/page";
const std::string kServe = "python3 " RUBBLE_SOURCE_DIR "/samples/hosts/web/serve.py ";
constexpr glm::ivec2 kSize(320, 240);
constexpr int kFrames = 17;  // as script.js draws for an image
constexpr int kCycle = 300;  // steps, as there

std::string missing() {
    const std::string page = missingFor(kPage + "/host_web.wasm", "emscripten by ./rubble host packages");
    return page.empty() ? missingFor("/usr/bin/chromium", "chromium") : page;
}

FloatImage readImage(const std::string& path) {
    const Result<Image> read = readPng(path);
    EXPECT_TRUE(read) << read.error();
    return read ? FloatImage({read->width, read->height}, read->rgb) : FloatImage();
}

/// The page's world on the desktop, as its images show it.
class Desktop {
public:
    Desktop() {
        rubble_host host{};
        host.struct_size = sizeof host;
        host.gl_get_proc_address = m_context->loader();
        rubble_world_settings settings{};
        settings.struct_size = sizeof settings;
        settings.flags = RUBBLE_WORLD_SHADOW_INLINE;
        const rubble_api* api = nullptr;
        rubble_world world = 0;
        EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, &api), RUBBLE_OK);
        EXPECT_EQ(api->set_host(&host), RUBBLE_OK);
        EXPECT_EQ(api->create_world(&settings, &world), RUBBLE_OK);
        yard_enter(&m_yard, (kPage + "/town.rubble").c_str(), &kTownStart, api, world);
        makeRenderer();
        make_own_meshes(m_context->loader(), "#version 330 core\n");
    }
    ~Desktop() {
        m_yard.api->destroy_renderer(m_renderer);
        yard_close(&m_yard);
        m_yard.api->set_host(nullptr);
    }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    yard& world() { return m_yard; }
    /// A new renderer, as after a context that was lost.
    void makeRenderer() {
        rubble_renderer_settings wanted{};
        wanted.struct_size = sizeof wanted;
        wanted.preset = "balanced";
        wanted.flags = RUBBLE_RENDERER_COMPILE_LATE;
        EXPECT_TRUE(!m_renderer || m_yard.api->destroy_renderer(m_renderer) == RUBBLE_OK);
        EXPECT_EQ(m_yard.api->create_renderer(m_yard.world, &wanted, &m_renderer), RUBBLE_OK);
    }
    void step(int count) {
        for (int i = 0; i < count; ++i) yard_step(&m_yard);
    }
    void writeImage(const std::string& path) {
        rubble_view view{};
        view.struct_size = sizeof view;
        view.flags = RUBBLE_VIEW_DEPTH;
        view.alpha = 1.0;
        view.framebuffer = m_framebuffer.name();
        view.width = kSize.x, view.height = kSize.y;
        yard_look(&m_yard, &view);
        for (int i = 0; i < kFrames; ++i) {
            m_framebuffer.begin();
            glClearColor(0.4f, 0.5f, 0.6f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            draw_own_meshes(&view, kTownPyramids, 0.02 * double(m_yard.steps));
            ASSERT_EQ(m_yard.api->draw(m_renderer, &view), RUBBLE_OK) << m_yard.api->get_last_error();
        }
        std::vector<uint8_t> rgba(size_t(4 * kSize.x * kSize.y));
        m_framebuffer.begin();
        glReadPixels(0, 0, kSize.x, kSize.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        Image image(kSize.x, kSize.y);
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                std::copy_n(&rgba[size_t(4 * ((kSize.y - 1 - y) * kSize.x + x))], 3,
                            &image.rgb[size_t(3 * (y * kSize.x + x))]);
        ASSERT_TRUE(writePng(path, image));
    }

private:
    static std::unique_ptr<GlContext> openContext() {
        auto context = GlContext::create(GlContext::Kind::OsMesa).value();
        EXPECT_TRUE(loadGl(context->loader()));
        return context;
    }
    std::unique_ptr<GlContext> m_context = openContext();
    yard m_yard{};
    rubble_renderer m_renderer = 0;
    Texture m_color{GL_RGBA8, kSize}, m_depth{GL_DEPTH_COMPONENT32F, kSize};
    Framebuffer m_framebuffer = Framebuffer(std::vector<const Texture*>{&m_color}, &m_depth);
};

double differenceOf(const std::string& first, const std::string& second) {
    return reference::flip(readImage(first), readImage(second));
}

TEST(HostWeb, BreaksTheTownAndDrawsItAsTheDesktopDoes) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    const std::string folder = hostFolder("web").string();
    const HostRun run = runHost(kServe + kPage + " --script " + folder + " size=320x240 cycles=3");
    expectGoodRun(run, 5);
    if (run.images.size() != 5) return;
    expectDifferent(run.images[0], run.images[1], 0.005);  // a hole
    expectDifferent(run.images[1], run.images[2], 0.01);   // an explosion
    EXPECT_LT(differenceOf(run.images[3].path, run.images[4].path), 0.05) << "after the context was lost";

    Desktop desktop;
    const auto expectSame = [&](const std::string& name, size_t other, double bound) {
        const std::string own = folder + "/desktop_" + name + ".png";
        desktop.writeImage(own);
        const double difference = differenceOf(own, run.images[other].path);
        EXPECT_LT(difference, bound) << name;
        std::printf("%s: FLIP %.4f\n", name.c_str(), difference);
    };
    desktop.step(2);
    expectSame("start", 0, 0.01);
    yard_shoot(&desktop.world());
    desktop.step(10);
    expectSame("hole", 1, 0.01);
    yard_explode(&desktop.world());
    desktop.step(15);
    expectSame("flying", 2, 0.05);
    desktop.step(kCycle - 27);
    expectSame("end", 3, 0.05);
    desktop.makeRenderer();
    desktop.step(1);
    expectSame("restored", 4, 0.01);
}

/// What a visitor downloads before the level.
TEST(HostWeb, IsASmallDownload) {
    if (const std::string why = missing(); !why.empty()) GTEST_SKIP() << why;
    uint64_t bytes = 0;
    for (const char* file : {"host_web.wasm", "host_web.js", "index.html", "page.js", "script.js"}) {
        int code = 0;
        bytes += std::stoull(runCommand("gzip -9 -c " + kPage + "/" + file + " | wc -c", code));
        EXPECT_EQ(code, 0);
    }
    EXPECT_LT(bytes, 2'000'000u);
    std::printf("%.2f MB compressed\n", double(bytes) * 1e-6);
}

}  // namespace
}  // namespace rubble
