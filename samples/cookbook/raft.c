/* Water: wood floats, metal sinks, and a current carries what floats. */
#include "cookbook.h"

int main(void) {
    const double corners[8] = {-4, -4, 4, -4, 4, 4, -4, 4};
    rubble_water_settings pool = {.struct_size = sizeof pool, .outline = corners, .outline_count = 4};
    const rubble_body raft = (begin(), make_body(-0.5, 3, -0.5, 0)), anchor = make_body(2, 3, 0, 0);
    rubble_water water;
    pool.surface_height = 2, pool.depth = 2, pool.flow[2] = 0.5;
    OK(api->create_water(world, &pool, &water));
    make_box(raft, 0, 0, 0, 10, 4, 10, WOOD);
    make_box(anchor, 0, 0, 0, 4, 4, 4, METAL);
    steps(240);
    printf("the raft floats at %.1f m and has drifted %.1f m, the anchor lies at %.1f m\n", state_of(raft).position[1],
           state_of(raft).position[2] + 0.5, state_of(anchor).position[1]);
    require(state_of(raft).position[1] > 1.4 && state_of(anchor).position[1] < 0.1, "wood floats, metal sinks");
    require(state_of(raft).position[2] > 0, "the current carries the raft");
    OK(api->destroy_world(world));
    return 0;
}
