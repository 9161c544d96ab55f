/* A door on a hinge that opens by 90 degrees at most and closes by a spring. */
#include "cookbook.h"

int main(void) {
    const double upright[4] = {0, 0, 0.70710678118654752, 0.70710678118654752}; /* the joint's x axis points up */
    rubble_joint_settings hinge = {.struct_size = sizeof hinge, .kind = RUBBLE_JOINT_HINGE};
    rubble_impulse push = {.struct_size = sizeof push, .position = {0.8, 1, 0.1}, .impulse = {0, 0, 60}};
    rubble_joint made;
    double open = 0, z;
    int i;
    begin();
    hinge.shapes[0] = make_box(make_body(-0.3, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 3, 22, 2, BRICK);
    push.body = make_body(0.02, 0.1, 0, 0);
    hinge.shapes[1] = make_box(push.body, 0, 0, 0, 9, 20, 1, WOOD);
    hinge.position[1] = 1, hinge.position[2] = 0.05, memcpy(hinge.rotation, upright, sizeof upright);
    hinge.flags = RUBBLE_JOINT_LIMITED, hinge.lower_limit = -1.57, hinge.upper_limit = 1.57;
    hinge.spring_hertz = 0.5, hinge.spring_damping_ratio = 0.5;
    OK(api->create_joint(world, &hinge, &made));
    steps(1);
    OK(api->apply_impulse(world, &push));
    for (i = 0; i < 300; ++i) {
        steps(1);
        z = state_of(push.body).rotation[1];
        if (z * z > open) open = z * z;
    }
    z = state_of(push.body).rotation[1];
    printf("opened to %.2f, closed to %.2f (squared half sines)\n", open, z * z);
    require(open > 0.02 && z * z < 0.01, "a door that opens and closes");
    OK(api->destroy_world(world));
    return 0;
}
