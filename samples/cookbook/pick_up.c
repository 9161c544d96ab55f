/* Pick up and throw: a hand pulls what a ray finds toward a point before the player, and lets go with an impulse. */
#include "cookbook.h"

int main(void) {
    const double eye[3] = {0, 1.6, -3}, look[3] = {0, -0.4, 1};
    rubble_grab grab = {.struct_size = sizeof grab, .hand = 1, .target = {0, 1.6, -1.5}, .max_force = 2000};
    rubble_release release = {.struct_size = sizeof release, .hand = 1, .impulse = {0, 100, 400}};
    rubble_hit hit;
    double held;
    begin();
    make_box(make_body(-0.3, 0, 0.2, 0), 0, 0, 0, 6, 6, 6, WOOD);
    steps(30);
    OK(api->cast_ray(world, eye, look, 10, &hit));
    memcpy(grab.point, hit.position, sizeof grab.point);
    grab.body = hit.body;
    OK(api->grab_body(world, &grab));
    steps(120);
    held = state_of(hit.body).position[1];
    OK(api->release_body(world, &release));
    steps(15);
    printf("held at %.1f m, thrown at %.1f m/s\n", held, state_of(hit.body).velocity[2]);
    require(held > 0.8 && state_of(hit.body).velocity[2] > 1, "held up, then thrown");
    OK(api->destroy_world(world));
    return 0;
}
