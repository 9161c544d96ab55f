/* A car: a chassis on four wheels with suspension, driven and steered. */
#include "cookbook.h"

static void add_wheel(rubble_shape chassis, double x, double z, double steering) {
    rubble_joint_settings wheel = {.struct_size = sizeof wheel, .kind = RUBBLE_JOINT_WHEEL};
    rubble_collision_shape round = {.struct_size = sizeof round, .kind = RUBBLE_COLLISION_CYLINDER_X};
    rubble_shape_settings disc = {.struct_size = sizeof disc, .source = RUBBLE_SHAPE_INDICES, .size = {4, 12, 12}};
    uint8_t rubber[576]; /* a disc: a full box would be touched as a box */
    rubble_joint made;
    for (int i = 0, u, v; i < 576; ++i) /* u and v in half cells from the axle */
        u = i / 4 % 12 * 2 - 11, v = i / 48 * 2 - 11, rubber[i] = u * u + v * v < 144 ? 19 : 0;
    disc.body = make_body(x - 0.1, 0, z - 0.3, 0), disc.indices = rubber, disc.count = 576, disc.voxel_size = 0.05;
    OK(api->create_shape(world, &disc, &round.shape));
    wheel.shapes[0] = chassis, wheel.max_steer_angle = steering, wheel.drive_torque = 2000, wheel.brake_torque = 4000;
    wheel.shapes[1] = round.shape;
    wheel.position[0] = x, wheel.position[1] = 0.3, wheel.position[2] = z, wheel.anchor_radius = 0.6;
    wheel.spring_hertz = 8, wheel.spring_damping_ratio = 0.6; /* of the wheel's mass against the car's */
    OK(api->set_collision_shape(world, &round));
    OK(api->create_joint(world, &wheel, &made));
}

int main(void) {
    rubble_drive drive = {.struct_size = sizeof drive, .throttle = 0.25};
    rubble_shape chassis;
    double start;
    begin();
    drive.body = make_body(-0.8, 0.3, -6, 0);
    chassis = make_box(drive.body, 0, 0, 0, 16, 5, 30, WOOD);
    add_wheel(chassis, 0.95, -3.5, 0.5), add_wheel(chassis, -0.95, -3.5, 0.5);
    add_wheel(chassis, 0.95, -5.5, 0), add_wheel(chassis, -0.95, -5.5, 0);
    steps(60);
    start = state_of(drive.body).position[2];
    OK(api->drive_wheels(world, &drive));
    steps(90);
    printf("driven %.1f m\n", state_of(drive.body).position[2] - start);
    require(state_of(drive.body).position[2] - start > 3, "the car drives");
    OK(api->destroy_world(world));
    return 0;
}
