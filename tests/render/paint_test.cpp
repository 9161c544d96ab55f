#include "runtime/destruction/paint.h"

#include <cmath>

#include "runtime/destruction/split.h"
#include "runtime/voxel/ray_walk.h"
#include "tests/render/gbuffer_fixture.h"

namespace rubble {
namespace {

struct Painted {
    VoxelGrid grid;
    Pose pose;
    PaletteRef palette = testPalette();
    PaintColorsRef colors;
};

/// A wall of many entries with two sprays on it, and the piece that has come off one of its ends.
std::vector<Painted> paintedWallAndPiece() {
    Painted wall{VoxelGrid({48, 24, 8}),
                 {{-2.0, -1.2, -4.5}, glm::angleAxis(0.3, glm::normalize(glm::dvec3(0.2, 1, 0.1)))}};
    {
        GridWriter writer(wall.grid);
        for (int i = 0; i < 48 * 24 * 8; ++i)
            if (i % 48 != 30) writer.set({i % 48, i / 48 % 24, i / 48 / 24}, uint8_t(1 + i % 251));
    }
    const auto spray = [&](glm::dvec3 at, Srgb color, uint8_t strength) {
        const auto painted = paintLayer(wall.grid, wall.colors, sphereBrush(at, {11, 11, 11}),
                                        {.color = color, .strength = strength, .falloff = 60});
        if (painted.colors) wall.colors = painted.colors;
    };
    spray({14, 12, 8}, {250, 10, 40}, 230);
    spray({34, 12, 8}, {20, 240, 90}, 160);
    const std::vector<Component> parts = findComponents(wall.grid);
    const Piece taken = takePiece(wall.grid, parts.at(1));
    Painted piece{taken.grid,
                  {{0.6, -0.9, -3.6}, glm::angleAxis(1.1, glm::normalize(glm::dvec3(1, 2, 3)))},
                  wall.palette,
                  wall.colors};
    return {wall, piece};
}

/// The sRGB colour that a pixel should show, by the C++ walk; negative if it sees nothing.
glm::ivec3 expectedColor(const std::vector<Painted>& bodies, const View& view, int x, int y, bool& isPainted) {
    const double tanY = std::tan(double(view.verticalFov) / 2), tanX = tanY * view.size.x / view.size.y;
    const glm::dvec3 ray = view.rotation * glm::dvec3((2 * (x + 0.5) / view.size.x - 1) * tanX,
                                                      (2 * (y + 0.5) / view.size.y - 1) * tanY, -1.0);
    double nearest = 65000.0;
    glm::ivec3 out(-1);
    isPainted = false;
    for (const Painted& body : bodies) {
        const CellHit hit = walkRay(body.grid, {body.pose.inversePoint(view.position) / 0.1,
                                                glm::conjugate(body.pose.rotation) * ray / 0.1, nearest});
        if (!hit.hit || hit.t >= nearest) continue;
        nearest = hit.t;
        const PaletteEntry& entry = (*body.palette)[body.grid.at(hit.cell)];
        const uint8_t paint = body.grid.brickAt(brickOfCell(hit.cell))->paintAt(voxelIndex(cellInBrick(hit.cell)));
        const Srgb own{entry.red, entry.green, entry.blue};
        const Srgb shown =
            paint ? paintOver(own, body.colors->colors[size_t(paintColor(paint) - 1)], paintSteps(paint)) : own;
        out = {shown[0], shown[1], shown[2]};
        isPainted = paint != 0;
    }
    return out;
}

TEST_F(GBufferTest, DrawsPaint) {
    const std::vector<Painted> bodies = paintedWallAndPiece();
    Scene scene;
    TestScene made;
    std::vector<ShapeHandle> shapes;
    for (const Painted& body : bodies) {
        shapes.push_back(made.add(body.grid, body.pose, body.palette));
        made.snapshot().created.back().paintColors = body.colors;
    }
    scene.apply(made.take());
    View view;
    view.size = {320, 180};
    draw(scene, view);
    const auto albedo = read(targets.at(Target::Albedo));
    int painted = 0, differ = 0;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            bool isPainted;
            const glm::ivec3 expected = expectedColor(bodies, view, x, y, isPainted);
            if (expected.x < 0) continue;
            painted += isPainted;
            const glm::vec4& pixel = albedo[size_t(y) * size_t(view.size.x) + size_t(x)];
            for (int c = 0; c < 3; ++c)
                if (std::abs(std::lround(pixel[c] * 255) - expected[c]) > 1) {
                    ++differ;
                    break;
                }
        }
    EXPECT_GT(painted, 5000);
    EXPECT_LE(differ, view.size.x * view.size.y / 10000);
    made.snapshot().palettes.push_back({shapes[0], bodies[0].palette, nullptr});
    made.snapshot().palettes.push_back({shapes[1], bodies[1].palette, nullptr});
    scene.apply(made.take());
    draw(scene, view);
    int changed = 0;
    const auto plain = read(targets.at(Target::Albedo));
    for (size_t i = 0; i < plain.size(); ++i) changed += glm::distance(plain[i], albedo[i]) > 0.01f;
    EXPECT_GT(changed, painted * 9 / 10) << "without colours a shape shows its own";
}

TEST_F(GBufferTest, NoPaintAtlasWithoutPaint) {
    BrickAtlas atlas;
    BrickIndices indices{};
    indices[7] = 3;
    const BrickRef plain = makeBrick(indices);
    indices[8] = 3;
    BrickIndices paint{};
    paint[8] = paintByte(1, 4);
    const BrickRef colored = makeBrick(indices, &paint);
    atlas.acquire(plain);
    atlas.upload();
    EXPECT_EQ(atlas.paint(), nullptr);
    const uint64_t before = atlas.bytes();
    atlas.acquire(colored);
    EXPECT_GT(atlas.upload(), 576u + 512u);
    EXPECT_GT(atlas.bytes(), before);
    atlas.release(colored.get());
    EXPECT_EQ(atlas.bricks(), 1);
}

}  // namespace
}  // namespace rubble
