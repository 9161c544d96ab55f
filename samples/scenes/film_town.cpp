#include "samples/scenes/film_town.h"

#include "samples/scenes/office_tower.h"
#include "samples/scenes/town.h"

namespace rubble {

Level makeFilmTown(uint64_t seed) {
    constexpr glm::ivec3 kTower{284, 0, 152};
    Level level = makeTown(seed);
    level.name = "town of the film";
    std::erase_if(level.bodies, [](const LevelBody& body) { return body.name == "tree back"; });  // it stood there
    scenes::addOfficeTower(level, kTower);
    return level;
}

}  // namespace rubble
