#pragma once
#include <string>

#include "samples/scenes/canvas.h"

/// Furniture and other props: shapes that stand on their lowest layer, for addDynamic(). The caller chooses unique
/// names. Sizes are cells along x, y and z.
namespace rubble::scenes {

LevelShape makeTable(std::string name);                                   ///< wooden, 16 x 8 x 10
LevelShape makeChair(std::string name, const struct SurfaceStyle& seat);  ///< its back at z = 0, 5 x 10 x 5
LevelShape makeShelf(std::string name, uint32_t seed);                    ///< full of books, 14 x 20 x 4
LevelShape makeBed(std::string name, const SurfaceStyle& blanket);        ///< its head at z = 0, 12 x 9 x 21
LevelShape makeSofa(std::string name, const SurfaceStyle& cloth);         ///< its back at z = 0, 21 x 9 x 9
LevelShape makeBath(std::string name);                                    ///< empty, 18 x 8 x 9
LevelShape makeToilet(std::string name);                                  ///< its cistern at z = 0, 4 x 9 x 7
LevelShape makeCounter(std::string name, int length);                     ///< kitchen cupboards with a sink
LevelShape makeFridge(std::string name);                                  ///< its door at high z, 7 x 18 x 7
LevelShape makeWardrobe(std::string name);                                ///< with clothes in it, 13 x 20 x 6
LevelShape makeTelevision(std::string name);                              ///< on its stand, 14 x 13 x 5
LevelShape makeCrate(std::string name);                                   ///< hollow, with straw, 8 x 8 x 8
LevelShape makeBarrel(std::string name, const SurfaceStyle& paint);       ///< hollow, of metal, 7 x 10 x 7
LevelShape makeBin(std::string name);                                     ///< on wheels, with rubbish, 7 x 12 x 7
LevelShape makeBench(std::string name);                                   ///< its back at z = 0, 18 x 9 x 6
LevelShape makePlantPot(std::string name);                                ///< with a small bush, 7 x 13 x 7
LevelShape makeHydrant(std::string name);                                 ///< solid metal, 5 x 9 x 5

/// Adds a floor light at a cell: a dynamic body whose glowing shade belongs to a new light group, with a sphere light.
void addFloorLight(Level& level, const std::string& name, ivec3 cell);

}  // namespace rubble::scenes
