#include "samples/lua/offscreen_view.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "samples/support/display.h"
#include "samples/support/image.h"

namespace lua_sample {
namespace {

constexpr int kFrames = 16;

}  // namespace

rubble_view viewOf(const Camera& camera, uint32_t width, uint32_t height) {
    const glm::dvec3 eye(camera.eye[0], camera.eye[1], camera.eye[2]);
    const glm::dvec3 target(camera.target[0], camera.target[1], camera.target[2]);
    const glm::dvec3 ahead = glm::normalize(target - eye);
    const glm::dvec3 up = std::abs(ahead.y) < 0.9999 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dquat turn = glm::quatLookAt(ahead, up);
    rubble_view view = {};
    view.struct_size = sizeof view;
    view.width = width, view.height = height;
    for (int i = 0; i < 3; ++i) view.position[i] = eye[i];
    view.rotation[0] = turn.x, view.rotation[1] = turn.y, view.rotation[2] = turn.z, view.rotation[3] = turn.w;
    view.vertical_fov = 0.9, view.alpha = 1.0;
    return view;
}

OffscreenView::OffscreenView() = default;
OffscreenView::~OffscreenView() = default;

std::string OffscreenView::open(const rubble_api& api, const rubble_view& view) {
    auto made = rubble::Display::inMemory({int(view.width), int(view.height)});
    if (!made) return made.error();
    m_api = &api;
    m_display = std::move(*made);
    rubble_host host = {};
    host.struct_size = sizeof host;
    host.gl_get_proc_address = m_display->loader();
    if (api.set_host(&host) != RUBBLE_OK) return api.get_last_error();
    m_view = view;
    m_view.framebuffer = m_display->framebuffer();
    return "";
}

std::string OffscreenView::begin(rubble_world world) {
    rubble_renderer_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    return m_api->create_renderer(world, &settings, &m_renderer) == RUBBLE_OK ? "" : m_api->get_last_error();
}

void OffscreenView::end() {
    if (m_renderer) m_api->destroy_renderer(std::exchange(m_renderer, 0));
}

std::string OffscreenView::write(const std::string& path) {
    rubble_result result = RUBBLE_OK;
    for (int i = 0; i < kFrames && result == RUBBLE_OK; ++i) result = m_api->draw(m_renderer, &m_view);
    std::string error = result == RUBBLE_OK ? "" : m_api->get_last_error();
    const auto written = rubble::writePng(path, m_display->read());
    if (!written) error = written.error();
    return error;
}

}  // namespace lua_sample
