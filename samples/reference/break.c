/* Examples: edits of voxels and of whole shapes, what they came to, and fire. */
#include "example.h"

EXAMPLE(carve) {
    rubble_carve hole = {.struct_size = sizeof hole, .position = {0, 1.5, 0.15}};
    hole.radii[0] = hole.radii[1] = hole.radii[2] = 0.4; /* metres, of soft, medium and hard materials */
    OK(api->carve(world, &hole));
    steps(1);
    require(voxels_gone() > 0, "a hole in the wall");
}

EXAMPLE(count_carve) {
    rubble_carve hole = {.struct_size = sizeof hole, .position = {0, 1.5, 0.15}, .radii = {0.4, 0.4, 0.4}};
    uint64_t voxels;
    OK(api->count_carve(world, &hole, &voxels)); /* before it is done */
    OK(api->carve(world, &hole));
    steps(1);
    require(voxels > 0 && voxels == voxels_gone(), "as many as the step removes");
}

EXAMPLE(break_voxels) {
    rubble_break hit = {.struct_size = sizeof hit, .position = {0, 1.5, 0}, .radii = {0.6, 0.6, 0.6}};
    rubble_events events = {.struct_size = sizeof events};
    OK(api->break_voxels(world, &hit));
    steps(1);
    OK(api->get_events(world, &events));
    require(events.split_count > 0, "fragments, each a body of its own");
}

EXAMPLE(explode) {
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 0.5, -0.5}, .size = 1.5};
    OK(api->explode(world, &bang));
    steps(1);
    require(voxels_gone() > 0, "the wall is broken");
    require(state_of(crate).velocity[2] < 0, "the crate flies away from it");
}

EXAMPLE(paint) {
    rubble_paint spray = {.struct_size = sizeof spray, .color = {200, 30, 30}, .position = {0, 1, 0}};
    rubble_events events = {.struct_size = sizeof events};
    spray.radius = 0.5, spray.strength = 255;
    OK(api->paint(world, &spray));
    steps(1);
    OK(api->get_events(world, &events));
    require(events.painted_voxel_count > 0, "a red spot on the wall");
}

EXAMPLE(apply_impulse) {
    rubble_impulse push = {.struct_size = sizeof push, .body = crate, .position = {0, 0.4, -2}};
    push.impulse[0] = 2000; /* N s */
    OK(api->apply_impulse(world, &push));
    steps(1);
    require(state_of(crate).velocity[0] > 1, "the crate slides away");
}

EXAMPLE(get_events) {
    rubble_carve cut = {.struct_size = sizeof cut, .brush = RUBBLE_BRUSH_BOX, .position = {0, 1, 0.15}};
    rubble_events events = {.struct_size = sizeof events};
    cut.half_size[0] = 3, cut.half_size[1] = 0.1, cut.half_size[2] = 0.5; /* right through the wall */
    OK(api->carve(world, &cut));
    steps(1);
    OK(api->get_events(world, &events)); /* the lists live until the next step() */
    require(events.removed_count == 1 && events.removed[0].shape == wall, "voxels of one colour");
    require(events.split_count == 1 && events.splits[0].parent == wall, "its upper part came off");
    require(events.bodies_created_count == 1, "and is a body of its own");
}

EXAMPLE(get_voxel_accounting) {
    rubble_voxel_accounting sums = {.struct_size = sizeof sums};
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    OK(api->explode(world, &bang));
    steps(1);
    OK(api->get_voxel_accounting(world, &sums));
    require(sums.imported == sums.standing + sums.in_pieces + sums.removed, "no voxel is lost");
}

EXAMPLE(write_voxels) {
    rubble_voxel_box door = {.struct_size = sizeof door, .shape = wall, .low = {16, 0, 0}, .size = {8, 20, 3}};
    static const uint8_t nothing[8 * 20 * 3]; /* palette indices, x fastest; 0: no voxel */
    OK(api->write_voxels(world, &door, nothing, sizeof nothing));
    steps(1);
    require(voxels_gone() == 0, "what a host overwrites is not counted as broken");
}

EXAMPLE(read_voxels) {
    rubble_voxel_box corner = {.struct_size = sizeof corner, .shape = wall, .size = {2, 2, 2}};
    uint8_t cells[8];
    uint64_t count;
    OK(api->read_voxels(world, &corner, cells, sizeof cells, &count));
    require(count == 8 && cells[0] == BRICK, "palette indices");
}

EXAMPLE(split_shape) {
    const rubble_voxel_run parts[3] = {{36, WOOD}, {9, 0}, {36, WOOD}}; /* two that do not touch, as levels have them */
    rubble_shape_settings loose = {.struct_size = sizeof loose, .source = RUBBLE_SHAPE_RUNS, .size = {3, 3, 9}};
    rubble_shape shape;
    loose.body = make_body(4, 3, 0, 0), loose.runs = parts, loose.count = 3;
    OK(api->create_shape(world, &loose, &shape));
    OK(api->split_shape(world, shape));
    steps(1);
    require(state_of(loose.body).shape_count == 2, "each part is a shape of the body");
}

EXAMPLE(merge_shape) {
    const rubble_body table = make_body(4, 0, 0, 0);
    const rubble_shape leg = make_box(table, 0.4, 0, 0.4, 2, 7, 2, WOOD); /* cookbook.h */
    const rubble_shape top = make_box(table, 0, 0.7, 0, 10, 1, 10, WOOD);
    OK(api->merge_shape(world, leg, top));
    steps(1);
    require(state_of(table).shape_count == 1, "one shape, which breaks as one");
}

EXAMPLE(trim_shape) {
    rubble_resize resize = {.struct_size = sizeof resize, .shape = wall, .size = {40, 50, 3}};
    rubble_shape_state states[8];
    uint32_t count;
    OK(api->resize_shape(world, &resize)); /* room to build higher */
    OK(api->trim_shape(world, wall));      /* and back to what its voxels need */
    steps(1);
    OK(api->get_shape_states(world, 0, states, 8, &count));
    require(states[1].shape == wall && states[1].size[1] == 25, "as high as before");
}

EXAMPLE(resize_shape) {
    rubble_resize resize = {.struct_size = sizeof resize, .shape = wall, .low = {-8, 0, 0}, .size = {48, 25, 3}};
    rubble_voxel_box cell = {.struct_size = sizeof cell, .shape = wall, .low = {7, 0, 0}, .size = {1, 1, 1}};
    const uint8_t brick = BRICK;
    OK(api->resize_shape(world, &resize)); /* 8 cells more at its left, which are its first ones now */
    OK(api->write_voxels(world, &cell, &brick, 1));
    steps(1);
}

EXAMPLE(heat) {
    rubble_heat match = {.struct_size = sizeof match, .flags = RUBBLE_HEAT_IGNITE, .position = {0, 0.4, -2}};
    rubble_extinguish hose = {.struct_size = sizeof hose, .position = {0, 0.4, -2}, .radius = 3, .wet_seconds = 20};
    uint32_t burning, left;
    OK(api->heat(world, &match)); /* of the crate: brick does not burn */
    steps(2);
    OK(api->get_fires(world, NULL, 0, &burning));
    OK(api->extinguish(world, &hose));
    steps(1);
    OK(api->get_fires(world, NULL, 0, &left));
    require(burning > 0 && left == 0, "a fire, and its end");
}

EXAMPLE(get_fires) {
    rubble_heat match = {.struct_size = sizeof match, .flags = RUBBLE_HEAT_IGNITE, .position = {0, 0.4, -2}};
    const double here[3] = {0, 0, 0}, low[3] = {-1, 0, -3}, high[3] = {1, 1, -1};
    rubble_fire fires[64], closest;
    uint32_t count, in_box;
    OK(api->heat(world, &match));
    steps(2);
    OK(api->get_fires(world, fires, 64, &count));
    OK(api->count_fires(world, low, high, &in_box));
    OK(api->find_closest_fire(world, here, 10, &closest));
    require(in_box == count && closest.shape == crate_box && fires[0].intensity > 0, "the crate burns");
    OK(api->remove_fires(world, low, high));
}
