#pragma once
#include <vector>

#include "runtime/destruction/stress_analysis.h"
#include "tests/support/grids.h"

namespace rubble {

/// A structure of concrete boxes, some of them anchored, to compare with beam theory.
struct StressFixture {
    VoxelGrid grid;
    std::vector<CellBox> anchors;
    StrengthTable entries;
    double voxelSize = 0.1;
    double strengthScale = 1.0;
    glm::dvec3 gravity{0.0, -9.81, 0.0};
    StressAnalysis analysis;

    /// Entry 1 is concrete, 2 metal, 3 metal that never breaks.
    explicit StressFixture(glm::ivec3 size) : grid(size) {
        Palette palette{};
        palette[1].material = defaultMaterials().find("concrete");
        palette[2].material = defaultMaterials().find("metal");
        palette[3].material = defaultMaterials().find("heavy metal");
        entries = makeStrengthTable(palette, defaultMaterials());
    }
    /// Fills a box with an entry; 0 empties it.
    void fill(CellBox box, uint8_t entry = 1) { fillBox(grid, box, entry); }
    /// Fills a box and anchors it.
    void anchor(CellBox box, uint8_t entry = 1) {
        fill(box, entry);
        anchors.push_back(box);
    }
    /// The input of the analysis.
    StressedShape shape() const { return {grid, anchors, entries, gravity, voxelSize, strengthScale}; }
    /// Analyses all bricks; returns the cracks.
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
