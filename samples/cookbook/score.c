/* A score: shapes have tags, and what is destroyed of each is counted by the tag of what it came off. */
#include "cookbook.h"

int main(void) {
    rubble_explosion explosion = {.struct_size = sizeof explosion, .position = {0, 0.8, -0.3}, .size = 1.5};
    rubble_events events = {.struct_size = sizeof events};
    char points[8];
    uint32_t i, size, score = 0;
    int step;
    begin();
    OK(api->set_tag(world, make_box(make_body(-1, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 8, 16, 2, GLASS), "points", "5"));
    OK(api->set_tag(world, make_box(make_body(0, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 8, 16, 2, BRICK), "points", "1"));
    steps(1);
    OK(api->explode(world, &explosion));
    for (step = 0; step < 60; ++step) {
        steps(1);
        OK(api->get_events(world, &events));
        for (i = 0; i < events.removed_count; ++i) /* pieces have the tags of the shape that they came off */
            if (api->get_tag(world, events.removed[i].shape, "points", points, sizeof points, &size) == RUBBLE_OK &&
                size)
                score += (uint32_t)atoi(points) * (uint32_t)events.removed[i].count;
    }
    printf("%u points\n", score);
    require(score > 0, "points");
    OK(api->destroy_world(world));
    return 0;
}
