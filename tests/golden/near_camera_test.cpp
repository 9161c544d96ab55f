// A camera that nearly touches a voxel.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 54);
constexpr uint8_t kStone = 1;

PaletteRef stone() {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& e = (*palette)[kStone];
    e.red = e.green = e.blue = 186;
    e.roughness = 230;
    e.material = 1;
    return palette;
}

/// Luminance of the covered pixels, and how many pixels that should be covered are not.
struct Seen {
    double luminance = 0.0;
    int covered = 0, holes = 0;
};

class NearCamera : public Drawing, public testing::WithParamInterface<int> {
protected:
    /// A lone voxel whose low corner is at (0, 2, 0), in the open or in a room.
    LitScene lone(bool isRoom) {
        LitScene scene(stone());
        scene.environment.sunDirection = {0.4f, 0.6f, 0.5f};
        scene.add({1, 1, 1}, {{0, 2, 0}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
        scene.add({80, 40, 80}, {{-4, 0, -4}, {1, 0, 0, 0}}, [=](glm::ivec3 c) {
            const bool isWall = c.x < 2 || c.x >= 78 || c.z < 2 || c.z >= 78;
            return c.y < 2 || (isRoom && isWall && c.y < 30) ? kStone : uint8_t(0);
        });
        return scene;
    }
    /// Looks at the face that points to `side` from `distance` metres, a little aside of its middle.
    Seen look(int side, double distance) {
        glm::dvec3 out(0.0), up(0, 1, 0);
        out[side / 2] = side % 2 ? 1.0 : -1.0;
        if (side / 2 == 1) up = {0, 0, 1};
        const glm::dvec3 right = glm::cross(up, out);
        View view;
        view.position = glm::dvec3(0.05, 2.05, 0.05) + out * (0.05 + distance) + 0.052 * right + 0.01 * up;
        view.rotation = glm::quat_cast(glm::inverse(glm::lookAt(view.position, view.position - out, up)));
        view.size = kSize;
        view.framebuffer = target->framebuffer();
        view.cut = true;
        for (int i = 0; i < 12; ++i) {
            renderer->draw(view, 1.0f);
            view.cut = false;
        }
        const FloatImage albedo = read("albedo"), radiance = read("radiance");
        Seen seen;
        const double tanY = std::tan(0.5 * double(view.verticalFov)), aspect = double(kSize.x) / kSize.y;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const double across = ((x + 0.5) / kSize.x * 2 - 1) * tanY * aspect * distance + 0.052,
                             upward = ((y + 0.5) / kSize.y * 2 - 1) * tanY * distance + 0.01;
                const double pixel = 2 * tanY / kSize.y * distance;  // jitter moves edges
                if (std::abs(across) > 0.05 - pixel || std::abs(upward) > 0.05 - pixel) continue;
                const glm::vec4 light = radiance.at(x, y);
                ++seen.covered;
                seen.holes += albedo.at(x, y).a == 0.0f || !(light.g > 0.0f);
                seen.luminance += double(light.g);
            }
        seen.luminance /= std::max(seen.covered, 1);
        return seen;
    }
};

TEST_P(NearCamera, SeesALitVoxelFromACentimetre) {
    for (const bool isRoom : {false, true}) {
        start(lone(isRoom), kSize);
        const Seen far = look(GetParam(), 0.3);
        for (const double distance : {0.05, 0.03, 0.02, 0.01, 0.005}) {
            const Seen seen = look(GetParam(), distance);
            std::printf("room %d, %.3f m: luminance %.3f of %.3f, %d of %d missing\n", isRoom, distance, seen.luminance,
                        far.luminance, seen.holes, seen.covered);
            EXPECT_GT(seen.covered, 500);
            EXPECT_EQ(seen.holes, 0) << distance << " m";
            EXPECT_GT(seen.luminance, 0.7 * far.luminance) << distance << " m";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EachSide, NearCamera, testing::Range(0, 6));

}  // namespace
}  // namespace rubble
