#include "samples/netplay/app/player_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "samples/netplay/player.h"

namespace netplay {
namespace {

constexpr double kPull = 0.1;   // part of the way to where the server has the player, in a step
constexpr double kSlow = 0.5;   // of the fastest, unless the player is in a hurry
constexpr double kJump = 10.0;  // metres from there, from which on the camera does not fly but is there

/// Colours of players by their numbers, linear.
constexpr double kColors[][3] = {{1.0, 0.1, 0.05}, {0.05, 0.3, 1.0}, {0.1, 0.9, 0.1}, {1.0, 0.6, 0.0}, {0.8, 0.1, 0.9}};

glm::dvec3 toGlm(const Vec3& value) {
    return {value[0], value[1], value[2]};
}

rubble::Renderer makeRenderer(rubble::World& world, const Screen& screen, const char* preset) {
    rubble_host host{};
    host.gl_get_proc_address = screen.loader();
    rubble::set_host(host);
    rubble_renderer_settings settings{};
    settings.preset = preset;
    return rubble::Renderer(world, settings);
}

}  // namespace

rubble_world_settings drawnWorld() {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_HOST_PHYSICS | RUBBLE_WORLD_WAIT_FOR_SHADOW;
    return settings;
}

PlayerView::PlayerView(rubble::World& world, Client& client, Screen& screen, const char* preset)
    : m_world(world), m_client(client), m_screen(screen), m_renderer(makeRenderer(world, screen, preset)) {}

void PlayerView::act(const rubble::PlayerInput& input, Tool tool, bool isUsing) {
    m_camera.turn(input);
    m_velocity = m_camera.flight(input) * (kPlayerSpeed * (input.fast ? 1.0 : kSlow));
    m_client.move({m_velocity.x, m_velocity.y, m_velocity.z});
    if (isUsing) use(tool);
}

/// The server casts the ray from where it has the player, which is not quite where the camera is: so the ray goes to
/// what the player sees.
void PlayerView::use(Tool tool) {
    const glm::dvec3 ahead = m_camera.forward();
    const double origin[3] = {m_camera.position.x, m_camera.position.y, m_camera.position.z};
    const double direction[3] = {ahead.x, ahead.y, ahead.z};
    const rubble_hit hit = m_world.cast_ray(origin, direction, kReach);
    if (!hit.hit) return;
    const Vec3& from = m_client.position();
    m_client.ask(tool, {hit.position[0] - from[0], hit.position[1] - from[1], hit.position[2] - from[2]});
}

/// The camera answers the player at once, and is drawn to where the server has him: both end at the same place.
void PlayerView::follow() {
    if (m_client.state() != Client::State::Playing || m_client.players().empty()) return;
    const glm::dvec3 there = toGlm(m_client.position());
    m_camera.position += m_velocity / double(kStepsPerSecond);
    if (!m_isPlaced || glm::distance(m_camera.position, there) > kJump) m_camera.position = there;
    if (!std::exchange(m_isPlaced, true)) lookAt({0.0, 3.0, 0.0});
    m_camera.position += (there - m_camera.position) * kPull;
    showOthers();
}

void PlayerView::showOthers() {
    for (const Poses::Player& player : m_client.players()) {
        if (player.player == m_client.player()) continue;
        rubble_particle_burst cloud{};
        cloud.kind = RUBBLE_PARTICLE_SPARK;
        cloud.count = 10;
        std::copy(player.position.begin(), player.position.end(), cloud.position);
        std::copy_n(kColors[player.player % std::size(kColors)], 3, cloud.color);
        cloud.radius = 0.4, cloud.spread = 0.3, cloud.size = 0.3, cloud.life = 0.2, cloud.glow = 0.5;
        m_world.spawn_particles(cloud);
    }
}

void PlayerView::drawFrom(const rubble::Camera& camera, double partOfStep) {
    m_client.show(partOfStep);
    rubble_view view{};
    const glm::dquat turn = camera.rotation();
    view.framebuffer = m_screen.framebuffer();
    view.width = uint32_t(m_screen.size().width), view.height = uint32_t(m_screen.size().height);
    for (int i = 0; i < 3; ++i) view.position[i] = camera.position[i];
    view.rotation[0] = turn.x, view.rotation[1] = turn.y, view.rotation[2] = turn.z, view.rotation[3] = turn.w;
    view.vertical_fov = camera.verticalFov;
    view.alpha = m_client.alpha();
    m_renderer.draw(view);
}

void PlayerView::lookAt(const Vec3& target) {
    m_camera.lookAt(toGlm(target));
}

}  // namespace netplay
