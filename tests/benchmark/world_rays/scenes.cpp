#include "tests/benchmark/world_rays/scenes.h"

#include <fmt/format.h>

#include "runtime/assets/assets.h"
#include "runtime/core/random.h"
#include "samples/scenes/town.h"
#include "tests/support/models.h"

namespace rubble::rays {
namespace {

class City {
public:
    City() : m_grid(kSize), m_writer(m_grid) {
        fill({0, 0, 0}, {kSize.x, 2, kSize.z});
        for (int z = 0; z < kSize.z; z += kBlock)
            for (int x = 0; x < kSize.x; x += kBlock) block({x, 2, z});
        m_writer.flush();
    }
    VoxelGrid take() { return std::move(m_grid); }

private:
    static constexpr glm::ivec3 kSize{1024, 256, 1024};
    static constexpr int kBlock = 256, kFloor = 28;
    void fill(glm::ivec3 low, glm::ivec3 high, uint8_t index = 1) {
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) m_writer.set({x, y, z}, index);
    }
    void block(glm::ivec3 at) {
        for (int i = 0; i < 4; ++i) {
            const int width = m_random.between(60, 92), depth = m_random.between(60, 92),
                      floors = m_random.between(1, 8);
            house(at + glm::ivec3(30 + (i & 1) * 100, 0, 30 + (i >> 1) * 100), {width, floors * kFloor, depth});
        }
        for (int i = 0; i < 10; ++i) {
            const int x = at.x + m_random.between(22, 26), z = at.z + m_random.between(0, 250);
            fill({x, 2, z}, {x + 1, 50, z + 1});
        }
        for (int i = 0; i < 6; ++i) tree({at.x + m_random.between(30, 220), 2, at.z + m_random.between(14, 22)});
    }
    void house(glm::ivec3 low, glm::ivec3 size) {
        const glm::ivec3 high = low + size;
        for (int y = low.y; y <= high.y; y += kFloor) fill({low.x, y, low.z}, {high.x, y + 1, high.z});
        for (const int x : {low.x, (low.x + high.x) / 2, high.x - 1}) fill({x, low.y, low.z}, {x + 1, high.y, high.z});
        for (const int z : {low.z, (low.z + high.z) / 2, high.z - 1}) fill({low.x, low.y, z}, {high.x, high.y, z + 1});
        for (int y = low.y + 9; y < high.y; y += kFloor) {
            for (int x = low.x + 4; x + 8 < high.x; x += 14)
                for (const int z : {low.z, high.z - 1}) fill({x, y, z}, {x + 8, y + 12, z + 1}, 0);
            for (int z = low.z + 4; z + 8 < high.z; z += 14)
                for (const int x : {low.x, high.x - 1}) fill({x, y, z}, {x + 1, y + 12, z + 8}, 0);
        }
    }
    void tree(glm::ivec3 foot) {
        fill(foot, foot + glm::ivec3(2, 30, 2));
        for (int i = 0; i < 900; ++i) {
            const glm::ivec3 leaf =
                foot + glm::ivec3(m_random.between(-12, 13), m_random.between(22, 50), m_random.between(-12, 13));
            fill(leaf, leaf + 2);
        }
    }
    Random m_random{11};
    VoxelGrid m_grid;
    GridWriter m_writer;
};

LevelBody staticBody(VoxelGrid grid, glm::dvec3 position) {
    LevelBody body;
    body.pose.position = position;
    body.isStatic = true;
    auto palette = std::make_shared<Palette>();
    for (PaletteEntry& entry : *palette) entry.material = defaultMaterials().find("brick");
    LevelShape shape;
    shape.grid = std::move(grid);
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// Fills in the shadow volume and adds two views: along a street, and down from a corner.
void addViews(RayScene& scene, glm::dvec3 streetWorld, glm::dvec3 along) {
    scene.patches = patchesOf(scene.level);
    scene.bits = bitsOf(scene.patches);
    const glm::dvec3 size = glm::min(glm::dvec3(scene.bits.cells()), glm::dvec3(1024.0));
    const glm::dvec3 high(size.x * 0.05, std::max(300.0, size.y * 1.5), size.z * 0.05);
    scene.views = {{"street", streetWorld / double(kShadowCell) - glm::dvec3(scene.bits.low), along},
                   {"aerial", high, glm::dvec3(size.x * 0.45, 0.0, size.z * 0.45) - high}};
}

}  // namespace

RayScene townScene() {
    RayScene scene{"town", makeTown(1), {}, {}, {}};
    for (const auto& [name, pose] : scene.level.locations)
        if (name == "camera_street") addViews(scene, pose.position, pose.rotation * glm::dvec3(0, 0, -1));
    return scene;
}

RayScene cityScene() {
    RayScene scene = wideCityScene(1);
    scene.name = "city";
    return scene;
}

RayScene wideCityScene(int blocks) {
    RayScene scene{fmt::format("city {0} x {0}", blocks), {}, {}, {}, {}};
    const VoxelGrid city = City().take();
    for (int i = 0; i < blocks * blocks; ++i)
        scene.level.bodies.push_back(staticBody(city, glm::dvec3(i % blocks, 0.0, i / blocks) * 102.4));
    addViews(scene, {51.4, 1.9, 40.0}, {-0.1, 0.06, 1.0});
    return scene;
}

RayScene modelScene() {
    RayScene scene{"model", {}, {}, {}, {}};
    Result<Level> level = importVox(modelPath("scene_theater.vox"), {});
    if (!level) return scene;
    scene.level = std::move(level.value());
    addViews(scene, {}, {0.1, 0.0, -1.0});
    const glm::dvec3 size(scene.bits.cells());
    scene.views[0].eye = {size.x * 0.5, 20.0, size.z * 0.9};
    return scene;
}

}  // namespace rubble::rays
