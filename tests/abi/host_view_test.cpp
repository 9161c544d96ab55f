// Views with a host's own projection, which compose with the host's depth.
#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "tests/abi/test_level.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

constexpr int kWidth = 96, kHeight = 54;
constexpr double kNear = 0.1, kFar = 200.0;

using Matrix = std::array<double, 16>;

/// What a host may ask of depth: its matrix for a view that is `shift` of half its size off-centre.
struct Convention {
    const char* name;
    bool isReversed, isInfinite, isZeroToOne;
    bool isOrthographic = false;
    double near = kNear, far = kFar;               ///< metres to the planes of a perspective
    double start = isOrthographic ? -20.0 : near;  ///< metres to the near plane

    Matrix projection(double shiftX, double shiftY) const {
        const double nearest = isZeroToOne ? 0.0 : -1.0, from = isReversed ? 1.0 : nearest,
                     to = isReversed ? nearest : 1.0;  // clip depth of the near and of the far plane
        Matrix p = {};
        if (isOrthographic) {
            p[0] = 0.4, p[5] = 0.4 * kWidth / kHeight, p[12] = -shiftX, p[13] = -shiftY, p[15] = 1.0;
            // p14 - p10 d is `from` at the near plane and `to` at the far one.
            p[10] = (from - to) / (kFar - start);
            p[14] = from + p[10] * start;
            return p;
        }
        p[0] = 1.2, p[5] = 1.2 * kWidth / kHeight, p[8] = shiftX, p[9] = shiftY, p[11] = -1.0;
        // (p10 z + p14) / -z is `from` at the near plane and `to` at the far one.
        p[10] = isInfinite ? -to : (from * near - to * far) / (far - near);
        p[14] = isInfinite ? (from - to) * near : (from - to) * near * far / (far - near);
        return p;
    }
    double windowDepth(const Matrix& p, double metres) const {
        const double clip = (p[10] * -metres + p[14]) / (isOrthographic ? 1.0 : metres);
        return isZeroToOne ? clip : clip * 0.5 + 0.5;
    }
    double farthest() const { return isReversed ? 0.0 : 1.0; }
};

/// A framebuffer of a host: colours of 16 bits, a depth of 32.
class HostTarget {
public:
    /// Needs the context, which must be current.
    explicit HostTarget(GlContext&) {
        glGenFramebuffers(1, &m_framebuffer);
        glGenRenderbuffers(2, m_buffers);
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        attach(0, GL_RGBA16F, GL_COLOR_ATTACHMENT0);
        attach(1, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    }
    ~HostTarget() {
        glDeleteFramebuffers(1, &m_framebuffer);
        glDeleteRenderbuffers(2, m_buffers);
    }
    HostTarget(const HostTarget&) = delete;
    HostTarget& operator=(const HostTarget&) = delete;
    /// Fills it with what a wall across the view at one depth would draw.
    void fill(double windowDepth) const {
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glClearColor(1.0f, 0.0f, 1.0f, 1.0f);
        glClearDepth(windowDepth);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glClearDepth(1.0);
    }
    std::vector<float> colors() const { return read(GL_RGB, 3); }
    std::vector<float> depths() const { return read(GL_DEPTH_COMPONENT, 1); }
    unsigned framebuffer() const { return m_framebuffer; }

private:
    void attach(int buffer, GLenum format, GLenum attachment) const {
        glBindRenderbuffer(GL_RENDERBUFFER, m_buffers[buffer]);
        glRenderbufferStorage(GL_RENDERBUFFER, format, kWidth, kHeight);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, m_buffers[buffer]);
    }
    std::vector<float> read(GLenum format, int channels) const {
        std::vector<float> values(size_t(kWidth * kHeight * channels));
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glReadPixels(0, 0, kWidth, kHeight, format, GL_FLOAT, values.data());
        return values;
    }
    GLuint m_framebuffer = 0, m_buffers[2] = {};
};

class HostView : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        rubble_host host = {};
        host.struct_size = sizeof host;
        host.gl_get_proc_address = testContext().loader();
        ASSERT_EQ(m_api->set_host(&host), RUBBLE_OK);
        rubble_world_settings settings = {};
        settings.struct_size = sizeof settings;
        settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
        ASSERT_EQ(m_api->create_world(&settings, &m_world), RUBBLE_OK) << m_api->get_last_error();
        const std::string level = writeTestLevel();
        ASSERT_EQ(m_api->load_level(m_world, level.c_str(), nullptr), RUBBLE_OK) << m_api->get_last_error();
        std::filesystem::remove(level);
        ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
        makeRenderer("balanced");  // traces every pixel that it shows
    }
    void makeRenderer(const char* preset) {
        rubble_renderer_settings given = {};
        given.struct_size = sizeof given;
        given.preset = preset;
        given.flags = RUBBLE_RENDERER_COMPILE_LATE;
        ASSERT_EQ(m_api->create_renderer(m_world, &given, &m_renderer), RUBBLE_OK) << m_api->get_last_error();
    }
    void TearDown() override {
        m_api->destroy_renderer(m_renderer);
        m_api->destroy_world(m_world);
        m_api->set_host(nullptr);
        GlTest::TearDown();
    }
    rubble_view view(uint32_t flags) const {
        rubble_view view = {};
        view.struct_size = sizeof view;
        view.flags = RUBBLE_VIEW_CUT | flags;
        view.framebuffer = m_target.framebuffer();
        view.width = kWidth, view.height = kHeight;
        view.position[0] = 0.85, view.position[1] = 1.6, view.position[2] = 3.5;
        view.rotation[0] = -0.15, view.rotation[3] = std::sqrt(1.0 - 0.15 * 0.15);
        return view;
    }
    rubble_view view(uint32_t flags, const Matrix& projection) const {
        rubble_view made = view(flags);
        std::copy(projection.begin(), projection.end(), made.projection);
        return made;
    }
    /// Depth along the view axis of what a point of the image shows, x and y in pixels from its lower left corner.
    /// Infinite: the sky.
    double depthAt(const rubble_view& view, double x, double y) const {
        const double* p = view.projection;
        const double column = x / kWidth * 2.0 - 1.0, row = y / kHeight * 2.0 - 1.0;
        const bool isOrthographic = p[15] == 1.0;
        using Vector = std::array<double, 3>;
        const Vector across = {(column + p[8] - p[12]) / p[0], (row + p[9] - p[13]) / p[5], 0.0}, ahead = {0, 0, -1};
        const auto turned = [&](const Vector& v) -> Vector {  // about x alone
            const double s = view.rotation[0], c = view.rotation[3], cosine = c * c - s * s, sine = 2.0 * s * c;
            return {v[0], cosine * v[1] - sine * v[2], sine * v[1] + cosine * v[2]};
        };
        const auto sum = [](const Vector& a, const Vector& b) -> Vector {
            return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
        };
        constexpr double kBefore = 15.0;  // metres before the eye at which parallel rays begin
        const Vector eye = {view.position[0], view.position[1], view.position[2]};
        const Vector from = isOrthographic ? sum(eye, turned({across[0], across[1], kBefore})) : eye;
        const Vector direction = turned(isOrthographic ? ahead : sum(across, ahead));
        rubble_hit hit = {};
        EXPECT_EQ(m_api->cast_ray(m_world, from.data(), direction.data(), 1000.0, &hit), RUBBLE_OK);
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        if (!hit.hit) return std::numeric_limits<double>::infinity();
        return isOrthographic ? hit.distance - kBefore : hit.distance / length;
    }
    /// The least and the greatest depth within a pixel.
    std::array<double, 2> depthsIn(const rubble_view& view, int x, int y) const {
        std::array<double, 2> range = {std::numeric_limits<double>::infinity(), 0.0};
        for (const double dx : {0.02, 0.5, 0.98})
            for (const double dy : {0.02, 0.5, 0.98}) {
                const double depth = depthAt(view, x + dx, y + dy);
                range = {std::min(range[0], depth), std::max(range[1], depth)};
            }
        return range;
    }

    /// Draws over a wall across the view and expects each pixel to show what is nearer in it.
    void expectComposed(const Convention& convention, double shift) {
        constexpr double kWall = 3.4;  // metres: through the middle of the table
        SCOPED_TRACE(std::string(convention.name) + ", off-centre by " + std::to_string(shift));
        const Matrix projection = convention.projection(shift, -0.5 * shift);
        const rubble_view view = this->view(
            RUBBLE_VIEW_DEPTH | (convention.isZeroToOne ? uint32_t(RUBBLE_VIEW_ZERO_TO_ONE) : 0u), projection);
        const double wall = convention.windowDepth(projection, kWall);
        m_target.fill(wall);
        ASSERT_EQ(m_api->draw(m_renderer, &view), RUBBLE_OK) << m_api->get_last_error();
        const std::vector<float> colors = m_target.colors(), depths = m_target.depths();
        int before = 0, behind = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const size_t pixel = size_t(y * kWidth + x);
                const auto [nearest, farthest] = depthsIn(view, x, y);
                const bool isWall = colors[3 * pixel] == 1.0f && colors[3 * pixel + 1] == 0.0f;
                if (nearest > kWall) {
                    ++behind;
                    EXPECT_TRUE(isWall) << x << ", " << y << ": what lies at " << nearest << " m hides the wall";
                    EXPECT_EQ(depths[pixel], float(wall)) << x << ", " << y;
                } else if (farthest < kWall) {
                    ++before;
                    EXPECT_FALSE(isWall) << x << ", " << y << ": the wall hides what lies at " << farthest << " m";
                    const auto depth = [&](double metres) {  // which ends at the planes
                        return std::clamp(convention.windowDepth(projection, metres), 0.0, 1.0);
                    };
                    const double a = depth(nearest), b = depth(farthest);
                    EXPECT_GE(depths[pixel], std::min(a, b) - 1e-5) << x << ", " << y;
                    EXPECT_LE(depths[pixel], std::max(a, b) + 1e-5) << x << ", " << y;
                }
            }
        EXPECT_GT(before, 200);
        EXPECT_GT(behind, 2000);
    }

    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
    rubble_renderer m_renderer = 0;
    HostTarget m_target{testContext()};
};

constexpr Convention kConventions[] = {{"usual", false, false, false},
                                       {"infinite", false, true, false},
                                       {"zero to one", false, false, true},
                                       {"reversed", true, false, true},
                                       {"reversed and infinite", true, true, true},
                                       {"reversed in -1 to 1", true, false, false},
                                       {"from 1 cm to 10 km", false, false, false, false, 0.01, 1e4},
                                       {"from 0.1 mm to 1,000 km, reversed", true, false, true, false, 1e-4, 1e6},
                                       {"from 3 m to 4 m", false, false, true, false, 3.0, 4.0},
                                       {"orthographic", false, false, false, true},
                                       {"orthographic, zero to one", false, false, true, true},
                                       {"orthographic, reversed", true, false, true, true}};

TEST_F(HostView, DepthComposesToThePixelInEveryConvention) {
    for (const Convention& convention : kConventions)
        for (const double shift : {0.0, 0.35}) expectComposed(convention, shift);
}

TEST_F(HostView, DepthComposesToThePixelWhereFewerPixelsAreTraced) {
    ASSERT_EQ(m_api->destroy_renderer(m_renderer), RUBBLE_OK);
    makeRenderer("fast");
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    for (const Convention& convention : kConventions) expectComposed(convention, 0.35);
}

TEST_F(HostView, ScopesAndPanoramasAreDrawn) {
    for (const double scale : {1e-3, 0.05, 300.0, 1e4}) {
        Matrix projection = Convention{"", false, false, false}.projection(0.0, 0.0);
        projection[0] = projection[5] = scale;
        rubble_view view = this->view(0, projection);
        m_target.fill(0.5);
        for (int i = 0; i < 2; ++i, view.flags = 0)
            ASSERT_EQ(m_api->draw(m_renderer, &view), RUBBLE_OK) << scale << ": " << m_api->get_last_error();
        const std::vector<float> colors = m_target.colors();
        const double hit = depthAt(view, kWidth * 0.5, kHeight * 0.5);
        EXPECT_LT(hit, 10.0) << "the table is in the middle";
        for (const float value : colors) ASSERT_TRUE(std::isfinite(value)) << scale;
        const size_t middle = 3 * size_t(kHeight / 2 * kWidth + kWidth / 2);
        if (scale > 1.0) {
            EXPECT_GT(colors[middle], 1.1f * colors[middle + 2]) << scale << ": the table is red";
        }
    }
}

TEST_F(HostView, TheSkyLiesBehindEverything) {
    for (const Convention& convention : {Convention{"", false, true, true},
                                         Convention{"", true, true, true},
                                         Convention{"", false, false, true, true},
                                         {"", true, false, true, true}}) {
        const Matrix projection = convention.projection(0.0, 0.0);
        const rubble_view view = this->view(RUBBLE_VIEW_DEPTH | RUBBLE_VIEW_ZERO_TO_ONE, projection);
        m_target.fill(convention.farthest());
        ASSERT_EQ(m_api->draw(m_renderer, &view), RUBBLE_OK) << m_api->get_last_error();
        const std::vector<float> colors = m_target.colors(), depths = m_target.depths();
        for (size_t pixel = 0; pixel < depths.size(); ++pixel)
            ASSERT_FALSE(colors[3 * pixel] == 1.0f && colors[3 * pixel + 1] == 0.0f) << "a pixel was not drawn";
        EXPECT_EQ(depths.back(), float(convention.farthest())) << "the sky has a depth";
    }
}

TEST_F(HostView, AProjectionInTheMiddleDrawsWhatAFieldOfViewDraws) {
    rubble_view byAngle = view(0);
    byAngle.vertical_fov = 0.9;
    ASSERT_EQ(m_api->draw(m_renderer, &byAngle), RUBBLE_OK);
    const std::vector<float> expected = m_target.colors();
    Matrix projection = Convention{"", true, true, true}.projection(0.0, 0.0);
    projection[5] = 1.0 / std::tan(0.45), projection[0] = projection[5] * kHeight / kWidth;
    const rubble_view byMatrix = view(0, projection);
    ASSERT_EQ(m_api->draw(m_renderer, &byMatrix), RUBBLE_OK);
    const std::vector<float> found = m_target.colors();
    double worst = 0.0;
    for (size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(double(found[i]) - double(expected[i])));
    EXPECT_LT(worst, 0.02);
}

TEST_F(HostView, AnOffCentreViewShowsItsPartOfAWiderOne) {
    ASSERT_EQ(m_api->set_debug_view(m_renderer, "radiance"), RUBBLE_OK);  // exposure follows the whole image
    constexpr int kPart = 64;                                             // the noise of rays repeats after as many
    Matrix projection = Convention{"", false, false, false}.projection(0.0, 0.0);
    rubble_view wide = view(0, projection);
    wide.width = 2 * kPart;
    const Offscreen all({2 * kPart, kHeight}), right({kPart, kHeight});
    wide.framebuffer = all.framebuffer();
    ASSERT_EQ(m_api->draw(m_renderer, &wide), RUBBLE_OK) << m_api->get_last_error();
    projection[0] *= 2.0, projection[8] = 1.0;
    rubble_view part = view(0, projection);
    part.width = kPart, part.framebuffer = right.framebuffer();
    ASSERT_EQ(m_api->draw(m_renderer, &part), RUBBLE_OK) << m_api->get_last_error();
    const std::vector<uint8_t> expected = all.readRgb(), found = right.readRgb();
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 8; x < kPart; ++x)  // filters of the wide image look over its middle
            for (int i = 0; i < 3; ++i)
                sum += std::abs(int(found[size_t(3 * (y * kPart + x) + i)]) -
                                int(expected[size_t(3 * ((2 * y + 1) * kPart + x) + i)]));
    EXPECT_LT(sum / (255.0 * 3 * kHeight * (kPart - 8)), 0.003);
}

TEST_F(HostView, AFlippedViewIsTheSameUpsideDown) {
    rubble_view upright = view(0), flipped = view(RUBBLE_VIEW_FLIP_Y);
    ASSERT_EQ(m_api->draw(m_renderer, &upright), RUBBLE_OK);
    const std::vector<float> expected = m_target.colors();
    ASSERT_EQ(m_api->draw(m_renderer, &flipped), RUBBLE_OK);
    const std::vector<float> found = m_target.colors();
    for (int y = 0; y < kHeight; ++y)
        for (int i = 0; i < 3 * kWidth; ++i)
            ASSERT_EQ(found[size_t(y * 3 * kWidth + i)], expected[size_t((kHeight - 1 - y) * 3 * kWidth + i)]) << y;
}

TEST_F(HostView, ALinearViewGivesRadianceTimesExposure) {
    rubble_view display = view(0), linear = view(RUBBLE_VIEW_LINEAR);
    rubble_environment environment = {};
    environment.struct_size = sizeof environment;
    ASSERT_EQ(m_api->get_environment(m_world, &environment), RUBBLE_OK);
    std::vector<float> images[3];
    ASSERT_EQ(m_api->draw(m_renderer, &display), RUBBLE_OK);
    images[0] = m_target.colors();
    ASSERT_EQ(m_api->draw(m_renderer, &linear), RUBBLE_OK);
    images[1] = m_target.colors();
    for (const float value : images[0]) ASSERT_LE(value, 1.0f);
    // A sun and sky of ten times the light: the display's colours end at 1, radiance does not.
    for (double* color : {environment.sun_color, environment.sky_color, environment.horizon_color})
        for (int i = 0; i < 3; ++i) color[i] *= 10.0;
    ASSERT_EQ(m_api->set_environment(m_world, &environment), RUBBLE_OK);
    ASSERT_EQ(m_api->step(m_world), RUBBLE_OK);
    ASSERT_EQ(m_api->draw(m_renderer, &linear), RUBBLE_OK);
    images[2] = m_target.colors();
    double sums[3] = {};
    for (int image = 0; image < 3; ++image)
        for (const float value : images[image]) sums[image] += double(value);
    EXPECT_GT(sums[2], 2.0 * sums[1]);
    EXPECT_GT(*std::max_element(images[2].begin(), images[2].end()), 1.5f);
}

TEST_F(HostView, OnlyAViewForADisplayAdaptsItsExposure) {
    rubble_environment environment = {};
    environment.struct_size = sizeof environment;
    ASSERT_EQ(m_api->get_environment(m_world, &environment), RUBBLE_OK);
    const auto brightness = [&](double exposure, uint32_t flags) {
        environment.exposure = exposure;
        EXPECT_EQ(m_api->set_environment(m_world, &environment), RUBBLE_OK);
        EXPECT_EQ(m_api->step(m_world), RUBBLE_OK);
        const rubble_view cut = view(flags | RUBBLE_VIEW_CUT);
        EXPECT_EQ(m_api->draw(m_renderer, &cut), RUBBLE_OK);
        double sum = 0.0;
        for (const float value : m_target.colors()) sum += double(value);
        return sum;
    };
    const double linear = brightness(1.0, RUBBLE_VIEW_LINEAR);
    EXPECT_NEAR(brightness(0.05, RUBBLE_VIEW_LINEAR) / linear, 0.05, 0.002);
    EXPECT_NEAR(brightness(0.05, RUBBLE_VIEW_LINEAR | RUBBLE_VIEW_FIXED_EXPOSURE) / linear, 0.05, 0.002);
    EXPECT_GT(brightness(0.05, 0), 1.3 * brightness(0.05, RUBBLE_VIEW_FIXED_EXPOSURE));
}

TEST_F(HostView, WhatCannotBeComposedIsRefused) {
    const Matrix good = Convention{"", false, false, false}.projection(0.0, 0.0);
    const auto refused = [&](rubble_view view, rubble_result expected, const char* said) {
        EXPECT_EQ(m_api->draw(m_renderer, &view), expected) << said;
        EXPECT_NE(std::string(m_api->get_last_error()).find(said), std::string::npos) << m_api->get_last_error();
    };
    refused(view(RUBBLE_VIEW_DEPTH), RUBBLE_ERROR_ARGUMENT, "view->projection is zero");
    Matrix oblique = good;
    oblique[11] = -0.5;
    refused(view(0, oblique), RUBBLE_ERROR_ARGUMENT, "view->projection[11] is -0.5, expected -1");
    Matrix orthographic = Convention{"", false, false, false, true}.projection(0.0, 0.0);
    orthographic[8] = 0.25;
    refused(view(0, orthographic), RUBBLE_ERROR_ARGUMENT, "view->projection[8] is 0.25, expected 0");
    orthographic[8] = 0.0, orthographic[10] = 0.0;
    refused(view(RUBBLE_VIEW_DEPTH, orthographic), RUBBLE_ERROR_ARGUMENT, "view->projection[10]");
    orthographic[10] = 1e-9;
    refused(view(RUBBLE_VIEW_DEPTH, orthographic), RUBBLE_ERROR_ARGUMENT, "near plane");
    Matrix mirrored = good;
    mirrored[5] = -mirrored[5];
    refused(view(0, mirrored), RUBBLE_ERROR_ARGUMENT, "along y");
    Matrix narrow = good;
    narrow[0] = 2e4;
    refused(view(0, narrow), RUBBLE_ERROR_ARGUMENT, "expected 0.001 to 10000");
    Matrix flat = good;
    flat[14] = 0.0;
    refused(view(RUBBLE_VIEW_DEPTH, flat), RUBBLE_ERROR_ARGUMENT, "view->projection[14]");
    Matrix unreal = good;
    unreal[9] = std::numeric_limits<double>::quiet_NaN();
    refused(view(0, unreal), RUBBLE_ERROR_ARGUMENT, "view->projection[9]");
    glBindFramebuffer(GL_FRAMEBUFFER, m_target.framebuffer());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);
    refused(view(RUBBLE_VIEW_DEPTH, good), RUBBLE_ERROR_GL, "expected a depth buffer");
}

}  // namespace
}  // namespace rubble
