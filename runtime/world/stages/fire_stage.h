#pragma once
#include <vector>

#include "runtime/destruction/heat.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Fires of one step: heat edits, burning, spreading. Heat is kept by brick, in mJ of integers, so that it is the same
/// on every machine. A step updates the bricks whose turn it is, each every kHeatInterval steps.
class FireStage {
public:
    /// For the step of the context.
    explicit FireStage(EditContext& context) : m_context(context) {}

    /// Heats the bricks in a sphere, each by its share of the exposed surface there.
    void apply(const HeatEdit& edit);
    /// Puts out the fires in a sphere, and wets the bricks there.
    void apply(const ExtinguishEdit& edit);
    /// Puts out the fires in a box.
    void apply(const RemoveFiresEdit& edit);
    /// Burns all that is hot for one step: chars, consumes voxels, weakens shapes, spreads heat.
    void update();

private:
    struct Deposit {
        ShapeHandle shape;
        glm::ivec3 brick;
        int64_t heat;  ///< mJ
    };
    HotBrick* depositHeat(const Deposit& deposit);
    void igniteBrick(ShapeHandle shape, HotBrick& hot);
    void extinguishBrick(ShapeHandle shape, HotBrick& hot, uint32_t wet);
    void extinguishUnderWater();
    const HeatTable& heatTable(ShapeHandle shape);
    glm::dvec3 brickInWorld(ShapeHandle shape, glm::ivec3 brick) const;
    void updateHeatField(HeatField& field);
    void emitHeat(ShapeHandle shape, const HotBrick& hot, int64_t emitted);
    void removeBurnedCells(ShapeHandle shape, const std::vector<BrickSubset>& cells);

    EditContext& m_context;
    std::vector<Deposit> m_deposits;       ///< wait until every brick has had its turn
    std::vector<HeatDeposit> m_neighbors;  ///< of one brick
    HeatTable m_heatTable;
    PaletteRef m_heatTablePalette;
    float m_heatTableVoxelSize = 0.0f;
};

}  // namespace rubble
