#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/world/world.h"
#include "tests/support/grids.h"

namespace rubble::test {

inline constexpr double kConcreteWeight = 2400.0 * 9.81;  ///< N/m3
inline constexpr double kConcreteTension = 2.6e6, kConcreteCompression = 25e6;

/// Boxes of a material (entry 1) and of metal that never breaks (entry 2) on one body, some of them anchored.
struct Structure {
    VoxelGrid grid;
    std::vector<CellBox> anchors;
    double voxelSize = 0.1;

    /// Empty, of this many cells.
    explicit Structure(glm::ivec3 size) : grid(size) {}
    /// Fills a box of cells with an entry.
    void fill(CellBox box, uint8_t entry = 1) { fillBox(grid, box, entry); }
    /// Fills a box of cells and anchors it.
    void anchor(CellBox box, uint8_t entry = 1) {
        fill(box, entry);
        anchors.push_back(box);
    }
    /// As a level with this material for entry 1. A body that is not static has no use for anchors.
    Level level(const char* material = "concrete", bool isStatic = true) const {
        Level out;
        Palette palette{};
        palette[1].material = out.materials.find(material);
        palette[2].material = out.materials.find("heavy metal");
        LevelShape shape{.name = "structure",
                         .voxelSize = float(voxelSize),
                         .grid = grid,
                         .palette = std::make_shared<const Palette>(palette)};
        shape.anchors = anchors;
        LevelBody body{.name = "structure", .isStatic = isStatic};
        body.shapes.push_back(std::move(shape));
        out.bodies.push_back(std::move(body));
        return out;
    }
};

/// What happened to a structure in some steps.
struct Outcome {
    std::vector<CrackOpened> cracks;
    size_t pieces = 0;
    /// Whether any section broke.
    bool isBroken() const { return !cracks.empty(); }
};

/// Settings with stress analysis at a scale of strengths.
inline WorldSettings stressOn(double strengthScale) {
    WorldSettings settings;
    settings.stress.on = true;
    settings.stress.strengthScale = strengthScale;
    return settings;
}

/// One step with edits; adds what happened.
inline void step(World& world, Outcome& out, const Edits& edits = {}) {
    const FrameChanges changes = world.applyEdits(edits);
    out.cracks.insert(out.cracks.end(), changes.cracks.begin(), changes.cracks.end());
    out.pieces += changes.shapesCreated.size();
}

/// Loads a level with stress analysis on; what happens in some steps.
inline Outcome stand(World& world, const Level& level, double strengthScale, int steps) {
    Outcome out;
    world.setSettings(stressOn(strengthScale));
    world.load(level);
    for (int i = 0; i < steps; ++i) step(world, out);
    return out;
}

}  // namespace rubble::test
