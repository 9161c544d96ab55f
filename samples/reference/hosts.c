/* Examples: reports, own physics, own drawing, the renderer. */
#include "example.h"

EXAMPLE(get_reports) {
    rubble_report_filter filter = {.struct_size = sizeof filter, .kinds = RUBBLE_REPORT_BREAK, .min_impulse = 1};
    rubble_explosion bang = {.struct_size = sizeof bang, .position = {0, 1, 0}};
    rubble_reports reports = {.struct_size = sizeof reports};
    OK(api->set_report_filter(world, &filter)); /* once; what is not asked for costs nothing */
    OK(api->explode(world, &bang));
    steps(1);
    OK(api->get_reports(world, &reports)); /* the lists live until the next step() */
    require(reports.break_count > 0 && reports.breaks[0].voxels > 0, "where a sound of breaking brick comes from");
}

EXAMPLE(get_rigid_bodies) {
    rubble_rigid_body rows[16];
    uint32_t count, i;
    OK(api->get_rigid_bodies(world, RUBBLE_BODIES_ALL, rows, 16, &count)); /* in each step: RUBBLE_BODIES_CHANGED */
    for (i = 0; i < count && rows[i].body != crate; ++i) {
    }
    require(i < count && rows[i].mass > 100 && rows[i].inertia[0] > 0, "what the host's physics needs of the crate");
}

EXAMPLE(get_body_boxes) {
    rubble_body_box boxes[16];
    uint32_t count;
    OK(api->get_body_boxes(world, crate, boxes, 16, &count));
    require(count == 1 && boxes[0].half_size[0] > 0.39, "one box is all of the crate");
}

EXAMPLE(get_body_impulses) {
    rubble_impulse push = {.struct_size = sizeof push, .body = crate, .impulse = {0, 0, 50}};
    rubble_body_impulse rows[16];
    uint32_t count;
    OK(api->apply_impulse(world, &push)); /* as explosions do */
    steps(1);
    OK(api->get_body_impulses(world, rows, 16, &count)); /* which the host's physics has to apply */
    require(count == 1 && rows[0].body == crate && rows[0].impulse[2] == 50, "a push of the crate");
}

EXAMPLE(report_impacts) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_HOST_PHYSICS};
    rubble_impact impact = {.normal = {0, 1, 0}, .impulse = 1e5, .speed = 20};
    rubble_body_state moved;
    OK(api->destroy_world(world));
    OK(api->create_world(&settings, &world)); /* one that the host moves */
    impact.body = make_body(0, 5, 0, 0);
    make_box(impact.body, 0, 0, 0, 8, 8, 8, BRICK);
    steps(1);
    moved = state_of(impact.body);
    moved.position[1] = 0; /* where a step of the host's physics has put it */
    OK(api->set_body_states(world, &moved, 1));
    OK(api->report_impacts(world, &impact, 1)); /* and what it hit there */
    steps(1);
    require(voxels_gone() > 0, "the step breaks it");
}

EXAMPLE(mesh_brick) {
    static rubble_mesh_vertex vertices[RUBBLE_MAX_BRICK_VERTICES];
    rubble_brick_changes changes = {.struct_size = sizeof changes, .what = RUBBLE_BRICKS_MESHES, .shape = wall};
    rubble_brick bricks[64];
    uint64_t version;
    uint32_t count, vertex_count, i, quads = 0;
    OK(api->get_changed_bricks(world, &changes, &version, bricks, 64, &count));
    for (i = 0; i < count; ++i) {
        const int32_t brick[3] = {bricks[i].x, bricks[i].y, bricks[i].z};
        OK(api->mesh_brick(world, wall, brick, vertices, RUBBLE_MAX_BRICK_VERTICES, &vertex_count));
        quads += vertex_count / 4; /* two triangles each: 0 1 2 and 0 2 3 */
    }
    changes.since = version; /* next time: what has changed since */
    OK(api->get_changed_bricks(world, &changes, &version, bricks, 64, &count));
    require(quads > 0 && count == 0, "all bricks once, then none");
}

EXAMPLE(read_bricks) {
    const rubble_brick first = {0, 0, 0, 0};
    uint8_t data[RUBBLE_BRICK_BYTES];
    uint64_t size;
    OK(api->read_bricks(world, wall, &first, 1, data, sizeof data, &size));
    require(size == sizeof data && data[0] == BRICK, "512 palette indices, then 512 bytes of paint");
}

EXAMPLE(get_shadow_bricks) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_SHADOW_DATA};
    static rubble_shadow_brick bricks[256];
    uint64_t version;
    uint32_t count;
    OK(api->destroy_world(world));
    settings.flags |= RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_NO_RENDERER;
    OK(api->create_world(&settings, &world));
    make_box(make_body(0, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 8, 8, 8, BRICK);
    steps(2);
    OK(api->get_shadow_bricks(world, 0, &version, bricks, 256, &count)); /* next time: with this version */
    require(count == 1 && bricks[0].occupied != 0, "one brick of 16 x 16 x 16 cells");
}

EXAMPLE(spawn_particles) {
    rubble_particle_burst sparks = {.struct_size = sizeof sparks, .kind = RUBBLE_PARTICLE_SPARK, .count = 20};
    rubble_particle rows[64];
    uint32_t count;
    sparks.position[1] = 2, sparks.velocity[1] = 3, sparks.spread = 2, sparks.glow = 1;
    OK(api->spawn_particles(world, &sparks));
    OK(api->get_particles(world, rows, 64, &count)); /* for hosts that draw them; the renderer does by itself */
    require(count == 20 && rows[0].kind == RUBBLE_PARTICLE_SPARK, "twenty sparks");
}

EXAMPLE(create_renderer) {
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .preset = "fast"};
    rubble_renderer renderer;
    settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    OK(api->create_renderer(world, &settings, &renderer)); /* the host's GL context is current */
    OK(api->destroy_renderer(renderer));
}

EXAMPLE(set_overlay) {
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_RENDERER_COMPILE_LATE};
    rubble_view view = {.struct_size = sizeof view, .framebuffer = framebuffer, .width = 64, .height = 36};
    const uint8_t red[4] = {255, 0, 0, 255};
    rubble_overlay_image image = {.struct_size = sizeof image, .width = 1, .height = 1, .name = "dot", .pixels = red};
    rubble_overlay_item items[3] = {{.struct_size = sizeof items[0], .kind = RUBBLE_OVERLAY_TEXT}};
    double size[2];
    rubble_renderer renderer;
    items[0].text = "Ammo: 12", items[0].font_size = 12; /* from the left upper corner */
    items[0].color[0] = items[0].color[1] = items[0].color[3] = 1;
    OK(api->measure_text(&items[0], size));
    require(size[0] > 40 && size[1] > 12, "width and height in pixels");
    items[1] = items[0], items[1].kind = RUBBLE_OVERLAY_BOX; /* a frame round it */
    items[1].size[0] = size[0], items[1].size[1] = size[1], items[1].stroke = 1;
    items[2] = items[0], items[2].kind = RUBBLE_OVERLAY_IMAGE; /* a dot over a place of the world */
    items[2].text = "dot", items[2].flags = RUBBLE_OVERLAY_IN_WORLD | RUBBLE_OVERLAY_FACING;
    items[2].size[0] = items[2].size[1] = 10, items[2].align[0] = items[2].align[1] = 0.5, items[2].position[1] = 2;
    OK(api->create_renderer(world, &settings, &renderer));
    OK(api->set_overlay_image(renderer, &image));
    OK(api->set_overlay(renderer, items, 3));
    steps(1);
    OK(api->draw(renderer, &view)); /* each draw() has it, until it is set again */
    OK(api->destroy_renderer(renderer));
}

EXAMPLE(draw) {
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_RENDERER_COMPILE_LATE};
    rubble_view view = {.struct_size = sizeof view, .framebuffer = framebuffer, .width = 64, .height = 36};
    rubble_draw_stats stats = {.struct_size = sizeof stats};
    rubble_renderer renderer;
    OK(api->create_renderer(world, &settings, &renderer)); /* once */
    steps(1);
    view.position[1] = 1.6, view.position[2] = -8; /* the camera looks along -z: */
    view.rotation[1] = 1;                          /* turned about y to look along z */
    view.alpha = 1;                                /* where the last step left all bodies */
    OK(api->draw(renderer, &view));
    OK(api->get_draw_stats(renderer, &stats));
    require(stats.shapes == 3 && stats.draw_calls > 0, "the floor, the wall and the crate");
    view.hidden_shapes = &wall, view.hidden_shape_count = 1; /* this view sees what is behind the wall */
    OK(api->draw(renderer, &view));
    OK(api->set_debug_view(renderer, "normal")); /* shows normals from the next draw() on; null: the finished frame */
    OK(api->destroy_renderer(renderer));
}
