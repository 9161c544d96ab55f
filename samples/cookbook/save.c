/* Save and load: a game goes on from a save as it would have gone on without. */
#include "cookbook.h"

int main(void) {
    rubble_explosion explosion = {.struct_size = sizeof explosion, .position = {0, 0.5, -0.5}};
    uint64_t size, played, loaded;
    uint8_t* slot;
    begin();
    make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 3, BRICK);
    OK(api->explode(world, &explosion));
    steps(30);
    OK(api->save_game_data(world, NULL, 0, &size)); /* save_game() writes a file */
    slot = malloc(size);
    OK(api->save_game_data(world, slot, size, &size));
    steps(30);
    OK(api->get_state_hash(world, &played));
    OK(api->load_game_data(world, slot, size));
    steps(30);
    OK(api->get_state_hash(world, &loaded));
    printf("%d bytes, %s\n", (int)size, played == loaded ? "equal" : "different");
    require(played == loaded, "the loaded game is the one that was played on");
    free(slot);
    OK(api->destroy_world(world));
    return 0;
}
