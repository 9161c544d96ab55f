/* Build: voxels are written into a shape and read back. What then touches nothing comes off. */
#include "cookbook.h"

int main(void) {
    rubble_shape_settings plot = {.struct_size = sizeof plot, .source = RUBBLE_SHAPE_EMPTY, .size = {16, 16, 16}};
    rubble_voxel_box column = {.struct_size = sizeof column, .size = {2, 10, 2}};
    rubble_voxel_box top = {.struct_size = sizeof top, .low = {0, 9, 0}, .size = {8, 2, 8}};
    uint8_t bricks[128], back[40];
    uint64_t count;
    rubble_events events = {.struct_size = sizeof events};
    begin();
    memset(bricks, BRICK, sizeof bricks);
    plot.body = make_body(0, 0, 0, RUBBLE_BODY_STATIC);
    OK(api->create_shape(world, &plot, &column.shape));
    top.shape = column.shape;
    OK(api->write_voxels(world, &column, bricks, 40));
    OK(api->write_voxels(world, &top, bricks, 128));
    steps(1);
    OK(api->read_voxels(world, &column, back, 40, &count));
    require(count == 40 && memcmp(back, bricks, 40) == 0, "what was written");
    memset(bricks, 0, sizeof bricks); /* the column goes: its top falls */
    column.low[1] = 4, column.size[1] = 2;
    OK(api->write_voxels(world, &column, bricks, 8));
    steps(1);
    OK(api->get_events(world, &events));
    printf("%u piece came off\n", events.split_count);
    require(events.split_count == 1, "the top");
    OK(api->destroy_world(world));
    return 0;
}
