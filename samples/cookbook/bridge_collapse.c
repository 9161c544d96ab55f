/* A bridge that falls when its pier is shot away: what nothing holds any more comes off by itself. */
#include "cookbook.h"

int main(void) {
    rubble_carve charge = {.struct_size = sizeof charge, .brush = RUBBLE_BRUSH_BOX, .position = {0.2, 0.5, 0.5}};
    rubble_shape_state deck[64];
    const rubble_body bridge = (begin(), make_body(-4, 0, 0, RUBBLE_BODY_STATIC));
    double lowest = 1e9;
    uint32_t count, i;
    rubble_shape road = make_box(bridge, 0, 2, 0, 80, 3, 10, CONCRETE);
    rubble_shape pier = make_box(bridge, 4, 0, 0, 4, 20, 10, CONCRETE);
    OK(api->merge_shape(world, pier, road)); /* one shape: what it stands on is the pier's foot */
    steps(1);
    charge.half_size[0] = charge.half_size[2] = 1, charge.half_size[1] = 0.15;
    OK(api->carve(world, &charge));
    steps(180);
    OK(api->get_shape_states(world, 0, deck, 64, &count));
    for (i = 0; i < count && i < 64; ++i)
        if (deck[i].size[0] >= 70 && deck[i].size[0] <= 80) lowest = deck[i].position[1];
    printf("the road lies at %.1f m\n", lowest);
    require(lowest < 1.5, "the road has fallen");
    OK(api->destroy_world(world));
    return 0;
}
