#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <memory>

#include "runtime/script/binding/script_context.h"
#include "samples/stress/checks/check.h"
#include "samples/stress/report.h"
#include "samples/stress/results.h"
#include "samples/support/display.h"
#include "samples/support/image.h"

namespace stress {
namespace {

using rubble::script::sized;

constexpr int kWidth = 480, kHeight = 270;
constexpr int kFrames = 8;  // of the same step, so that light settles

/// A world with a renderer, and the view of it.
class Camera {
public:
    Camera(const rubble_api& api, unsigned framebuffer) : m_api(api) {
        m_view = sized<rubble_view>();
        m_view.framebuffer = framebuffer;
        m_view.width = kWidth, m_view.height = kHeight;
        m_view.alpha = 1.0;
        m_view.vertical_fov = 0.8;
    }
    ~Camera() {
        if (m_renderer) m_api.destroy_renderer(m_renderer);
        if (m_world) m_api.destroy_world(m_world);
    }
    Camera(const Camera&) = delete;
    Camera& operator=(const Camera&) = delete;

    /// False: get_last_error() says why.
    bool draw(const std::vector<uint8_t>& game) {
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
        auto renderer = sized<rubble_renderer_settings>();
        if (m_api.create_world(&settings, &m_world) != RUBBLE_OK ||
            m_api.load_game_data(m_world, game.data(), game.size()) != RUBBLE_OK || m_api.step(m_world) != RUBBLE_OK ||
            m_api.create_renderer(m_world, &renderer, &m_renderer) != RUBBLE_OK)
            return false;
        lookAtAll();
        for (int frame = 0; frame < kFrames; ++frame)
            if (m_api.draw(m_renderer, &m_view) != RUBBLE_OK) return false;
        return true;
    }

private:
    template <class Value>
    static double median(const std::vector<glm::dvec3>& centers, Value&& value) {
        std::vector<double> values;
        for (const glm::dvec3& center : centers) values.push_back(value(center));
        std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
        return values[values.size() / 2];
    }

    /// Looks at the middle of the shapes, from so far that most of them are seen.
    void lookAtAll() {
        std::vector<glm::dvec3> centers;
        const auto bodies =
            readRows<rubble_body_state>([&](rubble_body_state* out, uint32_t capacity, uint32_t* count) {
                return m_api.get_body_states(m_world, out, capacity, count);
            });
        for (const rubble_body_state& body : bodies)
            for (const rubble_shape_state& shape : shapesOf(m_api, m_world, body.body)) {
                const glm::dvec3 half =
                    0.5 * shape.voxel_size * glm::dvec3(shape.size[0], shape.size[1], shape.size[2]);
                const glm::dquat turn(shape.rotation[3], shape.rotation[0], shape.rotation[1], shape.rotation[2]);
                const glm::dvec3 corner(shape.position[0], shape.position[1], shape.position[2]);
                centers.push_back(corner + turn * half);
            }
        if (centers.empty()) centers.emplace_back(0.0);
        glm::dvec3 middle(0.0);
        for (int axis = 0; axis < 3; ++axis)
            middle[axis] = median(centers, [&](const glm::dvec3& center) { return center[axis]; });
        const double spread = median(centers, [&](const glm::dvec3& center) { return glm::length(center - middle); });
        const glm::dvec3 eye = middle + glm::normalize(glm::dvec3(0.6, 0.5, 1.0)) * std::clamp(2.5 * spread, 6.0, 80.0);
        const glm::dquat turn = glm::quatLookAt(glm::normalize(middle - eye), glm::dvec3(0.0, 1.0, 0.0));
        for (int i = 0; i < 3; ++i) m_view.position[i] = eye[i];
        m_view.rotation[0] = turn.x, m_view.rotation[1] = turn.y, m_view.rotation[2] = turn.z,
        m_view.rotation[3] = turn.w;
    }

    const rubble_api& m_api;
    rubble_world m_world = 0;
    rubble_renderer m_renderer = 0;
    rubble_view m_view;
};

}  // namespace

std::string drawGames(const rubble_api& api, const RunSettings& settings, const RunResult& result) {
    const auto display = rubble::Display::inMemory({kWidth, kHeight});
    if (!display) return "no images: " + display.error();
    auto host = sized<rubble_host>();
    host.gl_get_proc_address = (*display)->loader();
    api.set_host(&host);
    for (size_t i = 0; i < result.games.size(); ++i) {
        Camera camera(api, (*display)->framebuffer());
        if (!camera.draw(result.games[i])) return fmt::format("no image: {}", api.get_last_error());
        const std::string path = resultPath(settings, fmt::format("_{}.png", i + 1));
        if (const auto written = rubble::writePng(path, (*display)->read()); !written) return written.error();
    }
    return {};
}

}  // namespace stress
