/* An elevator: a cabin on a vertical rail whose motor lifts it and a crate to a height and holds them there. */
#include "cookbook.h"

int main(void) {
    const double up[4] = {0, 0, 0.70710678118654752, 0.70710678118654752}; /* the joint's x axis points up */
    rubble_joint_settings rail = {.struct_size = sizeof rail, .kind = RUBBLE_JOINT_PRISMATIC};
    rubble_joint_motor motor = {.struct_size = sizeof motor, .motor = RUBBLE_MOTOR_POSITION, .motor_target = 3};
    const rubble_body cabin = (begin(), make_body(0, 0.05, 0, 0)), crate = make_body(0.2, 0.25, 0.6, 0);
    rail.shapes[0] = make_box(make_body(-0.3, 0, 0.7, RUBBLE_BODY_STATIC), 0, 0, 0, 2, 60, 4, METAL);
    rail.shapes[1] = make_box(cabin, 0, 0, 0, 18, 2, 18, WOOD);
    make_box(crate, 0, 0, 0, 6, 6, 6, WOOD);
    rail.position[1] = 0.1, rail.position[2] = 0.9, memcpy(rail.rotation, up, sizeof up);
    rail.motor = RUBBLE_MOTOR_POSITION, rail.motor_max_force = motor.motor_max_force = 20000;
    OK(api->create_joint(world, &rail, &motor.joint));
    steps(60);
    OK(api->set_joint_motor(world, &motor));
    steps(240);
    printf("the cabin is at %.2f m, the crate at %.2f m\n", state_of(cabin).position[1], state_of(crate).position[1]);
    require(state_of(cabin).position[1] > 2.5 && state_of(crate).position[1] > 2.5, "both are up");
    OK(api->destroy_world(world));
    return 0;
}
