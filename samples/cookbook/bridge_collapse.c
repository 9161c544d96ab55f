/* A bridge that falls when its pier is shot away: what nothing holds any more comes off by itself. */
#include "cookbook.h"

int main(void) {
    rubble_shape_settings bridge = {.struct_size = sizeof bridge, .source = RUBBLE_SHAPE_EMPTY, .size = {80, 23, 10}};
    rubble_voxel_box pier = {.struct_size = sizeof pier, .low = {38, 0, 0}, .size = {4, 20, 10}};
    rubble_voxel_box road = {.struct_size = sizeof road, .low = {0, 20, 0}, .size = {80, 3, 10}};
    rubble_carve charge = {.struct_size = sizeof charge, .brush = RUBBLE_BRUSH_BOX, .position = {0, 1, 0.5}};
    const double above[3] = {3, 10, 0.5}, down[3] = {0, -1, 0};
    static uint8_t concrete[80 * 3 * 10];
    rubble_hit before, after;
    begin();
    memset(concrete, CONCRETE, sizeof concrete);
    bridge.body = make_body(-4, 0, 0, RUBBLE_BODY_STATIC); /* its lowest cells, the pier's foot, hold it to the world */
    OK(api->create_shape(world, &bridge, &pier.shape));
    road.shape = pier.shape;
    OK(api->write_voxels(world, &pier, concrete, 4 * 20 * 10));
    OK(api->write_voxels(world, &road, concrete, sizeof concrete));
    steps(1);
    OK(api->cast_ray(world, above, down, 20, &before));
    charge.half_size[0] = charge.half_size[2] = 1, charge.half_size[1] = 0.8;
    OK(api->carve(world, &charge));
    steps(180);
    OK(api->cast_ray(world, above, down, 20, &after));
    printf("the road was at %.1f m and lies at %.1f m\n", before.position[1], after.position[1]);
    require(before.position[1] > 2.2 && after.position[1] < 1.5, "the road has fallen");
    OK(api->destroy_world(world));
    return 0;
}
