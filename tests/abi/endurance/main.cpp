// endurance LIBRARY RUN COUNT [--timed]: uses the library COUNT times over, and fails if it takes more and more.
//   worlds      makes a world, loads a game, plays, breaks and saves, and destroys it
//   library     loads the library, does the same, and lets the library go
//   undrawn     steps of demolition in a world that a renderer could draw, and none does
//   demolition  steps of demolition in a world for which nothing is prepared to be drawn
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "tests/abi/endurance/demolition.h"
#include "tests/abi/endurance/library.h"
#include "tests/abi/endurance/steadiness.h"

namespace rubble {
namespace {

/// A game in memory that another world can load.
std::vector<uint8_t> savedGame(const Library& api, rubble_world world) {
    uint64_t size = 0;
    require(api, api->save_game_data(world, nullptr, 0, &size));
    std::vector<uint8_t> data(size);
    require(api, api->save_game_data(world, data.data(), size, &size));
    return data;
}

/// A world with a tower, from nothing to nothing. flags: RUBBLE_WORLD_...
void playOnce(const Library& api, uint32_t flags) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = flags;
    rubble_world first = 0, second = 0;
    require(api, api->create_world(&settings, &first));
    require(api, api->create_world(&settings, &second));
    auto frame = sized<rubble_body_settings>();
    frame.flags = RUBBLE_BODY_STATIC;
    rubble_body body = 0;
    rubble_shape tower = 0;
    require(api, api->create_body(first, &frame, &body));
    auto shape = sized<rubble_shape_settings>();
    shape.source = RUBBLE_SHAPE_BOX, shape.body = body, shape.size[0] = shape.size[1] = shape.size[2] = 12;
    require(api, api->create_shape(first, &shape, &tower));
    require(api, api->step(first));
    const std::vector<uint8_t> game = savedGame(api, first);
    require(api, api->load_game_data(second, game.data(), game.size()));
    auto explosion = sized<rubble_explosion>();
    explosion.position[0] = explosion.position[1] = explosion.position[2] = 0.6;
    require(api, api->explode(second, &explosion));
    for (int i = 0; i < 8; ++i) require(api, api->step(second));
    require(api, api->start_loading(first, "no/such/level.rubble", nullptr));  // ends with its world
    require(api, api->destroy_world(first));
    require(api, api->destroy_world(second));
}

uint32_t flagsOf(int cycle) {
    constexpr uint32_t kFlags[] = {0, RUBBLE_WORLD_NO_RENDERER, RUBBLE_WORLD_SHADOW_INLINE,
                                   RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_DATA | RUBBLE_WORLD_PARTICLES,
                                   RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS};
    return kFlags[size_t(cycle) % std::size(kFlags)];
}

int run(const std::string& path, const std::string& what, int count, bool timed) {
    if (what == "library") {
        Steadiness steadiness(count, "loads");
        for (int i = 0; i < count; ++i) {
            const Library library(path);
            for (int cycle = 0; cycle < 5; ++cycle) playOnce(library, flagsOf(cycle));
            steadiness.endStep(0);
        }
        return steadiness.finish(timed);
    }
    const Library library(path);
    if (what == "worlds") {
        Steadiness steadiness(count, "worlds");
        for (int i = 0; i < count; ++i) {
            playOnce(library, flagsOf(i));
            steadiness.endStep(0);
        }
        return steadiness.finish(timed);
    }
    Demolition demolition(library, what == "undrawn" ? RUBBLE_WORLD_SHADOW_INLINE : RUBBLE_WORLD_NO_RENDERER);
    Steadiness steadiness(count, "steps");
    for (int i = 0; i < count; ++i) {
        demolition.step();
        steadiness.endStep(demolition.bodies());
    }
    return steadiness.finish(timed);
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    const std::string what = argc > 3 ? argv[2] : "";
    const bool isKnown = what == "worlds" || what == "library" || what == "undrawn" || what == "demolition";
    const int count = isKnown ? std::atoi(argv[3]) : 0;
    if (count < 12 || count % 12) {
        std::fputs("endurance LIBRARY worlds|library|undrawn|demolition COUNT [--timed]; COUNT: a multiple of 12\n",
                   stderr);
        return 2;
    }
    return rubble::run(argv[1], what, count, argc > 4 && !std::strcmp(argv[4], "--timed"));
}
