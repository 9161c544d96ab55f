/* Examples: bodies, joints, wheels and hands. */
#include "example.h"

EXAMPLE(set_body) {
    rubble_body_change change = {.struct_size = sizeof change, .fields = RUBBLE_SET_POSE | RUBBLE_SET_VELOCITY};
    change.body = crate;
    change.position[1] = 3, change.velocity[2] = 4; /* the other fields of these two stay 0 */
    OK(api->set_body(world, &change));
    steps(1);
    require(state_of(crate).position[1] > 2.9, "the crate is up there");
}

EXAMPLE(destroy_body) {
    rubble_body_state state;
    OK(api->destroy_body(world, crate)); /* its shapes go with it */
    steps(1);
    require(api->get_body_state(world, crate, &state) == RUBBLE_ERROR_STALE, "its handle names nothing any more");
}

EXAMPLE(destroy_shape) {
    OK(api->destroy_shape(world, wall)); /* and its body, which has no other */
    steps(1);
}

EXAMPLE(get_body_properties) {
    rubble_body_properties properties = {.struct_size = sizeof properties};
    OK(api->get_body_properties(world, crate, &properties));
    require(properties.mass > 100 && properties.center[0] > 0.39, "a crate of wood, and its middle");
}

EXAMPLE(set_shape) {
    rubble_shape_change light = {.struct_size = sizeof light, .fields = RUBBLE_SHAPE_DENSITY, .shape = crate_box};
    rubble_shape_properties properties = {.struct_size = sizeof properties};
    light.density = 0.5; /* of what its materials weigh */
    OK(api->set_shape(world, &light));
    steps(1);
    OK(api->get_shape_properties(world, crate_box, &properties));
    require(properties.density == 0.5 && properties.strength == 1, "half as heavy, as strong as before");
}

EXAMPLE(get_anchors) {
    rubble_cell_box anchor;
    uint32_t count;
    OK(api->get_anchors(world, wall, &anchor, 1, &count));
    require(anchor.low[1] == 0 && anchor.size[1] == 1, "its lowest layer holds it to the world");
}

EXAMPLE(set_collision_filter) {
    rubble_collision_filter ghost = {.struct_size = sizeof ghost, .shape = crate_box};
    ghost.mask = RUBBLE_COLLISION_NONE;
    OK(api->set_collision_filter(world, &ghost));
    steps(30);
    require(state_of(crate).position[1] < -0.2, "it sinks through the floor");
}

EXAMPLE(set_collision_shape) {
    rubble_shape_settings voxels = {.struct_size = sizeof voxels, .source = RUBBLE_SHAPE_SPHERE, .size = {9, 9, 9}};
    rubble_collision_shape ball = {.struct_size = sizeof ball, .kind = RUBBLE_COLLISION_SPHERE};
    voxels.body = make_body(4, 3, 0, 0);
    voxels.index = WOOD;
    OK(api->create_shape(world, &voxels, &ball.shape));
    OK(api->set_collision_shape(world, &ball)); /* it is drawn as a ball of voxels, and rolls as one */
    steps(1);
}

EXAMPLE(add_joint) {
    rubble_joint_settings hook = {.struct_size = sizeof hook, .kind = RUBBLE_JOINT_BALL, .shapes = {crate_box, 0}};
    rubble_joint_state joint;
    uint32_t count;
    hook.position[1] = 0.8, hook.position[2] = -1.6; /* at the crate's top */
    OK(api->add_joint(world, &hook));                /* create_joint() gives its handle at once */
    steps(1);
    OK(api->get_joint_states(world, &joint, 1, &count));
    require(count == 1 && joint.shapes[0] == crate_box, "the crate hangs in the world");
    OK(api->remove_joint(world, joint.joint));
}

EXAMPLE(set_joint_motor) {
    rubble_joint_settings axle = {.struct_size = sizeof axle, .kind = RUBBLE_JOINT_HINGE}; /* about x */
    rubble_joint_motor motor = {.struct_size = sizeof motor, .motor = RUBBLE_MOTOR_SPEED};
    const rubble_body propeller = make_body(4, 3, 0, 0);
    axle.shapes[1] = make_box(propeller, 0, 0, 0, 1, 20, 2, WOOD); /* shapes[0] is 0: the world */
    axle.position[0] = 4, axle.position[1] = 4, axle.position[2] = 0.1;
    OK(api->create_joint(world, &axle, &motor.joint));
    motor.motor_target = 5, motor.motor_max_force = 1e4; /* rad/s, N m */
    OK(api->set_joint_motor(world, &motor));
    steps(60);
    require(state_of(propeller).angular_velocity[0] * state_of(propeller).angular_velocity[0] > 20, "it turns");
}

EXAMPLE(drive_wheels) {
    rubble_joint_settings wheel = {.struct_size = sizeof wheel, .kind = RUBBLE_JOINT_WHEEL};
    rubble_drive drive = {.struct_size = sizeof drive, .body = crate, .throttle = 1};
    const rubble_body tyre = make_body(0.5, 0.2, -1.9, 0);
    rubble_joint joint;
    wheel.shapes[0] = crate_box, wheel.shapes[1] = make_box(tyre, 0, 0, 0, 2, 6, 6, WOOD);
    wheel.position[0] = 0.5, wheel.position[1] = 0.5, wheel.position[2] = -1.6, wheel.anchor_radius = 0.5;
    wheel.drive_torque = 200, wheel.spring_hertz = 4;
    OK(api->create_joint(world, &wheel, &joint)); /* a car has four: see the cookbook */
    steps(1);
    OK(api->drive_wheels(world, &drive));
    steps(30);
    require(state_of(tyre).angular_velocity[0] * state_of(tyre).angular_velocity[0] > 1, "the wheel spins");
}

EXAMPLE(grab_body) {
    rubble_grab hold = {.struct_size = sizeof hold, .body = crate, .point = {0, 0.8, -1.6}, .target = {0, 2.5, -1.6}};
    rubble_release drop = {.struct_size = sizeof drop, .impulse = {0, 0, -500}};
    hold.max_force = 10000;
    OK(api->grab_body(world, &hold)); /* again with each new target */
    steps(90);
    require(state_of(crate).position[1] > 1, "it hangs at the hand");
    OK(api->release_body(world, &drop)); /* and throws it */
    steps(1);
}

EXAMPLE(constrain_bodies) {
    rubble_body_constraint lift = {.struct_size = sizeof lift, .body = crate, .direction = {0, 1, 0}, .speed = 1};
    lift.position[1] = 0.4, lift.position[2] = -1.6, lift.max_force = 20000;
    for (int i = 0; i < 60; ++i) { /* each holds for one step */
        lift.position[1] = state_of(crate).position[1] + 0.4;
        OK(api->constrain_bodies(world, &lift));
        steps(1);
    }
    require(state_of(crate).position[1] > 0.9, "it went up by a metre in a second");
    lift.kind = RUBBLE_CONSTRAINT_ANGULAR_VELOCITY, lift.speed = 3;
    OK(api->constrain_bodies(world, &lift));
    steps(1);
    require(state_of(crate).angular_velocity[1] > 2.9, "and turns while it falls");
}

EXAMPLE(get_joint_properties) {
    rubble_joint_settings rail = {.struct_size = sizeof rail, .kind = RUBBLE_JOINT_PRISMATIC, .shapes = {0, crate_box}};
    rubble_joint_properties now = {.struct_size = sizeof now};
    rubble_joint_state row;
    rubble_joint joint;
    rail.position[1] = 0.4, rail.position[2] = -1.6; /* along x */
    rail.flags = RUBBLE_JOINT_LIMITED, rail.lower_limit = -0.5, rail.upper_limit = 0.5;
    rail.motor = RUBBLE_MOTOR_SPEED, rail.motor_target = 1, rail.motor_max_force = 20000;
    OK(api->create_joint(world, &rail, &joint));
    steps(15);
    OK(api->get_joint_properties(world, joint, &now));
    require(now.movement > 0.15 && now.movement < 0.3 && now.upper_limit == 0.5, "it is on its way to its end");
    require(now.rotation[3] == 1, "its axis is x of the world");
    OK(api->get_joint_state(world, joint, &row));
    require(row.shapes[1] == crate_box, "the shapes that it joins");
}

EXAMPLE(get_rope_points) {
    rubble_joint_settings rope = {.struct_size = sizeof rope, .kind = RUBBLE_JOINT_ROPE, .shapes = {crate_box, wall}};
    double points[3 * 64]; /* x, y, z of each */
    rubble_joint joint;
    uint32_t count;
    rope.position[1] = 0.8, rope.position[2] = -1.6;
    rope.rope_end[1] = 2, rope.rope_length = 2.5;
    OK(api->create_joint(world, &rope, &joint));
    steps(1);
    OK(api->get_rope_points(world, joint, points, 3 * 64, &count));
    require(count >= 6 && count % 3 == 0, "points to draw it through");
    OK(api->detach_joint(world, joint, wall)); /* it falls from the wall */
}

EXAMPLE(get_ropes) {
    rubble_joint_settings rope = {.struct_size = sizeof rope, .kind = RUBBLE_JOINT_ROPE, .shapes = {crate_box, wall}};
    rubble_rope_point points[64];
    uint32_t count;
    rope.position[1] = 0.8, rope.position[2] = -1.6;
    rope.rope_end[1] = 2, rope.rope_length = 2.5;
    OK(api->add_joint(world, &rope));
    steps(1);
    OK(api->get_ropes(world, points, 64, &count));
    for (uint32_t i = 0; i + 1 < count; ++i)
        if (!points[i].is_last) require(points[i].joint == points[i + 1].joint, "draw a line from i to i + 1");
    require(count > 2 && points[count - 1].is_last, "one rope");
}

EXAMPLE(get_joint_states) {
    rubble_joint_settings hook = {.struct_size = sizeof hook, .kind = RUBBLE_JOINT_BALL, .shapes = {crate_box, 0}};
    rubble_joint_state rows[8];
    rubble_joint joint;
    uint32_t count;
    hook.position[1] = 0.8, hook.position[2] = -1.6;
    OK(api->create_joint(world, &hook, &joint));
    steps(1);
    OK(api->get_joint_states(world, rows, 8, &count));
    require(count == 1 && rows[0].joint == joint && rows[0].second_anchor[1] == 0.8, "where it holds its sides");
}
