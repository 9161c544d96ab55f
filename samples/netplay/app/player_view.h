#pragma once
#include "samples/netplay/app/screen.h"
#include "samples/netplay/client.h"
#include "samples/support/camera.h"

namespace netplay {

/// What one player sees: the client's world, from where the player is, and the others as clouds that glow in colours of
/// their own. [main-thread] and [render-thread] are one here.
class PlayerView {
public:
    /// world: that of the client, with a renderer. preset: as in rubble_renderer_settings. All must outlive it.
    PlayerView(rubble::World& world, Client& client, Screen& screen, const char* preset);

    /// Does what the player wants: turns, flies, and uses a tool if isUsing. To be called before each tick of the
    /// client.
    void act(const rubble::PlayerInput& input, Tool tool, bool isUsing);
    /// Goes where the server has the player, and shows the others. To be called after each tick of the client.
    void follow();
    /// Draws the world at so much of a step behind the last tick, as the player sees it.
    void draw(double partOfStep) { drawFrom(m_camera, partOfStep); }
    /// The same from another place.
    void drawFrom(const rubble::Camera& camera, double partOfStep);
    /// Looks at a place, metres.
    void lookAt(const Vec3& target);

private:
    void use(Tool tool);
    void showOthers();

    rubble::World& m_world;
    Client& m_client;
    Screen& m_screen;
    rubble::Renderer m_renderer;
    rubble::Camera m_camera;
    glm::dvec3 m_velocity{0.0};  ///< that the player wants, m/s
    bool m_isPlaced = false;
};

/// The settings of a world that a view can draw.
rubble_world_settings drawnWorld();

}  // namespace netplay
