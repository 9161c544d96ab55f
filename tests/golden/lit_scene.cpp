#include "tests/golden/lit_scene.h"

#include <cmath>

#include "tests/support/grids.h"

namespace rubble {
namespace {

std::vector<BrickChange> bricksOf(ShapeHandle shape, const VoxelGrid& grid) {
    std::vector<BrickChange> bricks;
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) { bricks.push_back({shape, brick, content}); });
    return bricks;
}

bool isEmpty(const BrickRef& brick) {
    return !brick;
}

}  // namespace

ShapeHandle LitScene::add(glm::ivec3 size, Pose pose, const std::function<uint8_t(glm::ivec3)>& entryAt) {
    const ShapeHandle handle = ShapeHandle::make(1, 1, uint32_t(m_shapes.size()));
    m_shapes.push_back({handle, gridOf(size, entryAt), pose, pose, {}});
    return handle;
}

void LitScene::move(ShapeHandle shape, Pose pose) {
    m_shapes[shape.slot()].pose = pose;
}

void LitScene::edit(ShapeHandle shape, const std::function<uint8_t(glm::ivec3)>& entryAt) {
    Shape& s = m_shapes[shape.slot()];
    const VoxelGrid before = s.grid;
    s.grid = gridOf(before.size(), entryAt);
    const glm::ivec3 bricks = before.sizeInBricks();
    for (int i = 0; i < bricks.x * bricks.y * bricks.z; ++i) {
        const glm::ivec3 brick(i % bricks.x, i / bricks.x % bricks.y, i / bricks.x / bricks.y);
        const BrickRef now = s.grid.shareBrick(brick), then = before.shareBrick(brick);
        if (isEmpty(now) && isEmpty(then)) continue;
        s.changed.push_back({shape, brick, now});
    }
}

FrameSnapshot LitScene::snapshot() const {
    FrameSnapshot snapshot;
    snapshot.version = snapshot.newestStep = m_version;
    snapshot.replacesAll = true;
    for (const Shape& s : m_shapes) {
        snapshot.created.push_back({s.handle, s.grid.size(), 0.1f, m_palette, bricksOf(s.handle, s.grid)});
        snapshot.poses.push_back({s.handle, s.pose, s.pose});
    }
    snapshot.lightsChanged = snapshot.environmentChanged = true;
    snapshot.lights = m_lights;
    snapshot.environment = environment;
    fillShadow(snapshot);
    return snapshot;
}

FrameSnapshot LitScene::step() {
    FrameSnapshot snapshot;
    snapshot.version = snapshot.newestStep = ++m_version;
    for (Shape& s : m_shapes) {
        snapshot.poses.push_back({s.handle, s.previous, s.pose});
        s.previous = s.pose;
        snapshot.bricks.insert(snapshot.bricks.end(), s.changed.begin(), s.changed.end());
        s.changed.clear();
    }
    snapshot.lightsChanged = snapshot.environmentChanged = true;
    snapshot.lights = m_lights;
    snapshot.environment = environment;
    fillShadow(snapshot);
    return snapshot;
}

void LitScene::fillShadow(FrameSnapshot& snapshot) const {
    std::map<std::array<int, 3>, ShadowWords> bricks;
    for (const Shape& s : m_shapes) {
        glm::dvec3 low(1e9), high(-1e9);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 local =
                glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(s.grid.size()) * 0.1;
            low = glm::min(low, s.pose.transformPoint(local));
            high = glm::max(high, s.pose.transformPoint(local));
        }
        const glm::ivec3 first = glm::ivec3(glm::floor(low * 10.0)), last = glm::ivec3(glm::ceil(high * 10.0));
        for (int z = first.z; z < last.z; ++z)
            for (int y = first.y; y < last.y; ++y)
                for (int x = first.x; x < last.x; ++x) {
                    const glm::dvec3 local = s.pose.inversePoint((glm::dvec3(x, y, z) + 0.5) * 0.1) * 10.0;
                    const uint8_t entry = s.grid.at(glm::ivec3(glm::floor(local)));
                    if (!entry || (*m_palette)[entry].opacity < 255) continue;
                    const glm::ivec3 cell = glm::ivec3(x, y, z) & 15, word = cell >> 2, bit = cell & 3;
                    bricks[{x >> 4, y >> 4, z >> 4}][size_t(word.x + word.y * 4 + word.z * 16)] |=
                        uint64_t(1) << (bit.x + bit.y * 4 + bit.z * 16);
                }
    }
    snapshot.shadowReplacesAll = snapshot.replacesAll;
    for (const auto& [key, cells] : bricks) {
        const auto last = m_shadow.find(key);
        if (snapshot.replacesAll || last == m_shadow.end() || last->second != cells)
            snapshot.shadow.push_back({{key[0], key[1], key[2]}, makeShadowBrick(cells)});
    }
    for (const auto& [key, cells] : m_shadow)
        if (!snapshot.replacesAll && !bricks.count(key)) snapshot.shadow.push_back({{key[0], key[1], key[2]}, nullptr});
    m_shadow = std::move(bricks);
}

}  // namespace rubble
