#pragma once
#include <memory>
#include <utility>

#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// Snapshots made by hand: what World and Snapshots would publish for a few shapes.
class TestScene {
public:
    /// A shape at rest: `pose` from its grid to the world, metres.
    ShapeHandle add(const VoxelGrid& grid, const Pose& pose, const PaletteRef& palette, float voxelSize = 0.1f) {
        const ShapeHandle handle = ShapeHandle::make(1, 1, m_next++);
        SnapshotShape shape{handle, grid.size(), voxelSize, palette, {}};
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            shape.bricks.push_back({handle, brick, content});
        });
        m_snapshot.created.push_back(std::move(shape));
        m_snapshot.poses.push_back({handle, pose, pose});
        return handle;
    }
    /// What has been added since take(), to be changed by the test.
    FrameSnapshot& snapshot() { return m_snapshot; }
    /// Hands it over, with sky and lights marked as changed.
    FrameSnapshot take() {
        m_snapshot.environmentChanged = m_snapshot.lightsChanged = true;
        return std::exchange(m_snapshot, {});
    }

private:
    FrameSnapshot m_snapshot;
    uint32_t m_next = 0;
};

/// 255 entries of different colours, all of material 1.
inline PaletteRef testPalette() {
    auto palette = std::make_shared<Palette>();
    for (int i = 1; i < 256; ++i) {
        PaletteEntry& e = (*palette)[size_t(i)];
        e.red = uint8_t(60 + i * 37 % 180);
        e.green = uint8_t(60 + i * 91 % 180);
        e.blue = uint8_t(60 + i * 53 % 180);
        e.material = 1;
    }
    return palette;
}

/// Fills a box of cells, high end excluded.
inline void fillBox(GridWriter& writer, glm::ivec3 low, glm::ivec3 high, uint8_t index) {
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) writer.set({x, y, z}, index);
}

}  // namespace rubble
