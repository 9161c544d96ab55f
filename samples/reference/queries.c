/* Examples: rays, casts, overlaps, closest points. */
#include "example.h"

EXAMPLE(cast_ray) {
    const double eye[3] = {0, 0.4, -5}, forward[3] = {0, 0, 1};
    rubble_hit hit;
    OK(api->cast_ray(world, eye, forward, 100, &hit)); /* at most 100 m */
    require(hit.hit && hit.body == crate, "the crate");
    require(hit.distance > 2.9 && hit.distance < 3.1, "three metres away");
    require(hit.normal[2] < -0.99, "its face towards the eye");
}

EXAMPLE(cast_rays) {
    const rubble_ray rays[2] = {{{0, 0.4, -5}, {0, 0, 1}, 100, 0}, {{0, 0.4, -5}, {0, 1, 0}, 100, 0.2}};
    rubble_query_filter filter = {.struct_size = sizeof filter, .rejected_bodies = &crate, .rejected_body_count = 1};
    rubble_hit hits[2];
    OK(api->cast_rays(world, rays, 2, &filter, hits)); /* many at once are faster than one by one */
    require(hits[0].shape == wall && !hits[1].hit, "the wall behind the crate; nothing above");
}

EXAMPLE(cast_shapes) {
    rubble_shape_cast slide = {.shape = {.kind = RUBBLE_QUERY_BOX, .position = {0, 0.5, -5}}, .direction = {0, 0, 1}};
    rubble_hit hit;
    slide.shape.half_size[0] = slide.shape.half_size[1] = slide.shape.half_size[2] = 0.4;
    slide.max_distance = 10;
    OK(api->cast_shapes(world, &slide, 1, NULL, &hit));
    require(hit.body == crate && hit.distance > 2.5 && hit.distance < 2.7, "how far the box moves");
}

EXAMPLE(overlap_bodies) {
    const rubble_query_shape blast = {.kind = RUBBLE_QUERY_SPHERE, .position = {0, 0.5, -1}, .radius = 2};
    rubble_query_filter free = {.struct_size = sizeof free, .flags = RUBBLE_FILTER_REJECT_STATIC};
    rubble_body bodies[16];
    uint32_t count;
    OK(api->overlap_bodies(world, &blast, &free, bodies, 16, &count));
    require(count == 1 && bodies[0] == crate, "the crate, which is free");
}

EXAMPLE(overlap_shapes) {
    const rubble_query_shape blast = {.kind = RUBBLE_QUERY_SPHERE, .position = {0, 0.5, -1}, .radius = 2};
    rubble_shape shapes[16];
    uint32_t count;
    OK(api->overlap_shapes(world, &blast, NULL, shapes, 16, &count));
    require(count == 3, "the floor, the wall and the crate");
}

EXAMPLE(find_closest_point) {
    const double here[3] = {0, 0.5, -3};
    rubble_hit hit;
    OK(api->find_closest_point(world, here, 10, NULL, &hit));
    require(hit.hit && hit.distance < 0.51 && hit.position[1] < 0.01, "the floor is closer than the crate");
}
