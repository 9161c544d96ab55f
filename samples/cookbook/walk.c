/* A character walks up a step and jumps. */
#include "cookbook.h"

int main(void) {
    rubble_character_settings settings = {.struct_size = sizeof settings, .position = {0, 0.1, -3}};
    rubble_character_move move = {.struct_size = sizeof move, .desired_velocity = {0, 0, 3}};
    rubble_character_state state;
    uint32_t count;
    double height, top = 0;
    int i;
    begin();
    make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 3, 40, BRICK);
    OK(api->create_character(world, &settings, &move.character));
    OK(api->move_character(world, &move));
    steps(120);
    OK(api->get_character_states(world, &state, 1, &count));
    height = state.position[1];
    move.flags = RUBBLE_MOVE_JUMP, move.desired_velocity[2] = 0;
    OK(api->move_character(world, &move));
    for (i = 0; i < 60; ++i) {
        steps(1);
        OK(api->get_character_states(world, &state, 1, &count));
        if (state.position[1] > top) top = state.position[1];
    }
    printf("walked up to %.1f m, jumped to %.1f m\n", height, top);
    require(height > 0.25 && top > height + 0.5, "up the step, and a jump");
    OK(api->destroy_world(world));
    return 0;
}
