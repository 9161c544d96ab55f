#pragma once
#include <vector>

#include "samples/scenes/placement.h"

namespace rubble::scenes {

inline constexpr int kGroundDepth = 16;  ///< cells from the bottom of the ground to the level of lawns and pavements
inline constexpr int kRoadDrop = 2;      ///< cells that a road lies lower

/// What the ground is made of at a place. Boxes in town cells on the ground, y unused; later ones lie over earlier
/// ones.
struct GroundPlan {
    enum class Surface { Lawn, Paving, Road, Concrete, Earth };
    struct Area {
        Surface surface;
        CellBox box;
    };
    ivec3 size{640, 0, 640};
    std::vector<Area> areas;
    std::vector<CellBox> lanesAlongX;  ///< dashed white centre lines
    std::vector<CellBox> lanesAlongZ;
    std::vector<CellBox> solidLines;   ///< stop lines and zebra bars
    std::vector<ivec3> manholes;       ///< centres
    std::vector<CellBox> foundations;  ///< where buildings stand: the ground leaves them room, y: from this depth up
};

/// One static body, "ground", in tiles: unbreakable rock, dirt, and what lies on it. Its lawn is at y = 0.
void addGround(Level& level, const GroundPlan& plan);

}  // namespace rubble::scenes
