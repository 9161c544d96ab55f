#pragma once
#include "samples/scenes/canvas.h"

/// Loose things, each a shape of its own that stands on its lowest layer. Names are made unique by the caller.
namespace rubble::scenes {

LevelShape makeTable(std::string name);
LevelShape makeChair(std::string name, const struct SurfaceStyle& seat);
LevelShape makeShelf(std::string name, uint32_t seed);  ///< full of books
LevelShape makeBed(std::string name, const SurfaceStyle& blanket);
LevelShape makeSofa(std::string name, const SurfaceStyle& cloth);
LevelShape makeBath(std::string name);
LevelShape makeToilet(std::string name);
LevelShape makeCounter(std::string name, int length);  ///< kitchen cupboards with a sink
LevelShape makeFridge(std::string name);
LevelShape makeWardrobe(std::string name);
LevelShape makeTelevision(std::string name);  ///< on its stand
LevelShape makeCrate(std::string name);
LevelShape makeBarrel(std::string name, const SurfaceStyle& paint);
LevelShape makeBin(std::string name);
LevelShape makeBench(std::string name);
LevelShape makePlantPot(std::string name);
LevelShape makeHydrant(std::string name);

/// A lamp on a foot, its shade glowing in a group of the level, with a light. Standing at a cell.
void addFloorLight(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
