/* A pane of glass breaks as a whole when something heavy flies through it, which loses little speed. */
#include "cookbook.h"

int main(void) {
    rubble_body_settings ball = {.struct_size = sizeof ball, .position = {0.8, 0.8, -2}, .velocity = {0, 2, 15}};
    rubble_shape_settings sphere = {.struct_size = sizeof sphere, .source = RUBBLE_SHAPE_SPHERE, .index = METAL};
    rubble_body stone;
    rubble_shape made;
    begin();
    make_box(make_body(0, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 20, 20, 1, GLASS);
    OK(api->create_body(world, &ball, &stone));
    sphere.body = stone, sphere.size[0] = sphere.size[1] = sphere.size[2] = 4;
    OK(api->create_shape(world, &sphere, &made));
    steps(30);
    printf("%d voxels gone, the ball flies on at %.1f m/s\n", (int)voxels_gone(), state_of(stone).velocity[2]);
    require(voxels_gone() > 0 && state_of(stone).velocity[2] > 8, "the ball is through");
    OK(api->destroy_world(world));
    return 0;
}
