#pragma once
#include <functional>
#include <vector>

#include "runtime/destruction/stress_analysis.h"

namespace rubble {

/// A structure of boxes of concrete, anchored boxes among them, for comparison with beam theory.
struct StressFixture {
    VoxelGrid grid;
    std::vector<CellBox> anchors;
    StrengthTable entries;
    double voxelSize = 0.1;
    double strengthScale = 1.0;
    glm::dvec3 gravity{0.0, -9.81, 0.0};
    StressAnalysis analysis;

    explicit StressFixture(glm::ivec3 size) : grid(size) {
        Palette palette{};
        palette[1].material = defaultMaterials().find("concrete");
        palette[2].material = defaultMaterials().find("metal");
        palette[3].material = defaultMaterials().find("heavy metal");
        entries = makeStrengthTable(palette, defaultMaterials());
    }
    void fill(CellBox box, uint8_t entry = 1) {
        GridWriter writer(grid);
        for (int z = box.low.z; z < box.high.z; ++z)
            for (int y = box.low.y; y < box.high.y; ++y)
                for (int x = box.low.x; x < box.high.x; ++x) writer.set({x, y, z}, entry);
    }
    void anchor(CellBox box, uint8_t entry = 1) {
        fill(box, entry);
        anchors.push_back(box);
    }
    StressedShape shape() const { return {grid, anchors, entries, gravity, voxelSize, strengthScale}; }
    /// Analyses everything; the cracks that it wants.
    std::vector<StressCrack> solve() {
        std::vector<glm::ivec3> bricks;
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
        analysis.markChanged(bricks);
        std::vector<StressCrack> cracks;
        int64_t work = int64_t(1) << 40;
        analysis.run(shape(), work, 8, cracks);
        return cracks;
    }
};

}  // namespace rubble
