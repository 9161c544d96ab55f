/* The second half of everything.c: properties, what hosts hear, draw and move for themselves. */
#include "everything.h"

/* What a host with rigid bodies of its own reads, and what it says of them in a world that it moves. */
void use_host_physics(void) {
    const rubble_body body = make_body(70.0, 2.0, 0.0, 0);
    rubble_world_settings settings = {.struct_size = sizeof settings};
    rubble_impulse push = {.struct_size = sizeof push};
    rubble_rigid_body rigid;
    rubble_body_box solid[4];
    rubble_body_impulse pushed;
    rubble_body_state state;
    rubble_impact impact;
    rubble_world own = world;
    uint32_t layers, count;
    OK(api->get_layers(&layers));
    CHECK(layers == (RUBBLE_LAYER_PHYSICS | RUBBLE_LAYER_RENDERER));
    make_box(body, 6, 6, 6, 5);
    steps(1);
    OK(api->get_body_boxes(world, body, solid, 4, &count));
    CHECK(count == 1);
    settings.flags = RUBBLE_WORLD_HOST_PHYSICS;
    OK(api->create_world(&settings, &world));
    push.body = make_body(0.0, 2.0, 0.0, 0), push.impulse[0] = 5.0;
    make_box(push.body, 6, 6, 6, 5);
    OK(api->apply_impulse(world, &push));
    steps(1);
    OK(api->get_rigid_bodies(world, RUBBLE_BODIES_CHANGED, &rigid, 1, &count));
    CHECK(count == 1 && rigid.body == push.body && rigid.mass > 0.0);
    OK(api->get_body_impulses(world, &pushed, 1, &count));
    CHECK(count == 1 && pushed.impulse[0] == 5.0);
    OK(api->get_body_state(world, push.body, &state));
    state.velocity[1] = -20.0;
    OK(api->set_body_states(world, &state, 1));
    memset(&impact, 0, sizeof impact);
    impact.body = push.body, impact.position[1] = 2.0, impact.normal[1] = 1.0;
    impact.impulse = 20.0 * rigid.mass, impact.speed = 20.0;
    OK(api->report_impacts(world, &impact, 1));
    steps(1);
    OK(api->destroy_world(world));
    world = own;
}

/* What bodies and shapes are beside their voxels. */
void use_properties(void) {
    const rubble_body body = make_body(70.0, 5.0, 0.0, 0);
    const rubble_shape shape = make_box(body, 4, 4, 4, 6),
                       base = make_box(make_body(70.0, 0.0, 0.0, RUBBLE_BODY_STATIC), 4, 4, 4, 6);
    rubble_body_change change = {.struct_size = sizeof change};
    rubble_body_properties weight = {.struct_size = sizeof weight};
    rubble_shape_change heavier = {.struct_size = sizeof heavier};
    rubble_shape_properties properties = {.struct_size = sizeof properties};
    rubble_light_group_settings bulb = {.struct_size = sizeof bulb};
    rubble_light_group_change off = {.struct_size = sizeof off};
    rubble_light_group_state group = {.struct_size = sizeof group};
    rubble_cell_box anchor;
    uint32_t count;
    OK(api->create_light_group(world, &bulb, &off.group));
    off.fields = RUBBLE_GROUP_SWITCH;
    OK(api->set_light_group(world, &off));
    change.body = body, change.fields = RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING, change.linear_damping = 0.5;
    OK(api->set_body(world, &change));
    heavier.shape = shape, heavier.fields = RUBBLE_SHAPE_DENSITY, heavier.density = 2.0;
    OK(api->set_shape(world, &heavier));
    steps(1);
    OK(api->get_body_properties(world, body, &weight));
    CHECK(weight.mass > 307.0 && weight.mass < 308.0 && weight.gravity_scale == 0.0 && weight.linear_damping == 0.5);
    OK(api->get_shape_properties(world, shape, &properties));
    CHECK(properties.density == 2.0 && properties.strength == 1.0 && properties.bears_load == 1);
    OK(api->get_light_group(world, off.group, &group));
    CHECK(group.flags == 0 && group.threshold > 0.39);
    OK(api->get_anchors(world, base, &anchor, 1, &count));
    CHECK(count == 1 && anchor.low[1] == 0 && anchor.size[1] == 1);
}

/* What a host hears: a crate that falls on a block. */
void use_reports(void) {
    const rubble_body ground = make_body(80.0, 0.0, 0.0, RUBBLE_BODY_STATIC), crate = make_body(80.2, 1.2, 0.2, 0);
    const rubble_shape floor = make_box(ground, 10, 10, 10, 6), box = make_box(crate, 4, 4, 4, 5);
    rubble_report_filter filter = {.struct_size = sizeof filter};
    rubble_reports reports = {.struct_size = sizeof reports};
    uint32_t heard = 0;
    filter.kinds = RUBBLE_REPORT_CONTACT_BEGUN, filter.min_impulse = 0.1;
    OK(api->set_report_filter(world, &filter));
    for (int i = 0; i < 60; ++i) {
        steps(1);
        OK(api->get_reports(world, &reports));
        for (uint32_t j = 0; j < reports.contact_count; ++j) {
            const rubble_contact* contact = &reports.contacts[j];
            if (contact->shapes[0] != box || contact->shapes[1] != floor) continue;
            CHECK(contact->materials[0] == 5 && contact->materials[1] == 6 && contact->hit_speed > 0.1);
            ++heard;
        }
    }
    CHECK(heard > 0); /* it may bounce */
}

/* A host that draws for itself: meshes and data of bricks. */
void use_bricks(void) {
    const rubble_shape box = make_box(make_body(90.0, 0.0, 0.0, RUBBLE_BODY_STATIC), 12, 8, 8, 6);
    rubble_brick_changes changes = {.struct_size = sizeof changes};
    rubble_mesh_vertex vertices[64];
    rubble_brick bricks[4];
    uint8_t data[2 * RUBBLE_BRICK_BYTES];
    const int32_t first[3] = {0, 0, 0};
    uint32_t count;
    uint64_t version, bytes;
    steps(1);
    changes.shape = box, changes.what = RUBBLE_BRICKS_MESHES;
    OK(api->get_changed_bricks(world, &changes, &version, bricks, 4, &count));
    CHECK(count == 2 && bricks[1].x == 1 && !bricks[1].is_empty);
    OK(api->mesh_brick(world, box, first, vertices, 64, &count));
    CHECK(count == 20 && vertices[0].material == 6); /* the sixth side is hidden by the other brick */
    OK(api->read_bricks(world, box, bricks, 2, data, sizeof data, &bytes));
    CHECK(bytes == sizeof data && data[0] == 6 && data[RUBBLE_BRICK_BYTES + 7] == 0);
    CHECK(api->get_shadow_bricks(world, 0, &version, NULL, 0, &count) == RUBBLE_ERROR_ARGUMENT);
    changes.since = version;
    steps(1);
    OK(api->get_changed_bricks(world, &changes, &version, bricks, 4, &count));
    CHECK(count == 0);
}

/* Particles: what a host throws, and all of them as rows. */
void use_particles(void) {
    rubble_particle_burst burst = {.struct_size = sizeof burst};
    rubble_particle rows[64];
    uint32_t before, count;
    OK(api->get_particles(world, NULL, 0, &before));
    burst.kind = RUBBLE_PARTICLE_SPARK, burst.count = 8, burst.position[1] = 50.0;
    OK(api->spawn_particles(world, &burst));
    OK(api->get_particles(world, NULL, 0, &count));
    CHECK(count == before + 8);
    CHECK(api->get_particles(world, rows, 1, &count) == RUBBLE_ERROR_CAPACITY);
}
