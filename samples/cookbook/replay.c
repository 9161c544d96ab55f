/* A replay: all edits are recorded into a file, which plays to the same state, bit for bit. */
#include "cookbook.h"

int main(int argc, char** argv) {
    const char* path = argc > 1 ? argv[1] : "replay.rubblelog";
    rubble_explosion explosion = {.struct_size = sizeof explosion, .position = {0, 0.5, -0.5}};
    uint64_t played, replayed, count;
    begin();
    make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 3, BRICK);
    steps(1);
    OK(api->start_recording(world, path));
    OK(api->explode(world, &explosion));
    steps(60);
    OK(api->stop_recording(world));
    OK(api->get_state_hash(world, &played));
    OK(api->play_recording(world, path, &count));
    OK(api->get_state_hash(world, &replayed));
    printf("%d steps, %s\n", (int)count, played == replayed ? "equal" : "different");
    require(count == 60 && played == replayed, "the replay is the game");
    remove(path);
    OK(api->destroy_world(world));
    return 0;
}
