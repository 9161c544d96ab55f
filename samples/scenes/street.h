#pragma once
#include <vector>

#include "samples/scenes/placement.h"

namespace rubble::scenes {

inline constexpr int kGroundDepth = 16;
inline constexpr int kRoadDrop = 2;  ///< cells that roads lie below lawns and pavements

/// The surfaces of the ground. Boxes are in cells of the level, with y unused; later areas lie over earlier ones.
struct GroundPlan {
    enum class Surface { Lawn, Paving, Road, Concrete, Earth };
    struct Area {
        Surface surface;
        CellBox box;
    };
    ivec3 size{640, 0, 640};
    int depth = kGroundDepth;  ///< cells from its bottom to the level of lawns and pavements
    std::vector<Area> areas;
    std::vector<CellBox> lanesAlongX;  ///< dashed white centre lines
    std::vector<CellBox> lanesAlongZ;
    std::vector<CellBox> solidLines;   ///< stop lines and zebra bars
    std::vector<ivec3> manholes;       ///< centres
    std::vector<CellBox> foundations;  ///< holes for buildings, from the depth low.y upward
};

/// Adds the static body "ground", in tiles of shapes: unbreakable rock, dirt, and a surface. Lawns lie at y = 0.
void addGround(Level& level, const GroundPlan& plan);
/// Adds the static body "slopes": around the ground it falls to its bottom over `width` cells.
void addSlopes(Level& level, const GroundPlan& plan, int width);

}  // namespace rubble::scenes
