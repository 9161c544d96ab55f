#include "tests/reference/sky.h"

#include <cmath>

#include "tests/golden/drawing.h"

namespace rubble::reference {
namespace {

class SkyTest : public Drawing {};

/// sky.cpp must equal shaders/lib/sky.glsl: sky, clouds, hills and fields, pixel by pixel.
TEST_F(SkyTest, IsWhatTheShadersDraw) {
    LitScene scene(streetPalette());
    scene.environment = streetScene().environment;
    scene.add({2, 2, 2}, {{0, -50, 0}, {1, 0, 0, 0}}, [](glm::ivec3) { return uint8_t(1); });
    RenderSettings settings;
    settings.temporal = settings.fog = settings.glare = false;
    const glm::ivec2 size(64, 40);
    int differ = 0, pixels = 0;
    for (const double turn : {0.0, 1.3, 2.4, 3.8, 5.1}) {
        scene.environment.fogDistance = turn < 2.0 ? 150.0f : turn < 3.0 ? 1e5f : turn < 4.0 ? 50.0f : 25.0f;
        start(scene, size, settings);
        Camera camera;
        camera.position = {3.0, 4.0, -2.0};
        camera.yaw = turn, camera.pitch = 0.25 * std::sin(7.0 * turn);
        renderer->draw(camera.view(size, target->framebuffer()), 1.0f);
        const auto drawn = renderer->readTarget("radiance");
        ASSERT_TRUE(drawn) << drawn.error();
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec2 p = (glm::dvec2(x, y) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
                const double tanY = std::tan(camera.verticalFov * 0.5);
                const glm::dvec3 ray =
                    glm::normalize(camera.rotation() * glm::dvec3(p.x * tanY * size.x / size.y, p.y * tanY, -1.0));
                const glm::vec3 expected = backgroundRadiance(
                    scene.environment, glm::vec3(ray), glm::vec3(camera.position), float(camera.position.y + 0.05));
                const glm::vec3 off = glm::abs(glm::vec3(drawn->at(x, y)) - expected);
                differ += std::max(off.x, std::max(off.y, off.z)) > 0.02f * (expected.x + expected.y + expected.z);
                ++pixels;
            }
    }
    EXPECT_LT(differ, pixels / 50) << "of " << pixels;
}

}  // namespace
}  // namespace rubble::reference
