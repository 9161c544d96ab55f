/* A bomb with a fuse: after a second it explodes, breaks what is around it and pushes the rest away. */
#include "cookbook.h"

int main(void) {
    rubble_explosion explosion = {.struct_size = sizeof explosion, .position = {0, 0.5, 0}, .size = 2};
    rubble_events events = {.struct_size = sizeof events};
    const rubble_body crate = (begin(), make_body(1.6, 0, -0.4, 0));
    int fuse = 60;
    make_box(crate, 0, 0, 0, 8, 8, 8, WOOD);
    make_box(make_body(-2, 0, 1, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 3, BRICK);
    while (fuse-- > 0) steps(1);
    OK(api->explode(world, &explosion));
    steps(1);
    OK(api->get_events(world, &events));
    printf("%u pieces flew off, the crate at %.1f m/s\n", events.split_count, state_of(crate).velocity[0]);
    require(events.split_count > 0 && state_of(crate).velocity[0] > 0.5, "pieces, and a crate that flies");
    OK(api->destroy_world(world));
    return 0;
}
